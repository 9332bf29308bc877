"""Whether givers and takers of a draft meet, with all that must be done just then."""

from __future__ import annotations

from missiontree.mission.reason import Reason
from missiontree.scheduling.problem import Draft, Problem

RULE = "hand_over_missed"


def apart(problem: Problem, draft: Draft) -> tuple[Reason, ...]:
    """Actions between a giver and its taker that a draft does at another moment than that of the hand-over."""
    hand_overs, graph = problem.hand_overs, problem.graph
    if not hand_overs.between:
        return ()
    start = {graph.activity_of[one.leaf]: one.start for one in draft.done}
    missed = {
        one: taker
        for giver, taker in hand_overs.taker.items()
        for one in hand_overs.between.get(giver, ())
        if start[one] != start[taker]
    }
    return tuple(
        Reason(
            rule=RULE,
            message=f"{graph.name(graph.activities[one][0])!r} must be done just when {graph.name(graph.activities[taker][0])!r} "
            "starts with a hand-over; a try did it before.",
            node=graph.name(graph.activities[one][0]),
            hint="Take it out of the order between the two.",
        )
        for one, taker in missed.items()
    )
