"""Whose budget it is, and what would help: said for a type's total, one robot, all robots of a type, and several types."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from missiontree.allocation.flat import Stock

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


def _of_total(type_id: str, name: str) -> Holder:
    remedy = f"Raise {name} in the total_limits of type {type_id}, or {ANOTHER_WAY}; a further robot would not help."
    return Holder(f"all robots of type {type_id} together", remedy)
