"""Whose budget it is, and what would help: said for a type's total, one robot, all robots of a type, several types, and the mission."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from missiontree.allocation.flat import Shared, Stock
from missiontree.mission.reason import Reason, Severity

ANOTHER_WAY = "give the task another way of being done"


class Holder(NamedTuple):
    """Who may use a budget, as a phrase that "may use" follows, and what to do if that is too little."""

    whose: str
    remedy: str


def of_all_robots(type_id: str, stock: Stock, name: str) -> Holder:
    """For what all robots of a type use together, see :meth:`missiontree.allocation.flat.Stock.pooled`."""
    each = [budget[name] for budget in stock.budgets if name in budget]
    if name in stock.totals and (len(each) < len(stock.budgets) or stock.totals[name] <= sum(each)):
        return _of_total(type_id, name)
    whose = (
        f"the {len(each)} robots of type {type_id} together" if len(each) > 1 else f"the only robot of type {type_id}"
    )
    return Holder(whose, f"Raise {name} of type {type_id}, add a robot of that type, or {ANOTHER_WAY}.")


def of_one_robot(type_id: str, stock: Stock, name: str) -> Holder:
    """For what one robot uses in one role, see :meth:`missiontree.allocation.flat.Stock.largest`."""
    each = [budget[name] for budget in stock.budgets if name in budget]
    if name in stock.totals and (len(each) < len(stock.budgets) or stock.totals[name] <= max(each)):
        return _of_total(type_id, name)
    whose = f"one robot of type {type_id}" if len(each) > 1 else f"the only robot of type {type_id}"
    remedy = f"One robot does all of this, so more robots like it would not help: raise {name} of type {type_id}, or {ANOTHER_WAY}."
    return Holder(whose, remedy)


def of_types(type_ids: Sequence[str], name: str) -> Holder:
    """For what several types that have limits use together."""
    *most, last = (f"type {type_ids[0]}",) if len(type_ids) == 1 else type_ids
    listed = f"types {', '.join(most)} and {last} together" if most else last
    return Holder(listed, f"Raise {name} of one of them, or {ANOTHER_WAY}.")


def of_the_mission(name: str, shared: Shared) -> Holder:
    """For what all robots of the mission use together."""
    if shared.source == "scene":
        remedy = f"Raise {name} in the stock of the scene, or {ANOTHER_WAY}; a further robot would not help."
        return Holder("the whole mission", remedy)
    remedy = f"Raise {name} in the total_limits of the fleet, or {ANOTHER_WAY}; a further robot would not help."
    return Holder("all robots of the mission together", remedy)


def type_idle(type_id: str, named: Sequence[str], severity: Severity = "error", roles: int = 0) -> Reason:
    """
    That a type which must take part fills no role, or fewer than it must.

    Parameters
    ----------
    type_id
        The type.
    named
        The type, or robots of it, as the operator requires them.
    severity
        Of the reason.
    roles
        How many roles it could fill at most. Default none.
    """
    names = " and ".join(f"type {name}" if name == type_id else name for name in named)
    wanted = max(1, len({name for name in named if name != type_id}))
    fills = (
        f"robots of type {type_id} fill {_counted(roles)} at most"
        if roles
        else f"no robot of type {type_id} fills a role"
    )
    return Reason(
        rule="required_idle",
        severity=severity,
        message=f"The mission requires {names}, and {fills}.",
        robot=type_id,
        found=_counted(roles),
        needed=f"at least {'one role' if wanted == 1 else f'{wanted} roles'}",
        hint=f"Take {' and '.join(named)} off 'require' of the mission, or ask for something that type {type_id} can do.",
    )


def _counted(roles: int) -> str:
    return "no role" if not roles else "1 role" if roles == 1 else f"{roles} roles"


def _of_total(type_id: str, name: str) -> Holder:
    remedy = f"Raise {name} in the total_limits of type {type_id}, or {ANOTHER_WAY}; a further robot would not help."
    return Holder(f"all robots of type {type_id} together", remedy)
