"""A schedule as text, in a terminal's width."""
