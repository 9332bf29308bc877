"""Routines and their grounding: (mission tree, fleet, scene) to actions of robot types. The built-in routines are data in library/."""
