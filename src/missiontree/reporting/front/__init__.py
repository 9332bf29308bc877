"""The utility-makespan front, and what an objective chose: as rows, in a terminal, and as a picture."""
