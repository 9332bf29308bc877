"""
A bound of the checker's own where robots refill: what they must take in takes them time, and the chargers.

What the actions of a type use beyond what its robots hold at the start is taken in before one role or other. Ways count as nothing.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Mapping, Sequence
from typing import NamedTuple

from missiontree.checking.case import Case
from missiontree.checking.clock import TICKS_PER_S
from missiontree.checking.levels import refillable
from missiontree.checking.load import Piece, shared
from missiontree.mission.charger import Charger
from missiontree.mission.grounded import Action


class Want(NamedTuple):
    """What a type lacks of a stock, the chargers that may give it, and how long the mission goes on afterwards, in ticks."""

    amount: float
    chargers: Sequence[Charger]
    rest: int


def refill_load(case: Case, actions: Collection[Action], pieces: Mapping[str, Sequence[Piece]]) -> int:
    """
    Ticks below which no schedule with the refills that it needs can be.

    Parameters
    ----------
    case
        A plan under examination.
    actions
        Those of one alternative.
    pieces
        Its roles as pieces of work, by robot type.
    """
    least, wanting = 0, dict[str, list[Want]]()
    for type_id, own in pieces.items():
        load, rest = list(own), min(work + tail for _, work, tail in own)
        for stock in sorted(refillable(case, type_id)):
            serving = [one for one in case.scene.chargers if one.stock == stock and one.serves(type_id)]
            amount = _lacking(case, actions, type_id, stock)
            if amount > 0 and serving:
                wanting.setdefault(stock, []).append(Want(amount, serving, rest))
                load.append((0, _ticks(amount, max(one.rate_per_s for one in serving)), rest))
        least = max(least, shared(load, case.most_in_use(type_id)))
    for wants in wanting.values():
        for some in [*([one] for one in wants), wants]:
            serving_all = {one.id: one for want in some for one in want.chargers}.values()
            at_once = sum(one.rate_per_s * one.capacity for one in serving_all)
            least = max(least, _ticks(sum(want.amount for want in some), at_once) + min(want.rest for want in some))
    return least


def _ticks(amount: float, per_s: float) -> int:
    return math.floor(TICKS_PER_S * amount / per_s)


def _lacking(case: Case, actions: Collection[Action], type_id: str, stock: str) -> float:
    kind, robots = case.fleet.by_id[type_id], case.at_hand(type_id)
    used = sum(
        max(action.uses.get(stock, 0.0), action.uses_at_least.get(stock, 0.0))
        for action in actions
        if action.robot_type == type_id
    )
    held = sorted((robot.remaining.get(stock, kind.limits[stock]) for robot in robots), reverse=True)
    return used - sum(held[: case.most_in_use(type_id)])
