"""What a right plan must and must not have, where more than one plan is right."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

from missiontree.evaluation.notation import Order, PlannedCall, call_from, order_from
from missiontree.evaluation.ordering import check_order
from missiontree.mission.value import Value


@dataclass(frozen=True, kw_only=True)
class Loose(Value):
    """
    Expectations that leave the rest of the plan open.

    Parameters
    ----------
    must
        Calls such as ``Reach(Kitchen)``, each of which occurs; ``*`` for an argument means anything. One that stands twice occurs twice.
    must_not
        Calls that do not occur; without robot types.
    order
        Relations between the entries of ``must``, numbered from 1: ``1 < 2`` ends before, ``1 ~ 2`` lasts until.
    entities
        Names of whom and what some routine is about.
    """

    must: tuple[str, ...] = ()
    must_not: tuple[str, ...] = ()
    order: tuple[str, ...] = ()
    entities: tuple[str, ...] = ()

    def _check(self) -> None:
        if not (self.must or self.entities):
            raise ValueError("something must be done: must or entities is needed beside must_not and order.")
        check_order(self.order, self.relations, len(self.calls), "must has")
        for text, call in zip(self.must_not, self.refused, strict=True):
            if call.types:
                raise ValueError(f"{text!r} names robot types, which must_not does not look at.")
            if text in self.must:
                raise ValueError(f"{text!r} stands in must and in must_not.")
        for name in self.entities:
            if not name.strip():
                raise ValueError("entities has a name without words.")

    @cached_property
    def calls(self) -> tuple[PlannedCall, ...]:
        """The entries of ``must``."""
        return tuple(call_from(text) for text in self.must)

    @cached_property
    def refused(self) -> tuple[PlannedCall, ...]:
        """The entries of ``must_not``."""
        return tuple(call_from(text) for text in self.must_not)

    @cached_property
    def relations(self) -> tuple[Order, ...]:
        """The order that is written."""
        return tuple(order_from(text) for text in self.order)

    def __str__(self) -> str:
        parts = (("must", "; ".join(self.must)), ("must not", "; ".join(self.must_not)))
        said = [f"{what} {calls}" for what, calls in parts if calls]
        said += [f"entities {', '.join(self.entities)}"] if self.entities else []
        return " | ".join([*said, ", ".join(self.order)] if self.order else said)
