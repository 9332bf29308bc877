"""Places: where robots start, and where entities are as they are carried about."""

from __future__ import annotations

from collections.abc import Iterable

from missiontree.mission.position import Position
from missiontree.rechecking.facts import Facts, Places

NEAR_M = 1e-3


def same_place(one: Position, other: Position) -> bool:
    """Whether two positions, in frame ``map``, are one."""
    near = abs(one.x_m - other.x_m) <= NEAR_M and abs(one.y_m - other.y_m) <= NEAR_M
    return near and one.floor == other.floor and one.frame == other.frame


def may_be_at(places: Iterable[Position | None], where: Position) -> bool:
    """Whether one of some places is a position, as far as they are known."""
    return any(place is not None and same_place(place, where) for place in places)


def apart(here: Iterable[Position | None], there: Iterable[Position | None]) -> bool:
    """Whether two places are known and differ, wherever they may be."""
    known = list(there)
    return not any(one is None or other is None or same_place(one, other) for one in here for other in known)


def start_of(facts: Facts, robot: str) -> Position | None:
    """Where a robot starts; None if unknown."""
    one = facts.brief.fleet.robots[robot]
    if one.position is not None:
        return facts.world.in_map(one.position)
    return _first_of(facts, one.place)


def places_of(facts: Facts, leaf: int) -> Places:
    """
    Where an action may be done: where the last move that brought its entity went, else where the scene has it. None if unknown.

    Neither the action nor what it is joint with has moved anything when it starts, even if they take no time. More than one place is
    told only where the entity is moved in no time at the moment of the action or of another move of it: what comes first is not said.
    """
    if leaf in facts.places:
        return facts.places[leaf]
    found: dict[Position | None, None] = {}
    waiting, asked = [leaf], {leaf}
    while waiting:
        one = waiting.pop()
        moves, sure = _last_moves(facts, one)
        waiting += [move for move in moves if move not in asked]
        asked.update(moves)
        if not sure:
            found[_first_of(facts, facts.leaves[one].at)] = None
    return facts.places.setdefault(leaf, tuple(found))


def _last_moves(facts: Facts, leaf: int) -> tuple[list[int], bool]:
    """The moves that may have brought an action's entity to where it is when the action starts; and whether one of them surely has."""
    when_ms, own = facts.start_ms[leaf], facts.together(leaf)
    brought = facts.bringing.get(facts.leaves[leaf].at or "", ())
    moves = [move for move in brought if move not in own and facts.end_ms[move] <= when_ms]
    possible, surely_ms = [], None
    for move in sorted(moves, key=lambda move: (facts.end_ms[move], facts.start_ms[move], move), reverse=True):
        lasts = facts.start_ms[move] < facts.end_ms[move]
        if surely_ms is not None and (lasts or facts.end_ms[move] < surely_ms):
            break
        possible.append(move)
        if lasts or facts.end_ms[move] < when_ms:
            surely_ms = facts.end_ms[move]
    return possible, surely_ms is not None


def reached(facts: Facts, leaf: int) -> Places:
    """Where a robot may be after an action: where its leg leads to, or else wherever the action may be done."""
    places = places_of(facts, leaf)
    legs = facts.schedule.legs if len(places) > 1 and facts.schedule is not None else ()
    there = [leg.destination for leg in legs if leg.leaf == leaf]
    return tuple(place for place in places if place is not None and may_be_at(there, place)) or places


def _first_of(facts: Facts, entity: str | None) -> Position | None:
    known = facts.world.by_id.get(entity) if entity is not None else None
    return None if known is None else facts.world.whereabouts(known).position
