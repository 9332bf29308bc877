"""Checking: the last word on every plan, by code that shares nothing with the solvers. One rule, one function."""

from missiontree.checking.checker import RULES, check
from missiontree.checking.trust import taken_on_trust

__all__ = ["RULES", "check", "taken_on_trust"]
