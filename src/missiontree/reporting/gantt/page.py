"""A Gantt chart once everything in it is placed: it writes itself, from back to front."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from missiontree.mission.plan import Plan
from missiontree.mission.schedule import Schedule
from missiontree.reporting.called import called
from missiontree.reporting.gantt import axis, shared
from missiontree.reporting.gantt.away import away_pattern, hatched
from missiontree.reporting.gantt.bars import bands, stripe_lines, strokes, words_of
from missiontree.reporting.gantt.content import Bar, Content, Row
from missiontree.reporting.gantt.dues import flags
from missiontree.reporting.gantt.labels import Word
from missiontree.reporting.gantt.layout import BOLD, MARGIN, Density, Place, Scale, places
from missiontree.reporting.gantt.legend import idle_words, legend, notes, remarks, rule
from missiontree.reporting.gantt.links import Arrow, Box, arrow, bridge, wash
from missiontree.reporting.gantt.words import TITLE, UNDER, description, mission_of, summary
from missiontree.reporting.palette import MUTED, hatch_lines
from missiontree.reporting.svg_numbers import n
from missiontree.reporting.svg_page import middle_cut, opening, text
from missiontree.reporting.text_box import wrapped

MAX_ARROWS = 60


@dataclass(frozen=True, slots=True)
class Chart:
    """
    A chart.

    Parameters
    ----------
    plan, schedule, content
        What it shows.
    rows
        Those of the content that are drawn.
    words
        Words in each of them.
    numbered
        Actions whose words stand below the chart, by number.
    said
        What is left out, in words.
    scale, density, width
        Where things stand.
    prefix
        Start of the ids in the picture.
    """

    plan: Plan
    schedule: Schedule
    content: Content
    rows: Sequence[Row]
    words: Sequence[Sequence[Word]]
    numbered: Sequence[tuple[int, Bar]]
    said: Sequence[str]
    scale: Scale
    density: Density
    width: float
    prefix: str

    def lines(self) -> Iterator[str]:
        """The picture, line by line."""
        title = wrapped(mission_of(self.plan), TITLE * BOLD, self.width - 2 * MARGIN, 3)
        known = wrapped(summary(self.plan, self.schedule, self.content), UNDER, self.width - 2 * MARGIN, 2)
        head_bottom = MARGIN + 20.0 * len(title) + 16.0 * len(known) + 4.0
        top = head_bottom + axis.HEIGHT
        under = [any(word.spot in {"tag", "way", "aside"} for word in words) for words in self.words]
        stand = places(self.rows, under, top, self.density)
        robots_bottom = stand[-1].bottom
        common = shared.drawn(self.content.shared)
        bottom = robots_bottom + sum(shared.height_of(row) for row in common)
        below, height = self._below(bottom + 10.0)
        yield opening(
            self.width,
            height,
            f"{mission_of(self.plan)}: schedule of {called(self.plan, self.schedule.rank)}",
            description(self.content),
            self.prefix,
        )
        yield "<defs>"
        yield from stripe_lines(self.rows, self.prefix)
        yield from hatch_lines((row.livery for row in self.rows), self.prefix)
        yield from away_pattern(self.rows, self.prefix)
        yield "</defs>"
        for place, line in enumerate(title):
            yield text(MARGIN, MARGIN + 14 + 20.0 * place, line, size=TITLE, bold=True)
        for place, line in enumerate(known):
            y = MARGIN + 20.0 * len(title) + 14.0 + 16.0 * place
            yield text(MARGIN, y, line, size=UNDER, fill=MUTED, kind="mt-muted")
        yield from axis.hairlines(self.scale, top - 4, bottom)
        yield from (rule(place.top, self.width) for place in stand)
        yield rule(robots_bottom, self.width)
        if common:
            yield rule(bottom, self.width)
        yield from self._bands(stand)
        yield axis.end_line(self.scale, top - 4, bottom)
        yield from self._bridges(stand)
        arrows = list(self._arrows(stand))
        yield from (arrow.line for arrow in arrows)
        for row, words, where in zip(self.rows, self.words, stand, strict=True):
            yield f'<g class="mt-row mt-hue-{row.livery.number}">'
            yield from strokes(row, self.scale, where, self.prefix)
            yield from flags(row, self.scale, where)
            yield from words_of(words, row, where)
            yield from self._name(row, where)
            yield "</g>"
        yield from shared.lines(common, self.scale, robots_bottom, self.prefix, self.density.name_size)
        yield from self._washes(stand)
        yield from (arrow.head for arrow in arrows)
        yield from axis.labels(self.scale, top - 10)
        yield from below
        yield "</svg>"

    def _bands(self, stand: Sequence[Place]) -> Iterator[str]:
        for row, place in zip(self.rows, stand, strict=True):
            yield f'<g class="mt-hue-{row.livery.number}">'
            yield from hatched(row, self.scale, place, self.prefix)
            yield from bands(row, self.scale, place)
            yield "</g>"

    def _bridges(self, stand: Sequence[Place]) -> Iterator[str]:
        boxes = self._boxes(stand)
        for leaves in self.content.joint:
            yield from bridge([boxes[leaf] for leaf in leaves if leaf in boxes])

    def _washes(self, stand: Sequence[Place]) -> Iterator[str]:
        boxes = self._boxes(stand)
        for leaves in self.content.joint:
            yield from wash([boxes[leaf] for leaf in leaves if leaf in boxes])

    def _arrows(self, stand: Sequence[Place]) -> Iterator[Arrow]:
        boxes = self._boxes(stand)
        mates = {leaf: leaves for leaves in self.content.joint for leaf in leaves}
        orders = [order for order in self.content.orders if order.first in boxes and order.second in boxes]
        quiet = [order for order in orders if not order.lit]
        for order in (*(quiet if len(quiet) <= MAX_ARROWS else ()), *(order for order in orders if order.lit)):
            goal = boxes[order.second]
            ends = [boxes[leaf] for leaf in mates.get(order.first, (order.first,)) if leaf in boxes]
            nearest = min(ends, key=lambda box: abs(box.place.top - goal.place.top))
            if nearest.place != goal.place:
                yield arrow(nearest, goal, lit=order.lit, to_end=order.to_end)

    def _boxes(self, stand: Sequence[Place]) -> Mapping[int, Box]:
        return {
            bar.leaf: Box(*self.scale.span(bar.start_s, bar.end_s), place)
            for row, place in zip(self.rows, stand, strict=True)
            for bar in row.bars
        }

    def _name(self, row: Row, place: Place) -> Iterator[str]:
        size, room = self.density.name_size, self.scale.left - MARGIN - 19.5
        name = middle_cut(row.robot, size * BOLD, room)
        middle = place.middle
        height = min(30.0, 2 * (min(middle - place.top, place.bottom - middle) - 3))
        yield (
            f'<rect class="mt-fill" x="{n(MARGIN)}" y="{n(middle - height / 2)}" width="5" height="{n(height)}" rx="2" '
            f'fill="{row.livery.paint(self.prefix)}"/>'
        )
        two = self.density.notes and bool(row.kind)
        yield text(MARGIN + 11, middle - 2.5 if two else middle + 0.36 * size, name, size=size, bold=True)
        if two:
            kind = wrapped(row.kind, 10.5, room, 1)[0]
            yield text(MARGIN + 11, middle + 11.5, kind, size=10.5, fill=MUTED, kind="mt-muted")

    def _below(self, top: float) -> tuple[list[str], float]:
        """What stands below the rows, and the height of the whole picture."""
        quiet = sum(not order.lit for order in self.content.orders)
        said = [*idle_words(self.content.idle), *(f"{words[0].upper()}{words[1:]}." for words in self.said)]
        if quiet > MAX_ARROWS:
            said.append(f"{quiet:,} arrows that tell what comes first are left out.")
        numbered = notes(self.numbered, self.content.makespan_s, self.content.handing, top, self.width)
        remarked = remarks(said, top + numbered.height, self.width)
        top += numbered.height + remarked.height
        signs = legend(self.content, self.rows, top, self.width, self.prefix, arrows=0 < quiet <= MAX_ARROWS)
        return [*numbered.lines, *remarked.lines, *signs.lines], top + signs.height + MARGIN - 4
