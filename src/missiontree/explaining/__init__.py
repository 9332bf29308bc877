"""Why a mission cannot be done, and what would make it possible: the planner is asked again with one thing changed."""
