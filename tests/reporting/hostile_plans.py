"""Plans in which every text that is free is a hostile name: as planning makes them, and as a file from anywhere may hold them."""

from __future__ import annotations

import dataclasses
import types
from collections.abc import Callable, Mapping, Sequence
from functools import cache
from typing import Annotated, Any, Literal, Union, get_args, get_origin, get_type_hints

from missiontree import plan
from missiontree.authoring.outcome import Authored
from missiontree.briefing import Request
from missiontree.mission.control import Control
from missiontree.mission.plan import Plan
from missiontree.planner import plan_authored
from missiontree.samples.catalogue import SAMPLES, sample_file

Rename = Callable[[str, str], str]
"""From the kind of a text (``Entity.label``) and the text to the name that takes its place."""

# Worlds of every kind of map: floors with a lift, roads with a search area, open ground with zones, a grid, joint work at sea.
DELIVERED = ("clinic", "tunnel", "airport", "home", "harbour")
DECLINED = ("Recommend the best restaurants", "Find the keys if it rains")
# Texts that mean something: patterns that are parsed, comparisons, the rows of a grid.
MEANINGFUL = {("Routine", "says"), ("Need", "at_least"), ("Need", "at_most"), ("OccupancyGrid", "rows")}
# Texts in which braces are fields that must name an argument.
TEMPLATES = {("Routine", "purpose"), ("ActionStep", "text")}


@cache
def harmless(world: str) -> Plan:
    """The plan of a world as it is."""
    return plan(sample_file(world) if world in SAMPLES else world)


def poisoned(value: Any, rename: Rename) -> Any:
    """The value with every free text in it renamed, at any depth; ids, numbers and choices stay."""
    owner = type(value).__name__
    changes = {
        name: _poisoned(annotation, getattr(value, name), _of_kind(owner, name, rename))
        for name, annotation in _fields(type(value))
    }
    return dataclasses.replace(value, **changes)


def _of_kind(owner: str, field: str, rename: Rename) -> Rename:
    """The renaming, told of which kind a text is; texts of other values within keep their own kind."""
    kind, template = f"{owner}.{field}", (owner, field) in TEMPLATES

    def renamed(inner: str, text: str) -> str:
        name = rename(inner or kind, text)
        return name.replace("{", "(").replace("}", ")") if template else name

    return renamed


_FIELDS: dict[str, tuple[tuple[str, Any], ...]] = {}


def _fields(cls: type[Any]) -> tuple[tuple[str, Any], ...]:
    """Fields that may hold a free text, with their annotations."""
    if cls.__name__ not in _FIELDS:
        hints = get_type_hints(cls, include_extras=True).items()
        _FIELDS[cls.__name__] = tuple((name, hint) for name, hint in hints if _may_hold_text(cls.__name__, name, hint))
    return _FIELDS[cls.__name__]


def _may_hold_text(owner: str, name: str, annotation: Any) -> bool:
    return not name.startswith("__") and (owner, name) not in MEANINGFUL and not _is_plain(annotation)


def _is_plain(annotation: Any) -> bool:
    """Ids, numbers, choices, and lists of them."""
    if get_origin(annotation) in {tuple, Union, types.UnionType}:
        return all(_is_plain(arm) for arm in get_args(annotation) if arm is not Ellipsis)
    return get_origin(annotation) in {Annotated, Literal} or annotation in {int, float, bool, types.NoneType}


def _poisoned(annotation: Any, given: Any, rename: Rename) -> Any:
    origin, args = get_origin(annotation), get_args(annotation)
    if given is None:
        return None
    if annotation is str:
        return rename("", given)
    if dataclasses.is_dataclass(given):
        return poisoned(given, rename)
    if origin in {Union, types.UnionType}:
        arms = [arm for arm in args if arm is not types.NoneType]
        return _poisoned(arms[0], given, rename) if len(arms) == 1 else given
    if origin is tuple:
        return tuple(_poisoned(args[0], entry, rename) for entry in given)
    if isinstance(given, Mapping):
        return {_poisoned(args[0], key, rename): _poisoned(args[1], entry, rename) for key, entry in given.items()}
    return given


def dealt(names: Sequence[str]) -> Rename:
    """Deal the names out in turn, kind by kind: each stands in every kind of text of which there are enough."""
    counts: dict[str, int] = {}

    def rename(kind: str, text: str) -> str:
        place = counts[kind] = counts.get(kind, len(kind)) + 1  # kinds begin at different names
        return names[place % len(names)]

    return rename


def as_a_file_may_hold_it(world: str, names: Sequence[str]) -> Plan:
    """A plan that nobody made: every text of the finished plan is one of the names."""
    made: Plan = poisoned(harmless(world), dealt(names))
    return made


def as_planning_makes_it(world: str, names: Sequence[str]) -> Plan:
    """A plan that was made for inputs and a tree in which every text is one of the names; its actions and reasons quote them."""
    before, rename = harmless(world), dealt(names)
    assert before.tree is not None
    brief, tree = (poisoned(value, rename) for value in (before.brief, before.tree))
    authored = Authored(status="complete", tree=tree, reading=tuple(names), author="given")
    return plan_authored(Request(brief=brief, k=2), authored, Control())
