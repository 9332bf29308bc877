"""Places: where robots start, and where entities are as they are carried about."""

from __future__ import annotations

from missiontree.mission.position import Position
from missiontree.rechecking.facts import Facts

NEAR_M = 1e-3


def same_place(one: Position, other: Position) -> bool:
    """Whether two positions, in frame ``map``, are one."""
    near = abs(one.x_m - other.x_m) <= NEAR_M and abs(one.y_m - other.y_m) <= NEAR_M
    return near and one.floor == other.floor and one.frame == other.frame


def start_of(facts: Facts, robot: str) -> Position | None:
    """Where a robot starts; None if unknown."""
    one = facts.brief.fleet.robots[robot]
    if one.position is not None:
        return facts.world.in_map(one.position)
    return _first_of(facts, one.place)


def place_of(facts: Facts, leaf: int) -> Position | None:
    """
    Where an action is done: where the last move that brought its entity went, else where the scene has it. None if unknown.

    Neither the action nor what it is joint with has moved anything when it starts, even if they take no time.
    """
    return _place_of(facts, leaf, frozenset())


def _place_of(facts: Facts, leaf: int, asked: frozenset[int]) -> Position | None:
    """As above; the moves already asked for are not asked again, for instant moves may bring two things to each other."""
    entity, when_ms, asked = facts.leaves[leaf].at, facts.start_ms[leaf], asked.union(facts.together(leaf))
    brought = facts.bringing.get(entity or "", ())
    moves = [move for move in brought if move not in asked and facts.end_ms[move] <= when_ms]
    if moves:
        last = max(moves, key=lambda move: (facts.end_ms[move], facts.start_ms[move], move))
        return _place_of(facts, last, asked)
    return _first_of(facts, entity)


def _first_of(facts: Facts, entity: str | None) -> Position | None:
    known = facts.world.by_id.get(entity) if entity is not None else None
    return None if known is None else facts.world.whereabouts(known).position
