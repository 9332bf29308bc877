"""Who does what, when and after what, in words."""

from __future__ import annotations

from collections import defaultdict
from dataclasses import dataclass

from missiontree.mission.alternative import Alternative
from missiontree.mission.grounded import GroundedTree
from missiontree.mission.plan import Plan
from missiontree.mission.schedule import Schedule
from missiontree.reporting.html.job_words import Job, JobWords
from missiontree.reporting.html.times import at, between
from missiontree.reporting.palette import liveries

MOST_MEMBERS = 48
MANY_JOBS = 24
FEW = 2


@dataclass(frozen=True, slots=True)
class Member:
    """
    A robot, or a robot type that no robot is named for, and what it does.

    Parameters
    ----------
    name, kind
        Id of the robot and label of its type; the name is empty if only the type is known.
    hue
        Number of its colour; -1 if only the type is known.
    jobs
        In the order in which they start.
    more
        How many jobs are not listed, and until when they last; empty if all are.
    """

    name: str
    kind: str
    hue: int
    jobs: tuple[Job, ...]
    more: str = ""


@dataclass(frozen=True, slots=True)
class Crew:
    """
    Everybody who does something, and who is not needed.

    Parameters
    ----------
    members
        Robots in the order in which they begin, of those that begin together in that of the fleet, as in the chart; without a schedule,
        robot types in the order of the tree.
    left_out
        How many of them are not listed.
    idle
        Robots that the alternative does without; empty if it has no schedule.
    """

    members: tuple[Member, ...]
    left_out: int
    idle: tuple[str, ...]


def crew(plan: Plan, alternative: Alternative, schedule: Schedule | None) -> Crew:
    """Tell who does what. Of many jobs, only the first two of each robot are told; the chart has them all."""
    words = JobWords(plan)
    few = len(alternative.roles) > MANY_JOBS
    if schedule is None or not schedule.actions:
        members = _types(plan, alternative, words, few)
        return Crew(tuple(members[:MOST_MEMBERS]), max(0, len(members) - MOST_MEMBERS), ())
    assert plan.grounding is not None
    spans = _spans(plan.grounding.tree, schedule)
    held: dict[str, list[tuple[float, float, int]]] = defaultdict(list)
    for assignment in schedule.assignments:
        held[assignment.robot].append((*spans.get(assignment.role, (0.0, 0.0)), assignment.role))
    hues, kinds = liveries(plan.brief.fleet), plan.brief.fleet.type_of
    places = {robot: place for place, robot in enumerate(plan.brief.fleet.robots)}
    order = sorted(held, key=lambda robot: (min(held[robot])[0], places.get(robot, len(places)), robot))
    members = []
    for robot in order[:MOST_MEMBERS]:
        roles = sorted(held[robot])
        told = roles[:FEW] if few else roles
        jobs = [words.job(role, between(start, end, schedule.makespan_s)) for start, end, role in told]
        rest, last = len(roles) - len(told), max(end for _, end, _ in roles)
        members.append(
            Member(
                robot,
                kinds[robot].label if robot in kinds else "",
                hues[robot].number if robot in hues else -1,
                tuple(jobs),
                f"and {rest} more until {at(last, schedule.makespan_s)}" if rest else "",
            )
        )
    idle = tuple(robot for robot in plan.brief.fleet.robots if robot not in held)
    return Crew(tuple(members), max(0, len(order) - MOST_MEMBERS), idle)


def _types(plan: Plan, alternative: Alternative, words: JobWords, few: bool) -> list[Member]:
    types = plan.brief.fleet.by_id
    jobs: dict[str, list[Job]] = defaultdict(list)
    for filled in alternative.roles:
        jobs[filled.robot_type].append(words.job(filled.role))
    found = []
    for name, own in jobs.items():
        told = own[:FEW] if few else own
        rest = f"and {len(own) - len(told)} more" if len(told) < len(own) else ""
        found.append(Member("", types[name].label if name in types else name, -1, tuple(told), rest))
    return found


def _spans(tree: GroundedTree, schedule: Schedule) -> dict[int, tuple[float, float]]:
    """From when to when each role works."""
    spans: dict[int, tuple[float, float]] = {}
    for entry in schedule.actions:
        role = tree.action(entry.leaf).role
        low, high = spans.get(role, (entry.start_s, entry.end_s))
        spans[role] = (min(low, entry.start_s), max(high, entry.end_s))
    return spans
