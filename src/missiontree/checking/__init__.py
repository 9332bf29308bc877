"""Checking: the last word on every plan, by code that shares nothing with the solvers. One rule, one function."""

from missiontree.checking.checker import RULES, check

__all__ = ["RULES", "check"]
