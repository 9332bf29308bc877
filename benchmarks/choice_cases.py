"""
Random missions with a choice, small enough for all alternatives to be written out and scheduled by trying everything.

A case of :mod:`schedule_cases` has no choice; here some of its roles get a second way, by another type, quicker or better.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from itertools import product
from random import Random

from benchmarks.schedule_cases import ScheduleCase, random_schedule_case
from benchmarks.schedule_oracle import least_makespan
from missiontree.mission.brief import MissionBrief
from missiontree.mission.estimate import Estimate, Weights
from missiontree.mission.grounded import Action, GroundedLink, GroundedNode, GroundedTree, Role
from missiontree.mission.routine import RoutineLibrary

QUALITIES = (0.3, 0.5, 0.8, 1.0)


@dataclass(frozen=True, slots=True)
class ChoiceCase:
    """A mission with a choice, and the case without one that it was made from."""

    tree: GroundedTree
    brief: MissionBrief
    plain: ScheduleCase


def random_choice_case(rng: Random) -> ChoiceCase:
    """Draw a case: one to three of its roles can be filled in two ways."""
    plain = random_schedule_case(rng)
    while "chargers" in plain.features:  # of which the oracle does not know the least makespan
        plain = random_schedule_case(rng)
    tree = _with_choices(plain.tree, rng, [kind.id for kind in plain.fleet.types])
    brief = MissionBrief(
        text="test",
        fleet=plain.fleet,
        routines=RoutineLibrary(routines=()),
        scene=replace(plain.scene, stock=plain.terms.stock),
        require=plain.terms.require,
        return_home=plain.terms.return_home,
        deadline_s=plain.terms.home_by_s,
        weights=Weights(1.0, rng.choice((0.01, 0.1, 0.3)), rng.choice((0.0, 0.05))),
    )
    return ChoiceCase(tree, brief, plain)


def _with_choices(tree: GroundedTree, rng: Random, types: list[str]) -> GroundedTree:
    tops = [index for index, node in enumerate(tree.nodes) if node.kind == "and" and _role_of(tree, index) is not None]
    doubled = set(rng.sample(tops, min(len(tops), rng.randint(1, 3))))
    nodes: list[GroundedNode] = []
    roles = list(tree.roles)
    now: dict[int, int] = {-1: -1}
    inside: dict[int, int] = {}
    for index, node in enumerate(tree.nodes):
        if node.kind == "action":
            continue
        now[index] = inside[index] = len(nodes)
        if index in doubled:
            xor = GroundedNode(
                parent=inside[node.parent],
                kind="xor",
                label=f"x{index}",
                release_s=node.release_s,
                deadline_s=node.deadline_s,
            )
            nodes.append(xor)
        ways = 2 if index in doubled else 1
        for way in range(ways):
            parent = now[index] if index in doubled else inside.get(node.parent, -1)
            place = len(nodes)
            times = {"release_s": 0.0, "deadline_s": None} if index in doubled else {}
            nodes.append(replace(node, parent=parent, **times))  # type: ignore[arg-type]
            inside[index] = place
            role = _role_of(tree, index)
            if role is None:
                continue
            if way:
                roles.append(Role(label=f"{roles[role].label}'", team=roles[role].team))
            quality, kind, haste = rng.choice(QUALITIES), rng.choice(types), rng.choice((0.4, 1.0, 2.0))
            for leaf in tree.children[index]:
                action = tree.action(leaf)
                if not way:
                    now[leaf] = len(nodes)
                nodes.append(
                    replace(
                        tree.nodes[leaf],
                        parent=place,
                        action=_other(action, quality, kind, haste, len(roles) - 1)
                        if way
                        else replace(action, estimate=Estimate(quality, action.duration_s, 1.0)),
                    )
                )
    links = tuple(GroundedLink(now[link.first], now[link.second], link.kind) for link in tree.links)
    return GroundedTree(objective=tree.objective, nodes=tuple(nodes), roles=tuple(roles), links=links)


def _role_of(tree: GroundedTree, index: int) -> int | None:
    below = tree.children[index]
    actions = [tree.nodes[child].action for child in below]
    return actions[0].role if actions and all(actions) and actions[0] is not None else None


def _other(action: Action, quality: float, kind: str, haste: float, role: int) -> Action:
    duration_s = action.duration_s * haste
    estimate = Estimate(quality, duration_s, 2.0)
    return replace(action, role=role, robot_type=kind, estimate=estimate, duration_s=duration_s)


@dataclass(frozen=True, slots=True)
class Written:
    """An alternative written out: the child taken at each XOR, utility and timeless worth in millionths, least makespan in ticks."""

    taken: tuple[tuple[int, int], ...]
    utility: int
    timeless: int
    makespan: int


def all_written(case: ChoiceCase) -> Iterator[Written]:
    """
    Every alternative that has a schedule.

    Raises
    ------
    TooMuchError
        If one of them takes too long to be tried out.
    """
    tree, weights = case.tree, case.brief.weights
    timeless = Weights(weights.alpha, 0.0, weights.gamma)
    xors = [index for index, node in enumerate(tree.nodes) if node.kind == "xor"]
    for children in product(*(tree.children[xor] for xor in xors)):
        taken = dict(zip(xors, children, strict=True))
        kept = _selected(tree, taken)
        part = _part(tree, kept)
        estimates = [node.action.estimate for node in part.nodes if node.action is not None]
        least = least_makespan(replace(case.plain, tree=part))
        if least is not None:
            yield Written(
                tuple(taken.items()),
                sum(map(weights.utility_micro, estimates)),
                sum(map(timeless.utility_micro, estimates)),
                least,
            )


def _selected(tree: GroundedTree, taken: dict[int, int]) -> list[int]:
    kept, stack = [], [0]
    while stack:
        node = stack.pop()
        kept.append(node)
        stack += [taken[node]] if node in taken else tree.children[node]
    return sorted(kept)


def _part(tree: GroundedTree, kept: list[int]) -> GroundedTree:
    """What is selected, as a tree without a choice."""
    now = {-1: -1} | {index: place for place, index in enumerate(kept)}
    nodes = [tree.nodes[index] for index in kept]
    nodes = [replace(node, parent=now[node.parent], kind="and" if node.kind == "xor" else node.kind) for node in nodes]
    links = [
        GroundedLink(now[link.first], now[link.second], link.kind)
        for link in tree.links
        if link.first in now and link.second in now
    ]
    return GroundedTree(objective=tree.objective, nodes=tuple(nodes), roles=tree.roles, links=tuple(links))
