"""All kinds of change: where candidates come from, how each is applied and told. The one list to add to."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping

from missiontree.explaining.case import Case
from missiontree.explaining.changes import abilities, cells, parts, robots, sharing, terms, times, totals, ways
from missiontree.explaining.changes.needs import needs_of
from missiontree.mission.change import Change, ChangeKind

Apply = Callable[[Case, Change], Case]
Words = Callable[[Case, Change], str]

FAMILIES: Mapping[ChangeKind, tuple[Apply, Words]] = {
    "take_off_without": (terms.take_off_without, terms.take_off_without_words),
    "take_off_require": (terms.take_off_require, terms.take_off_require_words),
    "end_anywhere": (terms.end_anywhere, terms.end_anywhere_words),
    "lower_min_quality": (terms.lower_min_quality, terms.lower_min_quality_words),
    "allow_type": (terms.allow_type, terms.allow_type_words),
    "ignore_kinds": (terms.ignore_kinds, terms.ignore_kinds_words),
    "drop_link": (terms.drop_link, terms.drop_link_words),
    "open_way": (ways.open_way, ways.open_way_words),
    "clear_cells": (cells.clear_cells, cells.clear_cells_words),
    "lift_keep_out": (ways.lift_keep_out, ways.lift_keep_out_words),
    "allow_zone": (ways.allow_zone, ways.allow_zone_words),
    "extend_deadline": (times.extend_deadline, times.extend_deadline_words),
    "move_release": (times.move_release, times.move_release_words),
    "extend_stay": (times.extend_stay, times.extend_stay_words),
    "come_earlier": (times.come_earlier, times.come_earlier_words),
    "raise_in_use": (robots.raise_in_use, robots.raise_in_use_words),
    "raise_capacity": (sharing.raise_capacity, sharing.raise_capacity_words),
    "raise_total": (totals.raise_total, totals.raise_total_words),
    "raise_stock": (totals.raise_stock, totals.raise_stock_words),
    "raise_limit": (abilities.raise_limit, abilities.raise_limit_words),
    "lower_limit": (abilities.lower_limit, abilities.lower_limit_words),
    "raise_quality": (abilities.add_capability, abilities.raise_quality_words),
    "add_capability": (abilities.add_capability, abilities.add_capability_words),
    "add_robot": (robots.add_robot, robots.add_robot_words),
    "drop_part": (parts.drop_part, parts.drop_part_words),
}
"""How each kind is applied to a copy of a case, and how it is told as an order."""

SOURCES = tuple(one.candidates for one in (terms, times, ways, cells, robots, sharing, totals, abilities, parts))
"""What may be changed, an idea each."""


def candidates(case: Case) -> Iterator[Change]:
    """Every single change that is looked at. One that has a number to be found stands without it, as far as it can go."""
    needs = needs_of(case)
    for source in SOURCES:
        yield from source(case, needs)


def applied(case: Case, changes: Iterable[Change]) -> Case:
    """
    A copy of a case with all changes made.

    Raises
    ------
    ValueError
        If what results is no mission, or they do not go together.
    """
    for change in changes:
        case = FAMILIES[change.kind][0](case, change)
    return case


def in_words(case: Case, changes: Iterable[Change]) -> str:
    """Changes as one order: ``Open the road a - b, and add one more rover.``."""
    told = [FAMILIES[change.kind][1](case, change) for change in changes]
    whole = ", and ".join(told)
    return f"{whole[:1].upper()}{whole[1:]}."
