"""Times: every action once and as long as it takes, roles in order, robots held, links kept, joint work together."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterator
from itertools import pairwise

from missiontree.mission.reason import Reason
from missiontree.mission.schedule import Leg, Recharge, ScheduledAction
from missiontree.rechecking.facts import TICK_MS, Facts, broken, milliseconds

GRAIN = 1e-3  # of a millisecond; what a number of seconds loses in binary is far less


def every_action_once(facts: Facts) -> Iterator[Reason]:
    """Every selected action is scheduled once, and nothing else is."""
    told = Counter(one.leaf for one in facts.schedule.actions) if facts.schedule is not None else Counter()
    for leaf in facts.leaves:
        if told[leaf] != 1:
            message = f"{facts.label(leaf)} is scheduled {told[leaf]} times; it is to be done once."
            yield broken("core_actions", message, node=leaf)
    for leaf in told:
        if leaf not in facts.leaves:
            yield broken("core_actions", f"action {leaf} is scheduled and is not selected.", node=leaf)


def on_the_grid(facts: Facts) -> Iterator[Reason]:
    """Times are whole milliseconds."""
    if facts.schedule is None:
        return
    timed: list[ScheduledAction | Leg | Recharge] = [
        *facts.schedule.actions,
        *facts.schedule.ways,
        *facts.schedule.recharges,
    ]
    for one in timed:
        for time_s in (one.start_s, one.end_s):
            if abs(time_s * 1000 - round(time_s * 1000)) > GRAIN:
                yield broken("core_grid", f"{time_s} s is no whole number of milliseconds.", robot=one.robot)


def durations(facts: Facts) -> Iterator[Reason]:
    """
    An action lasts as long as its type takes for it, rounded up to a tick.

    Joint actions last as long as the longest of them. Moves last as long as their travel and are looked at there; so does joint
    work that has a move in it. An open-ended action may last until another node ends.
    """
    lasting = {leaf for link in facts.links("until") for leaf in facts.below(link.first)}
    for leaf, action in facts.leaves.items():
        together = [facts.leaves[one] for one in facts.together(leaf)]
        if any(one.moves for one in together) or (action.open_ended and leaf in lasting):
            continue
        needed = max(_up(one.duration_s) for one in together)
        lasts = facts.end_ms[leaf] - facts.start_ms[leaf]
        if abs(lasts - needed) > TICK_MS:
            message = f"{facts.label(leaf)} lasts {lasts / 1000} s, and takes {needed / 1000} s."
            yield broken("core_duration", message, node=leaf)


def _up(seconds: float) -> int:
    return math.ceil(round(seconds * 1000, 6))


def actions_in_order(facts: Facts) -> Iterator[Reason]:
    """The actions of a role run one after the other."""
    for role, leaves in facts.leaves_of_role.items():
        for earlier, later in pairwise(leaves):
            if facts.end_ms[earlier] > facts.start_ms[later] + TICK_MS:
                message = f"{facts.label(later)} starts before {facts.label(earlier)} of the same role has ended."
                yield broken("core_order", message, node=later, robot=facts.robot_of_role.get(role, ""))


def one_role_at_a_time(facts: Facts) -> Iterator[Reason]:
    """A robot is held from the first to the last action of a role, and takes no other role in between."""
    for robot, roles in facts.roles_of_robot.items():
        held = {role: facts.hold_of(role) for role in roles}
        for one, (start, end) in held.items():
            for other, (again, until) in held.items():
                if one < other and start + TICK_MS < until and again + TICK_MS < end:
                    message = f"{robot} is held by roles {one} and {other} at the same time."
                    yield broken("core_holding", message, node=facts.leaves_of_role[other][0], robot=robot)


def precedence(facts: Facts) -> Iterator[Reason]:
    """The first node of a precedence ends before the second starts."""
    for link in facts.links("precedence"):
        end = max(facts.end_ms[leaf] for leaf in facts.below(link.first))
        start = min(facts.start_ms[leaf] for leaf in facts.below(link.second))
        if end > start + TICK_MS:
            message = (
                f"{facts.label(link.first)} ends at {end / 1000} s; {facts.label(link.second)} comes after it "
                f"and starts at {start / 1000} s."
            )
            yield broken("core_precedence", message, node=link.second)


def hand_overs(facts: Facts) -> Iterator[Reason]:
    """
    The last action below the first node of a hand-over ends when the first action below the second starts.

    There the taker is where the giver is: at the place of the giver's last action that has one, or at something brought there.
    """
    for link in facts.links("hand_over"):
        last = max(facts.below(link.first), key=lambda leaf: (facts.end_ms[leaf], leaf))
        first = min(facts.below(link.second), key=lambda leaf: (facts.start_ms[leaf], leaf))
        if abs(facts.end_ms[last] - facts.start_ms[first]) > TICK_MS:
            message = (
                f"{facts.label(last)} ends at {facts.end_ms[last] / 1000} s and is to be followed at once by "
                f"{facts.label(first)}, which starts at {facts.start_ms[first] / 1000} s."
            )
            yield broken("core_hand_over", message, node=first)
        taken, there = facts.leaves[first], set[str | None]()
        for leaf in facts.leaves_of_role[facts.leaves[last].role]:
            action = facts.leaves[leaf]
            if action.moves or (action.at is not None and action.at not in there):
                there = {action.at, *action.brings}
        if taken.at is None or taken.at not in there:
            message = f"{facts.label(first)} takes over from {facts.label(last)}, and is not done where that ends."
            yield broken("core_hand_over", message, node=first)


def until(facts: Facts) -> Iterator[Reason]:
    """The open-ended actions of the first node of an until last until the second ends: all of those that they last until."""
    ends: dict[int, int] = {}
    for link in facts.links("until"):
        end = max(facts.end_ms[leaf] for leaf in facts.below(link.second))
        for leaf in facts.below(link.first):
            if facts.leaves[leaf].open_ended:
                ends[leaf] = max(end, ends.get(leaf, 0))
    for leaf, end in ends.items():
        if abs(facts.end_ms[leaf] - end) > TICK_MS or facts.start_ms[leaf] >= end:
            message = (
                f"{facts.label(leaf)} lasts from {facts.start_ms[leaf] / 1000} s to {facts.end_ms[leaf] / 1000} s, "
                f"and is to be under way until {end / 1000} s."
            )
            yield broken("core_until", message, node=leaf)


def joint_work(facts: Facts) -> Iterator[Reason]:
    """Joint actions share one start and one end."""
    for leaves in facts.joint.values():
        first = leaves[0]
        for leaf in leaves:
            starts = abs(facts.start_ms[leaf] - facts.start_ms[first])
            ends = abs(facts.end_ms[leaf] - facts.end_ms[first])
            if max(starts, ends) > TICK_MS:
                message = (
                    f"{facts.label(leaf)} and {facts.label(first)} are joint work, and do not start and end together."
                )
                yield broken("core_joint", message, node=leaf)


def makespan(facts: Facts) -> Iterator[Reason]:
    """The makespan is the latest end: of an action, or of a way home."""
    if facts.schedule is None:
        return
    home = [milliseconds(leg.end_s) for leg in facts.schedule.returns]
    latest = max([*facts.end_ms.values(), *home], default=0)
    if milliseconds(facts.schedule.makespan_s) != latest:
        message = f"the makespan is {facts.schedule.makespan_s} s, and what is last ends at {latest / 1000} s."
        yield broken("core_makespan", message)


TIME_RULES = (
    on_the_grid,
    durations,
    actions_in_order,
    one_role_at_a_time,
    precedence,
    hand_overs,
    until,
    joint_work,
    makespan,
)
