"""What people call what is shown of a plan."""

from __future__ import annotations

from missiontree.mission.as_ranking import is_option
from missiontree.mission.plan import Plan


def called(plan: Plan, rank: int) -> str:
    """``alternative 2``; or ``the option``, for one of a front, and what is chosen, has no rank among all alternatives."""
    alternatives = plan.ranking.alternatives if plan.ranking is not None else ()
    shown = next((one for one in alternatives if one.rank == rank), None)
    return "the option" if shown is not None and is_option(shown) else f"alternative {rank}"
