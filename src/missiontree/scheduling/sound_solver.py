"""
Parts of the solver that give wrong answers, switched off.

Both cut off feasible optima in version 9.15 and let worse answers be called optimal; models of ours that show it are in
``tests/scheduling/cpsat/test_trap.py``.
"""

from __future__ import annotations

from collections.abc import Mapping

SOUND: Mapping[str, int | bool] = {
    "auto_detect_greater_than_at_least_one_of": False,  # a propagator
    "presolve_inclusion_work_limit": 0,  # a part of presolve; google/or-tools, issue 5293
}
"""Parameters of CP-SAT, by name."""
