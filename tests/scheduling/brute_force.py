"""The least makespan of tiny instances, by trying every binding and every order of roles per robot. The oracle of the scheduler."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from itertools import permutations, product

from missiontree.mission.alternative import selected_leaves, selected_nodes
from missiontree.mission.fleet import Fleet
from missiontree.mission.grounded import Action
from missiontree.mission.position import Position
from missiontree.mission.scene import Scene
from missiontree.mission.terms import NO_TERMS, Terms
from tests.scheduling.instances import Instance


def least_makespan(instance: Instance, fleet: Fleet, world: Scene, terms: Terms = NO_TERMS) -> int | None:
    """Least makespan in milliseconds; None if nothing works. Entities must not be moved, and there must be no budgets."""
    tree = instance.tree
    leaves = selected_leaves(tree, instance.alternative.choices)
    roles: dict[int, list[int]] = {}
    for leaf in leaves:
        roles.setdefault(tree.action(leaf).role, []).append(leaf)
    names = sorted(roles)
    types = [tree.action(roles[role][0]).robot_type for role in names]
    best: int | None = None
    for robots in product(*([robot.id for robot in fleet.by_id[kind].members] for kind in types)):
        binding = dict(zip(names, robots, strict=True))
        if not _staffed(instance, binding) or not keeps_terms(set(robots), fleet, terms):
            continue
        for sequence in _sequences(binding):
            ends = _ends(instance, fleet, world, leaves, roles, sequence)
            if ends is not None and (best is None or ends < best):
                best = ends
    return best


def keeps_terms(busy: set[str], fleet: Fleet, terms: Terms) -> bool:
    """Whether these robots at work are all who must be, none who may not, and no more than may be."""
    if busy & set(terms.without) or not set(terms.require) <= busy | {fleet.type_of[robot].id for robot in busy}:
        return False
    return all(
        kind.max_in_use is None or sum(robot.id in busy for robot in kind.members) <= kind.max_in_use
        for kind in fleet.types
    )


def _under(instance: Instance, leaves: Sequence[int], node: int) -> list[int]:
    found = []
    for leaf in leaves:
        above = leaf
        while above not in (node, -1):
            above = instance.tree.nodes[above].parent
        if above == node:
            found.append(leaf)
    return found


def _binding_links(instance: Instance) -> Iterator[tuple[str, list[int], list[int]]]:
    choices = instance.alternative.choices
    selected, leaves = set(selected_nodes(instance.tree, choices)), selected_leaves(instance.tree, choices)
    for link in instance.tree.links:
        if link.first in selected and link.second in selected:
            first, second = _under(instance, leaves, link.first), _under(instance, leaves, link.second)
            if first and second:
                yield link.kind, first, second


def _staffed(instance: Instance, binding: dict[int, str]) -> bool:
    tree = instance.tree
    teams = [(tree.roles[role].team, robot) for role, robot in binding.items() if tree.roles[role].team is not None]
    if len(set(teams)) < len(teams):
        return False
    joint: set[tuple[int, str]] = set()
    for leaf in selected_leaves(tree, instance.alternative.choices):
        action = tree.action(leaf)
        if action.sync is not None:
            if (action.sync, binding[action.role]) in joint:
                return False
            joint.add((action.sync, binding[action.role]))
    for kind, first, second in _binding_links(instance):
        who = [{binding[tree.action(leaf).role] for leaf in side} for side in (first, second)]
        if kind == "same_robot" and len(who[0] | who[1]) > 1:
            return False
        if kind == "different_robot" and who[0] & who[1]:
            return False
    return True


def _sequences(binding: dict[int, str]) -> Iterator[dict[str, tuple[int, ...]]]:
    of: dict[str, list[int]] = {}
    for role, robot in binding.items():
        of.setdefault(robot, []).append(role)
    for orders in product(*(permutations(roles) for roles in of.values())):
        yield dict(zip(of, orders, strict=True))


def _ends(
    instance: Instance,
    fleet: Fleet,
    world: Scene,
    leaves: Sequence[int],
    roles: dict[int, list[int]],
    sequence: dict[str, tuple[int, ...]],
) -> int | None:
    """Makespan if every action starts as early as this order of roles allows; None if the order contradicts the links."""
    action = {leaf: instance.tree.action(leaf) for leaf in leaves}
    before: list[tuple[int, int, int]] = []  # (leaf that ends, leaf that starts, milliseconds of travel between)
    release, duration = dict.fromkeys(leaves, 0), {}
    for robot, order in sequence.items():
        spot, last = fleet.robots[robot].position, None
        there = math.ceil(fleet.type_of[robot].availability(fleet.robots[robot])[0] * 1000 - 1e-6)
        for leaf in (leaf for role in order for leaf in roles[role]):
            goal, way = _goal(action[leaf], world), 0
            if action[leaf].moves:
                duration[leaf] = _way(fleet, action[leaf], spot, goal, action[leaf].duration_s)
                spot = goal
            else:
                duration[leaf] = math.ceil(action[leaf].duration_s * 1000 - 1e-6)
                if action[leaf].at is not None:
                    way = _way(fleet, action[leaf], spot, goal, 0.0)
                    spot = goal
            release[leaf] = max(release[leaf], there + way) if last is None else release[leaf]
            if last is not None:
                before.append((last, leaf, way))
            last = leaf
    who = {leaf: robot for robot, order in sequence.items() for role in order for leaf in roles[role]}
    due = _due(instance, fleet, who, release)
    until: dict[int, list[int]] = {}
    for kind, first, second in _binding_links(instance):
        before += [(a, b, 0) for a in first for b in second] if kind == "precedence" else []
        for leaf in first if kind == "until" else ():
            if action[leaf].open_ended:
                until.setdefault(leaf, []).extend(second)
    joint = {leaf: [other for other in leaves if _together(action[leaf], action[other])] or [leaf] for leaf in leaves}
    fixed = {leaf: [end for end in _ends_of(leaf, until) if end not in until] for leaf in until}
    found: list[int] = []
    for latest in product(*fixed.values()):  # for each open-ended action, who ends after its start
        under_way = list(zip(fixed, latest, strict=True))
        ends = _earliest(leaves, before, release, duration, until, joint, under_way)
        if ends is not None and all(ends[leaf] <= last_tick for leaf, last_tick in due.items()):
            found.append(max(ends.values()))
    return min(found, default=None)


def _due(instance: Instance, fleet: Fleet, who: dict[int, str], release: dict[int, int]) -> dict[int, int]:
    """Deadlines by leaf, of nodes and of robots that leave; release times are put into ``release``."""
    due: dict[int, int] = {}
    for leaf, robot in who.items():
        if (until_s := fleet.type_of[robot].availability(fleet.robots[robot])[1]) is not None:
            due[leaf] = math.floor(until_s * 1000 + 1e-6)
    for node, timed in enumerate(instance.tree.nodes):
        for leaf in _under(instance, list(who), node) if timed.release_s or timed.deadline_s is not None else ():
            release[leaf] = max(release[leaf], math.ceil(timed.release_s * 1000 - 1e-6))
            if timed.deadline_s is not None:
                due[leaf] = min(due.get(leaf, 1 << 60), math.floor(timed.deadline_s * 1000 + 1e-6))
    return due


def _ends_of(leaf: int, until: dict[int, list[int]]) -> set[int]:
    seen, stack = {leaf}, [leaf]
    while stack:
        fresh = set(until.get(stack.pop(), [])) - seen
        seen |= fresh
        stack += fresh
    return seen


def _earliest(
    leaves: Sequence[int],
    before: list[tuple[int, int, int]],
    release: dict[int, int],
    duration: dict[int, int],
    until: dict[int, list[int]],
    joint: dict[int, list[int]],
    under_way: list[tuple[int, int]],
) -> dict[int, int] | None:
    start = dict(release)
    end = {leaf: start[leaf] for leaf in leaves}
    for _ in range(8 * len(leaves) + 8):
        old = dict(start), dict(end)
        for first, second, way in before:
            start[second] = max(start[second], end[first] + way)
        for open_ended, last in under_way:
            length = max(duration[other] for other in joint[last])
            start[last] = max(start[last], start[open_ended] + 1 - length)
        for leaf in leaves:
            start[leaf] = max(start[other] for other in joint[leaf])
            if leaf in until:
                end[leaf] = max([end[leaf], start[leaf], *(end[other] for other in until[leaf])])
            else:
                end[leaf] = max(end[leaf], start[leaf] + max(duration[other] for other in joint[leaf]))
        if (start, end) == old:
            return end
    return None


def _together(one: Action, other: Action) -> bool:
    return one.sync is not None and one.sync == other.sync


def _goal(action: Action, world: Scene) -> Position | None:
    return None if action.at is None else world.by_id[action.at].position


def _way(fleet: Fleet, action: Action, spot: Position | None, goal: Position | None, nominal_s: float) -> int:
    speed = fleet.by_id[action.robot_type].limits.get("max_speed_mps")
    if spot is None or goal is None or speed is None:
        return math.ceil(nominal_s * 1000 - 1e-6)
    return math.ceil(math.hypot(goal.x_m - spot.x_m, goal.y_m - spot.y_m) / speed * 1000 - 1e-6)
