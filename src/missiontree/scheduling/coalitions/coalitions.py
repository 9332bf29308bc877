"""The road of this package: walks through the layers, narrow ones first, until the best is proven or time is up."""

from __future__ import annotations

from missiontree.mission.certificate import Certificate
from missiontree.mission.coalitions import TICKS_PER_S, CoalitionMission, CoalitionSchedule, Visit
from missiontree.mission.control import Control, Progress
from missiontree.scheduling.coalitions.bounds import in_order, outlook_of
from missiontree.scheduling.coalitions.labels import Label, search

WIDTHS = (20, 400, 8_000, 200_000)
ENDLESS = 1 << 60


def schedule_coalitions(mission: CoalitionMission, control: Control) -> CoalitionSchedule:
    """
    Coalitions, routes and times of least makespan, the way to the end included.

    Parameters
    ----------
    mission
        The mission.
    control
        Its limit ends the search; without one it goes on until the widest layers were walked through.
    """
    for task, members in enumerate(mission.coalitions):
        if not members:
            return _impossible("coverage", f"All robots together lack a skill that task {task + 1} needs.")
    if len(in_order(mission)) < len(mission.tasks):
        return _impossible("precedence", "The precedence runs in a circle.")
    outlook = outlook_of(mission)
    robots, tasks = len(mission.skills), len(mission.tasks)
    bound = outlook.bound(0, (tasks,) * robots, (0,) * robots, (0,) * tasks)
    best: Label | None = None
    makespan, upper = ENDLESS, ENDLESS
    for width in WIDTHS:
        ended = (lambda: False) if best is None else control.ended  # the first walk is short, and gives an answer
        found = search(mission, outlook, upper, width, ended)
        if not found.finished:
            break
        if found.best is not None:
            best, makespan = found.best, found.makespan
            upper = makespan
        bound = max(bound, min(found.bound, makespan))
        shown = None if best is None else makespan / TICKS_PER_S
        control.report(Progress("scheduling", 0, int(best is not None), bound / TICKS_PER_S, shown))
        if bound >= makespan or control.ended():
            break
    assert best is not None  # the first walk always comes to its end with a schedule
    return _told(mission, best, makespan, bound)


def _impossible(method: str, detail: str) -> CoalitionSchedule:
    return CoalitionSchedule(status="infeasible", certificate=Certificate(claim="proven", method=method, detail=detail))


def _told(mission: CoalitionMission, best: Label, makespan: int, bound: int) -> CoalitionSchedule:
    visits: list[Visit] = []
    label: Label | None = best
    while label is not None and label.task >= 0:
        over = label.began + mission.lengths[label.task]
        visits.append(
            Visit(task=label.task, robots=label.members, start_s=label.began / TICKS_PER_S, end_s=over / TICKS_PER_S)
        )
        label = label.before
    end = len(mission.tasks) + 1
    arrivals = tuple(
        (free + mission.travel[place][end]) / TICKS_PER_S for place, free in zip(best.places, best.free, strict=True)
    )
    optimal = bound >= makespan
    detail = (
        "Every other beginning is outdone, or cannot end earlier."
        if optimal
        else "No beginning that was left out ends earlier."
    )
    return CoalitionSchedule(
        status="optimal" if optimal else "feasible",
        certificate=Certificate(
            claim="proven" if optimal else "bounded", method="labels", bound=bound / TICKS_PER_S, detail=detail
        ),
        visits=tuple(sorted(visits, key=lambda visit: (visit.start_s, visit.task))),
        arrivals_s=arrivals,
        makespan_s=makespan / TICKS_PER_S,
    )
