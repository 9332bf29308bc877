"""Coalitions and times decided together: who does a task, in which order the places are visited, and when."""
