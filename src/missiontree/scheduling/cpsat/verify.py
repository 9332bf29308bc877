"""Does an answer keep a model? Asked of every answer before it is used: nothing rests on the solver's word alone."""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Sequence

from missiontree.scheduling.cpsat.model import (
    Affine,
    AtMostOne,
    Clause,
    Constraint,
    Cumulative,
    ExactlyOne,
    Interval,
    Linear,
    Model,
    NoOverlap,
    Routes,
)


def broken(model: Model, values: Sequence[int]) -> Iterator[str]:
    """What the values, one per variable, do not keep."""
    for number, ((least, most), value) in enumerate(zip(model.domains, values, strict=True)):
        if not least <= value <= most:
            yield f"variable {number} is {value}, not within {least} to {most}"
    for number, constraint in enumerate(model.constraints):
        if not _kept(model, constraint, values):
            yield f"constraint {number}, {constraint}, is broken"


def _kept(model: Model, one: Constraint, values: Sequence[int]) -> bool:
    match one:
        case Linear(terms, least, most, when):
            return not _all(when, values) or least <= sum(factor * values[var] for factor, var in terms) <= most
        case Clause(literals):
            return any(_holds(literal, values) for literal in literals)
        case ExactlyOne(literals):
            return sum(_holds(literal, values) for literal in literals) == 1
        case AtMostOne(literals):
            return sum(_holds(literal, values) for literal in literals) <= 1
        case Interval(start, size, end, when):
            length = _value(size, values)
            return not _all(when, values) or (length >= 0 and _value(start, values) + length == _value(end, values))
        case NoOverlap(intervals):
            spans = sorted(_spans(model, intervals, values))
            return all(before[1] <= after[0] for before, after in itertools.pairwise(spans))
        case Cumulative(intervals, capacity, asked):
            asking = [
                (*span, demand)
                for number, demand in zip(intervals, asked or (1,) * len(intervals), strict=True)
                for span in _spans(model, (number,), values)
            ]
            return all(sum(d for s, e, d in asking if s <= start < e) <= capacity for start, _, _ in asking)
        case Routes(arcs):
            return _tours([(tail, head) for tail, head, literal in arcs if _holds(literal, values)], arcs)


def _tours(taken: list[tuple[int, int]], arcs: Sequence[tuple[int, int, int]]) -> bool:
    nodes = {node for tail, head, _ in arcs for node in (tail, head)} - {0}
    after = {tail: head for tail, head in taken if tail}
    if len([tail for tail, _ in taken if tail]) != len(nodes) or {*after} != nodes:
        return False
    passed: list[int] = []
    for tail, head in taken:
        if tail == 0:
            node = head
            while node and len(passed) <= len(nodes):
                passed.append(node)
                node = after[node]
    return sorted(passed) == sorted(nodes)


def _spans(model: Model, intervals: Sequence[int], values: Sequence[int]) -> list[tuple[int, int]]:
    found = []
    for number in intervals:
        one = model.constraints[number]
        assert isinstance(one, Interval)
        if _all(one.when, values):
            found.append((_value(one.start, values), _value(one.end, values)))
    return found


def _all(literals: Sequence[int], values: Sequence[int]) -> bool:
    return all(_holds(literal, values) for literal in literals)


def _holds(literal: int, values: Sequence[int]) -> bool:
    return bool(values[literal]) if literal >= 0 else not values[-1 - literal]


def _value(one: Affine, values: Sequence[int]) -> int:
    return one.offset + (0 if one.var is None else values[one.var])
