"""What robots may use together: totals of a type and of the fleet, and the stock of the scene."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from missiontree.explaining.case import Case
from missiontree.explaining.changes.editing import put, shown, with_brief, with_scene, with_type
from missiontree.explaining.changes.needs import Needs
from missiontree.mission.change import Change


def candidates(case: Case, needs: Needs) -> Iterator[Change]:
    """Every total and every stock of which something is used."""
    fleet = case.brief.fleet
    for kind in fleet.types:
        for name in sorted(needs.budgets & kind.total_limits.keys()):
            yield Change(kind="raise_total", target=kind.id, name=name, was=kind.total_limits[name])
    for name in sorted(needs.budgets & fleet.total_limits.keys()):
        yield Change(kind="raise_total", name=name, was=fleet.total_limits[name])
    for name in sorted(needs.budgets & case.brief.world.stock.keys()):
        yield Change(kind="raise_stock", name=name, was=case.brief.world.stock[name])


def raise_total(case: Case, change: Change) -> Case:
    """Robots of a type, or all robots, may use more together."""
    if change.target:
        return with_type(
            case,
            change.target,
            lambda kind: replace(kind, total_limits=put(kind.total_limits, change.name, change.to)),
        )
    fleet = case.brief.fleet
    return with_brief(case, fleet=replace(fleet, total_limits=put(fleet.total_limits, change.name, change.to)))


def raise_total_words(case: Case, change: Change) -> str:
    """As an order."""
    whose = f"all robots of type {case.brief.fleet.by_id[change.target].label}" if change.target else "all robots"
    return f"raise what {whose} together may use of {change.name} from {shown(change.was)} to {shown(change.to)}"


def raise_stock(case: Case, change: Change) -> Case:
    """The scene holds more."""
    return with_scene(case, stock=put(case.brief.world.stock, change.name, change.to))


def raise_stock_words(case: Case, change: Change) -> str:
    """As an order."""
    return f"raise the stock of {change.name} from {shown(change.was)} to {shown(change.to)}"
