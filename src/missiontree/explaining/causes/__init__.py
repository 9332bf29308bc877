"""What stands in the way of a mission, stage by stage: one file for each stage."""
