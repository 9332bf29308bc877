"""A model in the text form of CP-SAT's own protocol, which any process with the solver can read."""

from __future__ import annotations

from collections.abc import Iterable

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


def text_of(model: Model) -> str:
    """The whole model, its hint included."""
    lines = [f"variables {{ {_all('domain', domain)} }}" for domain in model.domains]
    lines += [f"constraints {{ {_constraint(one)} }}" for one in model.constraints]
    if model.objective:
        lines.append(f"objective {{ {_terms(model.objective)} }}")
    if model.hint:
        lines.append(f"solution_hint {{ {_all('vars', model.hint)} {_all('values', model.hint.values())} }}")
    return "\n".join(lines)


def _constraint(one: Constraint) -> str:
    match one:
        case Linear(terms, least, most, when):
            return f"{_when(when)}linear {{ {_terms(terms)} domain: {least} domain: {most} }}"
        case Clause(literals):
            return f"bool_or {{ {_all('literals', literals)} }}"
        case ExactlyOne(literals):
            return f"exactly_one {{ {_all('literals', literals)} }}"
        case AtMostOne(literals):
            return f"at_most_one {{ {_all('literals', literals)} }}"
        case Interval(start, size, end, when):
            inside = f"start {{ {_affine(start)} }} size {{ {_affine(size)} }} end {{ {_affine(end)} }}"
            return f"{_when(when)}interval {{ {inside} }}"
        case NoOverlap(intervals):
            return f"no_overlap {{ {_all('intervals', intervals)} }}"
        case Cumulative(intervals, capacity, asked):
            demands = " ".join(f"demands {{ offset: {one} }}" for one in asked or [1] * len(intervals))
            return f"cumulative {{ capacity {{ offset: {capacity} }} {_all('intervals', intervals)} {demands} }}"
        case Routes(arcs):
            tails, heads, literals = zip(*arcs, strict=True)
            return f"routes {{ {_all('tails', tails)} {_all('heads', heads)} {_all('literals', literals)} }}"


def _when(literals: Iterable[int]) -> str:
    return "".join(f"enforcement_literal: {literal} " for literal in literals)


def _terms(terms: Iterable[tuple[int, int]]) -> str:
    return " ".join(f"vars: {variable} coeffs: {factor}" for factor, variable in terms)


def _affine(one: Affine) -> str:
    return f"offset: {one.offset}" if one.var is None else f"vars: {one.var} coeffs: 1 offset: {one.offset}"


def _all(name: str, values: Iterable[int]) -> str:
    return " ".join(f"{name}: {value}" for value in values)
