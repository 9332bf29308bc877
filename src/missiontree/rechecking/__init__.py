"""
Rechecking: the core rules of a plan once more, deliberately plain.

Two checkers that share no line are seldom wrong in the same place. This one is written from the meaning of the rules alone: loops
over leaves and roles, dictionaries, whole milliseconds. It knows nothing but the mission's values.
"""

from missiontree.rechecking.rechecker import CORE_RULES, recheck

__all__ = ["CORE_RULES", "recheck"]
