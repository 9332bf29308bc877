"""Routines as data, and the expansion of a mission tree over a fleet and a scene."""
