"""
A constraint model as plain values, so that it can be built, written down and verified without a solver at hand.

Variables are numbers. A *literal* is the number of a 0-1 variable, or ``-1 - number`` for its negation, as in CP-SAT. A constraint
with literals in ``when`` binds only where all of them are true.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import NamedTuple

Terms = tuple[tuple[int, int], ...]
"""Coefficient and variable, summed."""
FAR = (1 << 62) - 1


class Affine(NamedTuple):
    """A variable plus a number; the number alone if the variable is None."""

    var: int | None
    offset: int = 0

    def __add__(self, more: object) -> Affine:
        assert isinstance(more, int)
        return Affine(self.var, self.offset + more)


class Linear(NamedTuple):
    """The terms sum up to something between two numbers, both included."""

    terms: Terms
    least: int
    most: int
    when: tuple[int, ...] = ()


class Clause(NamedTuple):
    """At least one of the literals is true."""

    literals: tuple[int, ...]


class ExactlyOne(NamedTuple):
    """One of the literals is true and no other."""

    literals: tuple[int, ...]


class AtMostOne(NamedTuple):
    """No two of the literals are true."""

    literals: tuple[int, ...]


class Interval(NamedTuple):
    """A span of time: ``start + size = end``; it is there where all of ``when`` is true."""

    start: Affine
    size: Affine
    end: Affine
    when: tuple[int, ...] = ()


class NoOverlap(NamedTuple):
    """Of the intervals (numbers of constraints) no two overlap; one without length does not stand inside another."""

    intervals: tuple[int, ...]


class Cumulative(NamedTuple):
    """At no time do the intervals under way ask for more than ``capacity``; each asks for its demand, or for 1 if none is given."""

    intervals: tuple[int, ...]
    capacity: int
    demands: tuple[int, ...] = ()


class Routes(NamedTuple):
    """Arcs (from, to, literal): those taken are tours from node 0 back to it that pass every other node once."""

    arcs: tuple[tuple[int, int, int], ...]


Constraint = Linear | Clause | ExactlyOne | AtMostOne | Interval | NoOverlap | Cumulative | Routes


def negated(literal: int) -> int:
    """The opposite of a literal."""
    return -1 - literal


class Model:
    """Variables, constraints, an objective to be minimised, and values to begin with."""

    def __init__(self) -> None:
        self.domains: list[tuple[int, int]] = []
        self.constraints: list[Constraint] = []
        self.objective: Terms = ()
        self.hint: dict[int, int] = {}
        self.true = self.integer(1, 1)

    @property
    def false(self) -> int:
        """The literal that never holds."""
        return negated(self.true)

    @property
    def size(self) -> int:
        """How large the model is: variables and what constraints name."""
        return len(self.domains) + sum(_length(one) for one in self.constraints)

    def integer(self, least: int, most: int) -> int:
        """A new whole number between two bounds, both included."""
        self.domains.append((least, most))
        return len(self.domains) - 1

    def boolean(self) -> int:
        """A new literal."""
        return self.integer(0, 1)

    def add(self, constraint: Constraint) -> int:
        """A further constraint; its number."""
        self.constraints.append(constraint)
        return len(self.constraints) - 1

    def clause(self, *literals: int) -> None:
        """At least one holds."""
        if self.true not in literals:
            self.add(Clause(tuple(literal for literal in literals if literal != self.false)))

    def implies(self, when: Iterable[int], then: int) -> None:
        """Where all of ``when`` holds, ``then`` does."""
        self.clause(then, *(negated(literal) for literal in when))

    def at_least(self, later: Affine, earlier: Affine, lag: int = 0, when: Sequence[int] = ()) -> None:
        """``later >= earlier + lag``, where all of ``when`` holds."""
        when = tuple(literal for literal in when if literal != self.true)
        if self.false in when:
            return
        terms = [(1, later.var)] if later.var is not None else []
        if earlier.var is not None:
            terms = [] if earlier.var == later.var else [*terms, (-1, earlier.var)]
        least = earlier.offset - later.offset + lag
        if terms:
            self.add(Linear(tuple((c, v) for c, v in terms if v is not None), least, FAR, when))
        elif least > 0:
            self.clause(*(negated(literal) for literal in when))


def _length(constraint: Constraint) -> int:
    match constraint:
        case Linear(terms=terms, when=when):
            return len(terms) + len(when)
        case Clause(literals) | ExactlyOne(literals) | AtMostOne(literals):
            return len(literals)
        case NoOverlap(intervals):
            return len(intervals)
        case Cumulative(intervals=intervals):
            return len(intervals)
        case Routes(arcs):
            return 2 * len(arcs)
        case Interval():
            return 3
