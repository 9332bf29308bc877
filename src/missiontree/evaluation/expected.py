"""A plan that is expected: routines, choices between them, and their order, as suites write them."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Annotated, Any

from missiontree.evaluation.notation import ANYTHING, Order, PlannedCall, call_from, order_from
from missiontree.evaluation.ordering import check_order
from missiontree.mission.frozen_map import FrozenMap
from missiontree.mission.tree import Gate
from missiontree.mission.value import Value

if TYPE_CHECKING:
    from pydantic import GetJsonSchemaHandler

_DEEPEST = 16
_GATES: tuple[Gate, ...] = ("xor", "and")


class EntryShape:
    """Marks an entry of a plan: a call in words, or a group of entries under its gate. Its rules stand in :class:`Expected`."""

    def __get_pydantic_json_schema__(self, core_schema: Any, handler: GetJsonSchemaHandler) -> dict[str, Any]:
        members = {"type": "array", "minItems": 2, "items": {"type": ["string", "object"]}}
        group = {"type": "object", "minProperties": 1, "maxProperties": 1, "additionalProperties": False}
        return {"anyOf": [{"type": "string"}, {**group, "properties": dict.fromkeys(_GATES, members)}]}


PlanEntry = Annotated[Any, EntryShape()]


@dataclass(frozen=True, slots=True)
class Group:
    """Entries of a plan under one gate; a routine is given by its place in the plan, counted from 0."""

    gate: Gate
    members: tuple[Group | int, ...]


@dataclass(frozen=True, kw_only=True)
class Expected(Value):
    """
    A right plan of a mission.

    Parameters
    ----------
    plan
        Entries, all of which are done: a call such as ``Reach(Anna) by social_robot``, ``{xor: [...]}``, exactly one of, or, within
        that, ``{and: [...]}``.
    order
        Relations between the calls, which are numbered from 1 as they are written: ``1 < 2``, the first ends before the second
        starts; ``1 ~ 2``, the first lasts until the second ends. What follows from others need not be written.
    """

    plan: tuple[PlanEntry, ...]
    order: tuple[str, ...] = ()

    def _check(self) -> None:
        object.__setattr__(self, "plan", _frozen(self.plan, 0))
        if not self.plan:
            raise ValueError("a plan has at least one routine.")
        check_order(self.order, self.relations, len(self.calls))
        for text, call in zip(self.texts, self.calls, strict=True):
            if ANYTHING in call.arguments:
                raise ValueError(f"{text!r} leaves an argument open; '*' is for must and must_not.")

    @cached_property
    def calls(self) -> tuple[PlannedCall, ...]:
        """The routines as they are written, nested ones too."""
        return tuple(call_from(text) for text in self.texts)

    @cached_property
    def texts(self) -> tuple[str, ...]:
        """The routines in the words of the file."""
        return tuple(_texts(self.plan))

    @cached_property
    def relations(self) -> tuple[Order, ...]:
        """The order that is written."""
        return tuple(order_from(text) for text in self.order)

    @cached_property
    def shape(self) -> Group:
        """Which choices there are between the routines."""
        numbers = iter(range(len(self.texts)))
        return Group("and", tuple(_shape(entry, numbers) for entry in self.plan))

    def __str__(self) -> str:
        plan = "; ".join(_shown(entry) for entry in self.plan)
        return f"{plan} | {', '.join(self.order)}" if self.order else plan


def _frozen(entry: Any, depth: int) -> Any:
    """The entry unable to change; ``ValueError`` unless it is a text or a group of entries."""
    if depth > _DEEPEST:
        raise ValueError("the plan is nested too deeply.")
    if isinstance(entry, str):
        return entry
    if isinstance(entry, list | tuple):
        for member in entry:
            if isinstance(member, list | tuple):
                raise ValueError("a list stands in a list; write {xor: [...]} or {and: [...]}.")
        return tuple(_frozen(member, depth + 1) for member in entry)
    if not isinstance(entry, Mapping):
        raise ValueError(
            f"{str(entry)!r} is no entry of a plan; accepted are a call, {{xor: [...]}} and {{and: [...]}}."
        )
    if len(entry) != 1 or next(iter(entry)) not in _GATES:
        strange = next((key for key in entry if key not in _GATES), "xor")
        raise ValueError(
            f"the key {strange!r} does not make a group; write {{xor: [...]}} or {{and: [...]}}, one in each entry."
        )
    gate, members = next(iter(entry.items()))
    if not isinstance(members, list | tuple) or len(members) < 2:
        raise ValueError(f"the group {gate!r} needs a list of at least two entries.")
    return FrozenMap({gate: _frozen(members, depth + 1)})


def _texts(entry: Any) -> Iterator[str]:
    if isinstance(entry, str):
        yield entry
        return
    members = entry if isinstance(entry, tuple) else next(iter(entry.values()))
    for member in members:
        yield from _texts(member)


def _shape(entry: Any, numbers: Iterator[int]) -> Group | int:
    if isinstance(entry, str):
        return next(numbers)
    gate, members = next(iter(entry.items()))
    return Group(gate, tuple(_shape(member, numbers) for member in members))


def _shown(entry: Any) -> str:
    if isinstance(entry, str):
        return entry
    gate, members = next(iter(entry.items()))
    return f"{gate}({'; '.join(_shown(member) for member in members)})"
