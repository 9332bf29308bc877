"""Grounded tree to the k best alternatives."""
