"""Mission text, fleet and scene to a mission tree, by checked calls only."""
