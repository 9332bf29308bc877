"""missiontree."""
