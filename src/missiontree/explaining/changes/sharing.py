"""Room for more robots at what they share: a second charger, a wider door."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from missiontree.explaining.case import Case
from missiontree.explaining.changes.editing import with_scene
from missiontree.explaining.changes.needs import Needs
from missiontree.mission.change import Change


def candidates(case: Case, needs: Needs) -> Iterator[Change]:
    """Every shared resource of the scene."""
    for resource in case.brief.world.resources:
        yield Change(kind="raise_capacity", target=resource.id, was=resource.capacity)


def raise_capacity(case: Case, change: Change) -> Case:
    """A shared resource has room for more; for all robots there are, if no number is given."""
    room = len(case.brief.fleet.robots) if change.to is None else int(change.to)
    resources = tuple(
        replace(one, capacity=max(one.capacity, room)) if one.id == change.target else one
        for one in case.brief.world.resources
    )
    return with_scene(case, resources=resources)


def raise_capacity_words(case: Case, change: Change) -> str:
    """As an order."""
    label = case.brief.world.shared[change.target].label
    to = "all robots" if change.to is None else f"{change.to:g} robots"
    return f"make room for {to} at a time at {label} instead of {change.was:g}"
