"""The limits of a problem, each of which can be dropped by itself: what a mission could do if one of them were not there."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from dataclasses import replace
from typing import Literal, NamedTuple

from missiontree.allocation.flat import Flat, Shared, Stock

Kind = Literal[
    "team", "different_robot", "same_robot", "left_out", "required", "max_in_use", "mission", "type", "robots"
]


class Limit(NamedTuple):
    """
    One rule that may stand in the way of a mission.

    Parameters
    ----------
    kind
        ``robots``: what each robot of a type may use. ``type``: what they may use together. ``mission``: what all robots may use, by the
        fleet's total or the scene's stock. ``max_in_use``: how many robots of a type may take part. ``required``, ``left_out``: who
        must take part, and who must not. ``same_robot``, ``different_robot``: a link. ``team``: roles of joint work have different
        robots.
    who
        The robot type; empty where none is meant.
    name
        Of the budget, or of the robot or type that is required or left out; empty elsewhere.
    nodes
        The two ends of a link; empty elsewhere.
    team
        Number of the team; -1 elsewhere.
    """

    kind: Kind
    who: str = ""
    name: str = ""
    nodes: tuple[int, ...] = ()
    team: int = -1


def limits_of(flat: Flat) -> tuple[Limit, ...]:
    """All limits; those that people look for last come first."""
    return (
        *(Limit("team", team=team) for team in _teams(flat)),
        *(Limit("different_robot", nodes=link) for link in dict.fromkeys(flat.different_robot)),
        *(Limit("same_robot", nodes=link) for link in dict.fromkeys(flat.same_robot)),
        *(Limit("left_out", who, name) for who, stock in flat.stocks.items() for name in stock.left_out),
        *(Limit("required", who, name) for who, names in flat.required.items() for name in dict.fromkeys(names)),
        *(Limit("max_in_use", who) for who, stock in flat.stocks.items() if stock.max_in_use is not None),
        *(Limit("mission", name=name) for name in flat.shared),
        *(Limit("type", who, name) for who, stock in flat.stocks.items() for name in stock.totals),
        *(Limit("robots", who, name) for who, stock in flat.stocks.items() for name in _limited(stock)),
    )


def _teams(flat: Flat) -> list[int]:
    roles: dict[int, set[int]] = {}
    for role in flat.role:
        team = flat.team[role] if role >= 0 else None
        if team is not None:
            roles.setdefault(team, set()).add(role)
    return sorted(team for team, mates in roles.items() if len(mates) > 1)


def _limited(stock: Stock) -> list[str]:
    return sorted({name for budget in (*stock.budgets, *stock.left_out.values()) for name in budget})


def without_limits(flat: Flat, dropped: Collection[Limit]) -> Flat:
    """The same problem without some of its limits."""
    gone = frozenset(dropped)
    teams = {limit.team for limit in gone if limit.kind == "team"}
    return replace(
        flat,
        team=tuple(None if team in teams else team for team in flat.team) if teams else flat.team,
        same_robot=tuple(link for link in flat.same_robot if Limit("same_robot", nodes=link) not in gone),
        different_robot=tuple(
            link for link in flat.different_robot if Limit("different_robot", nodes=link) not in gone
        ),
        stocks={who: _stock_without(who, stock, gone) for who, stock in flat.stocks.items()},
        shared=_shared_without(flat.shared, gone),
        required=dict(_required_without(flat.required, gone)),
    )


def _shared_without(shared: Mapping[str, Shared], gone: frozenset[Limit]) -> dict[str, Shared]:
    return {name: held for name, held in shared.items() if Limit("mission", name=name) not in gone}


def _required_without(
    required: Mapping[str, tuple[str, ...]], gone: frozenset[Limit]
) -> Iterator[tuple[str, tuple[str, ...]]]:
    for who, names in required.items():
        kept = tuple(name for name in names if Limit("required", who, name) not in gone)
        if kept:
            yield who, kept


def _stock_without(who: str, stock: Stock, gone: frozenset[Limit]) -> Stock:
    back = {name: budget for name, budget in stock.left_out.items() if Limit("left_out", who, name) in gone}
    budgets = (*stock.budgets, *back.values())
    free = {limit.name for limit in gone if limit.kind == "robots" and limit.who == who}
    if free:
        budgets = tuple({name: most for name, most in budget.items() if name not in free} for budget in budgets)
    return Stock(
        robots=(*stock.robots, *back),
        budgets=budgets,
        totals={name: most for name, most in stock.totals.items() if Limit("type", who, name) not in gone},
        max_in_use=None if Limit("max_in_use", who) in gone else stock.max_in_use,
        required=tuple(place for place in stock.required if Limit("required", who, stock.robots[place]) not in gone),
        left_out={name: budget for name, budget in stock.left_out.items() if name not in back},
    )
