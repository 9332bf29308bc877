"""Alternative to schedule."""

from __future__ import annotations

from missiontree.scheduling.cpsat.engine import auto, cpsat
from missiontree.scheduling.greedy import greedy
from missiontree.scheduling.scheduler import Scheduler

SCHEDULERS: dict[str, Scheduler] = {"greedy": greedy, "cpsat": cpsat, "auto": auto}
"""Every scheduler there is, by name."""
