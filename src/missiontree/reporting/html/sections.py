"""The parts of the page, in the order in which they are read."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from typing import Any

from markupsafe import Markup

from missiontree.mission.explanation import Explanation
from missiontree.mission.plan import Plan
from missiontree.reporting.html.checked import Checked
from missiontree.reporting.html.compared import compared
from missiontree.reporting.html.dialogue import dialogue
from missiontree.reporting.html.inlined import Picture
from missiontree.reporting.html.inputs import inputs
from missiontree.reporting.html.options import shown_choice, shown_front
from missiontree.reporting.html.origin import origin
from missiontree.reporting.html.page import filled
from missiontree.reporting.html.proofs import proofs
from missiontree.reporting.html.remarks import not_offered, remarks, sentence
from missiontree.reporting.html.repairs import repairs
from missiontree.reporting.html.ways import Way, outline
from missiontree.reporting.left_out import known_of_larger, parts_left_out
from missiontree.reporting.team.view import team_view

UNDONE = ("cannot_be_done", "partial")
MOST_REFUSED = 60
UNFOLDED_REFUSED = 8
"""So many tasks stand there at once; the others are folded, as what matters to hands stands further down."""
ROWS: tuple[tuple[tuple[str, ...], tuple[str, ...]], ...] = (
    (("left_out",), ()),
    (("why",), ()),
    (("repairs",), ()),
    (("chosen",), ()),
    (("schedule",), ()),
    (("map",), ()),
    (("caveats",), ("refused",)),
    (("alternatives",), ()),
    (("front",), ()),
    (("tree",), ()),
    (("timetable",), ("limits", "reading")),
    (("proofs",), ()),
    (("origin",), ("inputs",)),
)
"""Sections that stand side by side where the page is wide; they are read from left to right, and down."""


@dataclass(frozen=True, slots=True)
class Section:
    """
    A part of the page.

    Parameters
    ----------
    id
        Its anchor.
    title
        Its heading.
    body
        Its content.
    """

    id: str
    title: str
    body: Markup


def sections_of(
    plan: Plan,
    ways: tuple[Way, ...],
    tree: Picture | None,
    checked: Checked | None,
    told: Explanation | None = None,
) -> dict[str, Section]:
    """
    The sections that a plan gives rise to, by id, in reading order.

    Parameters
    ----------
    plan
        The plan.
    ways
        Its alternatives that can be chosen.
    tree
        The picture of its tree, if there are none.
    checked
        What its checker said; None if it was not asked.
    told
        Why it cannot be done, and what would make it possible; None if that was not asked.
    """
    made = {section.id: section for section in _sections(plan, ways, tree, checked, told)}
    order = [name for left, right in ROWS for name in (*left, *right)]
    return {name: made[name] for name in order if name in made}


def rows_of(sections: Mapping[str, Section]) -> tuple[tuple[tuple[Section, ...], ...], ...]:
    """The sections in rows of one or two columns."""
    rows = (tuple(tuple(sections[name] for name in column if name in sections) for column in row) for row in ROWS)
    return tuple(kept for row in rows if (kept := tuple(column for column in row if column)))


def _sections(
    plan: Plan, ways: tuple[Way, ...], tree: Picture | None, checked: Checked | None, told: Explanation | None
) -> Iterator[Section]:
    if plan.partial is not None:
        parts = remarks(parts_left_out(plan.partial))
        yield _section("left_out", "Left out", parts=parts, known=known_of_larger(plan.partial))
    if plan.reasons:
        first = next((reason for reason in plan.reasons if reason.hint), None)
        rest = [replace(reason, hint="") if reason is first else reason for reason in plan.reasons]
        step = sentence(first.hint) if first is not None else ""
        if told is not None and told.repairs:
            step = told.repairs[0].words
        yield _section(
            "why",
            "Why" if plan.outcome not in UNDONE else "Why it cannot be done",
            reasons=remarks(rest),
            first_step=step,
        )
    if told is not None and told.outcome != "delivered":
        nearest = told.nearest.words if told.nearest is not None and plan.partial is None else ""
        yield _section("repairs", "What would make it possible", repairs=repairs(told), nearest=nearest)
    if (choice := shown_choice(plan)) is not None:
        yield _section("chosen", "Chosen", choice=choice)
    if ways:
        yield from _of_alternatives(plan, ways)
    if (front := shown_front(plan)) is not None:
        yield _section("front", "From the best staffed to the fastest", front=front, worth=plan.brief.aim.worth)
    if groups := _caveats(plan):
        yield _section("caveats", "Before you rely on it", groups=groups)
    if ways or tree is not None:
        branched = [way for way in ways if way.pictures.branches is not None]
        only = branched[0] if len(branched) == 1 and len(ways) > 1 else None
        yield _section("tree", "Mission tree", ways=ways, tree=tree, branches=only, outline=outline(plan))
    if refusals := not_offered(plan):
        shown, folded = refusals[:UNFOLDED_REFUSED], refusals[UNFOLDED_REFUSED:MOST_REFUSED]
        more = max(0, len(refusals) - MOST_REFUSED)
        yield _section("refused", "Not offered", refusals=shown, folded=folded, more=more)
    if plan.provenance.reading:
        yield _section("reading", "How the words were read", reading=plan.provenance.reading)
    yield _section(
        "proofs",
        "What is proven",
        proofs=proofs(plan),
        checked=checked is not None,
        faults=remarks(checked.faults if checked is not None else ()),
        trusted=remarks(checked.trusted if checked is not None else ()),
    )
    yield _section("origin", "How it came about", pairs=origin(plan), dialogue=dialogue(plan.provenance.transcript))
    yield _section("inputs", "Inputs", inputs=inputs(plan))


def _of_alternatives(plan: Plan, ways: tuple[Way, ...]) -> Iterator[Section]:
    yield _section("schedule", "Who does what", ways=ways)
    if any(way.pictures.map is not None for way in ways):
        yield _section("map", "Map", ways=ways)
    view = team_view(plan)
    assert view is not None, "alternatives that can be chosen can be compared"
    comparison, undrawn = compared(view), len(view.columns) > len(ways)
    yield _section("alternatives", "Alternatives", compared=comparison, ways=ways, undrawn=undrawn)
    yield _section("timetable", "Timetable", ways=ways)
    yield _section("limits", "Limits", ways=ways)


def _caveats(plan: Plan) -> list[tuple[str, Any]]:
    groups = (
        ("Look at", plan.findings),
        ("Taken for granted", plan.assumptions),
        ("Done on your behalf", plan.notices),
    )
    return [(title, remarks(reasons)) for title, reasons in groups if reasons]


def _section(name: str, title: str, **values: Any) -> Section:
    return Section(name, title, Markup(filled(f"{name}.html.j2", **values)))  # noqa: S704 - a template's, which escapes
