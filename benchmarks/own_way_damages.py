"""Ways to damage what a robot travels for its own sake, to a charger and home, and times and amounts that such ways must keep to."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace
from typing import Any

from missiontree.mission.plan import Plan
from missiontree.mission.position import Position
from missiontree.mission.schedule import Leg, OwnLeg, Schedule
from tests.checking import damages as known
from tests.checking.damages import grounded_tree, moves, refilled, returning, scheduled, schedules, travelled, with_kind


def to_a_charger(plan: Plan) -> Iterator[tuple[int, int, OwnLeg]]:
    """Ways to chargers that take time, each with the numbers of its schedule and its visit."""
    for place, _, number, visit in refilled(plan):
        if visit.leg is not None and visit.leg.end_s - visit.leg.start_s > 0.01 and visit.leg.distance_m > 0.1:
            yield place, number, visit.leg


def with_way(plan: Plan, place: int, number: int, leg: OwnLeg, **changes: Any) -> Plan:
    """The plan with a way to a charger changed."""
    return known.with_visit(plan, place, number, leg=replace(leg, **changes))


def charger_way_shortened(plan: Plan) -> Iterator[Plan]:
    """A way to a charger is said to be shorter than it is, or to have no length."""
    for place, number, leg in to_a_charger(plan):
        yield with_way(plan, place, number, leg, distance_m=0.99 * leg.distance_m)
        yield with_way(plan, place, number, leg, distance_m=0.0)


def charger_way_hurried(plan: Plan) -> Iterator[Plan]:
    """A way to a charger takes half the time."""
    for place, number, leg in to_a_charger(plan):
        if "max_speed_mps" in plan.brief.fleet.type_of[leg.robot].limits:
            yield with_way(plan, place, number, leg, start_s=round((leg.start_s + leg.end_s) / 2, 3))


def charger_way_from_elsewhere(plan: Plan) -> Iterator[Plan]:
    """A way to a charger starts or ends a metre beside."""
    for place, number, leg in to_a_charger(plan):
        yield with_way(plan, place, number, leg, origin=_beside(leg.origin))
        yield with_way(plan, place, number, leg, destination=_beside(leg.destination))


def _beside(where: Position) -> Position:
    return replace(where, x_m=where.x_m + 1)


def charger_way_too_early(plan: Plan) -> Iterator[Plan]:
    """A robot sets out for a charger half a second before it is free, or before the mission starts to count its time."""
    for place, schedule, number, visit in refilled(plan):
        if visit.leg is None:
            continue
        over_s = _free_before(schedule, visit.robot, visit.start_s)
        shift_s = visit.leg.start_s - over_s + 0.5
        if over_s > 1 and visit.leg.end_s - visit.leg.start_s > 0.01:
            start_s, end_s = round(visit.leg.start_s - shift_s, 3), round(visit.leg.end_s - shift_s, 3)
            yield with_way(plan, place, number, visit.leg, start_s=start_s, end_s=end_s)


def _free_before(schedule: Schedule, robot: str, when_s: float) -> float:
    """When a robot ended what it did last before a time."""
    ends = [done.end_s for done in schedule.actions if done.robot == robot and done.end_s <= when_s]
    ends += [one.end_s for one in schedule.recharges if one.robot == robot and one.end_s <= when_s]
    return max(ends, default=0.0)


def home_at_once(plan: Plan) -> Iterator[Plan]:
    """Of two robots that go home through what has room for one, the one that waits does not."""
    world, narrow = plan.brief.world, known.room_for_one(plan)
    for place, schedule, number, leg in returning(plan):
        for other in schedule.returns:
            shared = {*world.passed(leg.via)} & {*world.passed(other.via)} & narrow
            lasts_s = leg.end_s - leg.start_s
            if other.robot == leg.robot or not shared or min(lasts_s, other.end_s - other.start_s) <= 1:
                continue
            yield known.with_return(plan, place, number, start_s=other.start_s, end_s=round(other.start_s + lasts_s, 3))


def charger_and_way_at_once(plan: Plan) -> Iterator[Plan]:
    """A robot is on its way to a charger through what another holds on a way of its own."""
    world, narrow = plan.brief.world, known.room_for_one(plan)
    for place, number, leg in to_a_charger(plan):
        schedule = plan.schedules[place]
        others: list[Leg] = [*schedule.legs, *known.own_legs(schedule)]
        for other in others:
            shared = {*world.passed(leg.via)} & {*world.passed(other.via)} & narrow
            lasts_s = leg.end_s - leg.start_s
            if other.robot != leg.robot and shared and min(lasts_s, other.end_s - other.start_s) > 1:
                end_s = round(other.start_s + lasts_s, 3)
                yield with_way(plan, place, number, leg, start_s=other.start_s, end_s=end_s)


def gone_before_it_is_home(plan: Plan) -> Iterator[Plan]:
    """A robot leaves half a second before it is home."""
    for _, _, _, leg in returning(plan):
        if leg.end_s - leg.start_s > 1:
            yield _there(plan, leg.robot, available_from_s=None, available_until_s=leg.end_s - 0.5)


def come_after_it_set_out(plan: Plan) -> Iterator[Plan]:
    """A robot comes half a second after it sets out for its first action or its first charger."""
    for _, schedule in schedules(plan):
        for robot in sorted({done.robot for done in schedule.actions}):
            ways = [leg.start_s for leg in schedule.ways if leg.robot == robot and leg.end_s - leg.start_s > 1]
            if ways:
                yield _there(plan, robot, available_from_s=min(ways) + 0.5, available_until_s=None)


def _there(plan: Plan, robot: str, **times: float | None) -> Plan:
    kind = plan.brief.fleet.type_of[robot]
    robots = tuple(replace(one, available_from_s=None, available_until_s=None) for one in kind.robots)
    return with_kind(plan, kind.id, robots=robots, **times)


def budget_not_for_the_way_home(plan: Plan) -> Iterator[Plan]:
    """A robot's type has what the robot uses for actions and on its ways to them, and not all that it uses on its way home."""
    for _, schedule, _, leg in returning(plan):
        kind = plan.brief.fleet.type_of[leg.robot]
        for name, per_m in kind.uses_per_m.items():
            home = per_m * leg.distance_m
            if home < 0.1 or name in plan.brief.terms.refilled(kind):
                continue
            limit = known.used(plan, schedule, leg.robot, name) - home / 2
            robots = {"robots": tuple(replace(one, remaining={}) for one in kind.robots)} if kind.robots else {}
            yield with_kind(plan, kind.id, limits={**kind.limits, name: limit}, **robots)


def total_not_for_own_ways(plan: Plan) -> Iterator[Plan]:
    """The mission may use what its robots use for actions and on the ways to them, and not all that own ways take."""
    for _, schedule in schedules(plan):
        robots = sorted({done.robot for done in schedule.actions})
        for name in sorted({name for kind in plan.brief.fleet.types for name in kind.uses_per_m}):
            own = math.fsum(
                leg.distance_m * plan.brief.fleet.type_of[leg.robot].uses_per_m.get(name, 0.0)
                for leg in known.own_legs(schedule)
            )
            if own > 0.1:
                total = math.fsum(known.used(plan, schedule, robot, name) for robot in robots)
                fleet = replace(plan.brief.fleet, total_limits={name: total - own / 2})
                yield known.with_brief(plan, fleet=fleet)


def refilled_within_a_role(plan: Plan) -> Iterator[Plan]:
    """A visit to a charger lies between the first and the last action of a role, whatever the rest of it says."""
    tree = grounded_tree(plan)
    for place, schedule, number, visit in refilled(plan):
        lasts_s = visit.end_s - visit.start_s
        for role in sorted({tree.action(done.leaf).role for done in schedule.actions if done.robot == visit.robot}):
            own = [done for done in schedule.actions if tree.action(done.leaf).role == role]
            start_s = min(done.start_s for done in own)
            if max(done.end_s for done in own) - start_s > 1 and lasts_s > 1:
                end_s = round(start_s + lasts_s, 3)
                yield known.with_visit(plan, place, number, start_s=start_s, end_s=end_s, leg=None)


def leg_backwards(plan: Plan) -> Iterator[Plan]:
    """A leg to an action ends a second before it starts."""
    for place, _, number, leg in travelled(plan):
        if leg.end_s > 1 and not moves(plan, leg.leaf):
            yield known.with_leg(plan, place, number, start_s=leg.end_s, end_s=round(leg.end_s - 1, 3))


def refilled_twice_at_once(plan: Plan) -> Iterator[Plan]:
    """A visit to a charger is listed twice."""
    for place, schedule, _, visit in refilled(plan):
        if visit.end_s - visit.start_s > 0.01:
            yield known.with_schedule(plan, place, recharges=(*schedule.recharges, visit))


def tasks_due_earlier(plan: Plan) -> Iterator[Plan]:
    """A node above an action is due before that action ends."""
    nodes = grounded_tree(plan).nodes
    for _, _, _, done in scheduled(plan):
        node = nodes[done.leaf].parent
        if done.end_s > 1 and node >= 0:
            due = replace(nodes[node], release_s=0.0, deadline_s=done.end_s - 0.5)
            yield known.with_grounded(plan, nodes=(*nodes[:node], due, *nodes[node + 1 :]))


def tasks_released_later(plan: Plan) -> Iterator[Plan]:
    """A node above an action is released after that action starts."""
    nodes = grounded_tree(plan).nodes
    for _, _, _, done in scheduled(plan):
        node = nodes[done.leaf].parent
        if node >= 0:
            later = replace(nodes[node], release_s=done.start_s + 0.5, deadline_s=None)
            yield known.with_grounded(plan, nodes=(*nodes[:node], later, *nodes[node + 1 :]))
