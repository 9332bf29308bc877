"""
Words in a row of a Gantt chart, none over another.

An action's words stand in its bar if they fit, on one line or two; else beside it; else it gets a number, in its bar or below it,
and its words go into a list under the chart. Numbers below bars that would touch are drawn together: ``4-7``. What a robot waits
for stands over the dots, as far as there is room. Heads of arrows that point at bars from the left are kept free.
"""

from __future__ import annotations

import re
from bisect import bisect_left, bisect_right
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from math import inf
from typing import Literal, NamedTuple

from missiontree.reporting.gantt.content import Bar, Row, Stretch
from missiontree.reporting.gantt.layout import BOLD, FOOT, Density, Scale
from missiontree.reporting.gantt.links import ASIDE, BACK
from missiontree.reporting.svg_page import middle_cut
from missiontree.reporting.text_box import balanced, text_width

INSET = 5.0
HEAD = BACK + ASIDE + 2.0
"""Room that the head of an arrow takes before the bar it points at."""
GAP = 6.0
CLEAR = 3.0
"""Room between words below the bars and the line at the end."""
SMALL = 10.0
"""Font size of words on two lines, of numbers and of metres."""
LINE = 11.5
MAX_NOTES = 60
_LEAST_CAPTION = 48.0
_MOST_RUNS = 6

Spot = Literal["in", "beside", "number", "tag", "way", "aside", "held", "waiting", "caption", "outside"]
"""Way and aside, held and waiting, caption and outside: within a role's band, and beyond it."""


class Word(NamedTuple):
    """A line of words: its place in the row, counted from the top of the bars; what kind of place that is; the bar it stands in."""

    x: float
    y: float
    text: str
    size: float
    anchor: str
    spot: Spot
    bar: Bar | None = None


@dataclass(frozen=True, slots=True)
class Lettering:
    """The words of a row, and the indices of its bars whose words do not fit."""

    words: Sequence[Word]
    unfit: Sequence[int] = ()


@dataclass(frozen=True, slots=True)
class Letterer:
    """
    Puts words into rows.

    Parameters
    ----------
    scale, density
        Where things stand.
    """

    scale: Scale
    density: Density

    def lettered(self, row: Row, goals: Sequence[float] = ()) -> Lettering:
        """The words that fit into a row: of its roles, its bars and its waits; ``goals``: where arrows end, sorted."""
        words, unfit = [*self._captions(row), *self._waits(row, goals)], []
        spans = [self.scale.span(bar.start_s, bar.end_s) for bar in row.bars]
        more = [self.scale.span(one.start_s, one.end_s) for one in (*row.ways, *row.waits, *row.refills)]
        taken = sorted([*spans, *more])
        for index, (bar, span) in enumerate(zip(row.bars, spans, strict=True)):
            place = bisect_right(taken, span)  # one behind the bar itself
            after = taken[place][0] if place < len(taken) else inf
            if taken[place - 2 : place] == [span, span]:  # two without duration, at the same time
                after = -inf
            after = min(after, _goal(span[1], goals) - HEAD)
            found = self._inside(bar, span, goals) or self._beside(bar, span[1], after)
            words += found
            if not found:
                unfit.append(index)
        return Lettering(words, unfit)

    def numbered(self, row: Row, numbers: Mapping[int, int], goals: Sequence[float] = ()) -> list[Word]:
        """Numbers of those bars of a row that have one, by index; then what is refilled, and metres of ways, where there is room left."""
        words: list[Word] = []
        tags: list[tuple[list[int], float]] = []
        for index, number in numbers.items():
            left, right = self.scale.span(row.bars[index].start_s, row.bars[index].end_s)
            middle, written = (left + right) / 2, str(number)
            if right - left >= text_width(written, SMALL) * BOLD + 2 * _inset((left, right), goals, 2.5):
                words.append(
                    Word(
                        middle, self._middle(row.bars[index]) + 3.6, written, SMALL, "middle", "number", row.bars[index]
                    )
                )
            else:
                tags.append(([number], middle))
        placed = self._packed(tags)
        words += [word for word, _, _ in placed]
        taken = [(left, right) for _, left, right in placed]
        for way in (*row.refills, *row.ways):
            room = self._free(way, taken) if way.label else None
            if room is not None:
                left, right = room
                taken.append(room)
                held = any(
                    self.scale.x(role.start_s) <= left and right <= self.scale.x(role.end_s) for role in row.roles
                )
                spot: Spot = "way" if held else "aside"
                words.append(Word((left + right) / 2, self._under, way.label, SMALL, "middle", spot))
        return words

    def _free(self, way: Stretch, taken: Sequence[tuple[float, float]]) -> tuple[float, float] | None:
        """Where words below a way touch no others: in its middle, else as near to it as there is room with theirs below the way."""
        begin, end = self.scale.x(way.start_s), self.scale.x(way.end_s)
        middle, width = (begin + end) / 2, text_width(way.label, SMALL) * BOLD
        beside = [side for low, high in taken for side in (low - GAP - width / 2, high + GAP + width / 2)]
        near = sorted((one for one in beside if begin <= one <= end), key=lambda one: abs(one - middle))
        for left, right in (self._spread(way.label, one) for one in (middle, *near)):
            if all(right + GAP <= low + 1e-6 or high + GAP <= left + 1e-6 for low, high in taken):
                return left, right
        return None

    def _middle(self, bar: Bar) -> float:
        """The height in a bar that words are centred on: a move has stripes at its foot."""
        return (self.density.bar - (FOOT if bar.moves and self.density.notes else 0.0)) / 2

    @property
    def _under(self) -> float:
        return self.density.bar + 11.0

    def _captions(self, row: Row) -> Iterator[Word]:
        """What the roles are called, over their bars, as far as there is room up to the next one; not what a bar says by itself."""
        if not self.density.caption:
            return
        size = self.density.caption_size
        said = {(bar.label, bar.start_s, bar.end_s) for bar in row.bars}
        roles = [role for role in row.roles if (role.label, role.start_s, role.end_s) not in said]
        spans = [self.scale.span(role.start_s, role.end_s) for role in roles]
        low = self.scale.left
        for at, (role, (start, end)) in enumerate(zip(roles, spans, strict=True)):
            high = spans[at + 1][0] - GAP if at + 1 < len(spans) else self.scale.right - GAP
            width = text_width(role.label, size) + 0.5
            left = max(low, min(start + INSET, high - width))  # if need be it begins before its role
            if high - left >= min(width, _LEAST_CAPTION):
                label = middle_cut(role.label, size, high - left)  # like robots, roles differ at their ends
                inside = start <= left and left + text_width(label, size) <= end
                yield Word(left, size - self.density.caption, label, size, "start", "caption" if inside else "outside")
                low = left + text_width(label, size) + GAP
            low = max(low, end + GAP)

    def _waits(self, row: Row, goals: Sequence[float]) -> Iterator[Word]:
        """What the robot waits for: in full, or only for whom."""
        if not self.density.notes:
            return
        for wait in row.waits:
            left, right = self.scale.x(wait.start_s), self.scale.x(wait.end_s)
            right -= HEAD if _goal(right, goals) - right < 1 else 0.0
            short = re.split("[:,]", wait.label)[0]
            for words in (wait.label, short):
                width = text_width(told := f"waits {words}", SMALL)
                if words and width + 4 <= right - left:
                    held = any(
                        self.scale.x(role.start_s) <= (left + right - width) / 2
                        and (left + right + width) / 2 <= self.scale.x(role.end_s)
                        for role in row.roles
                    )
                    y = self.density.bar / 2 - 5.0
                    yield Word((left + right) / 2, y, told, SMALL, "middle", "held" if held else "waiting")
                    break

    def _inside(self, bar: Bar, span: tuple[float, float], goals: Sequence[float]) -> list[Word]:
        left, right = span
        room, middle, size = right - left - 2 * _inset(span, goals, INSET), (left + right) / 2, self.density.size
        for lines in _wordings(bar, room, two=self.density.notes):
            top = self._middle(bar) + (0.36 * size if len(lines) == 1 else -0.17 * LINE)
            written = size if len(lines) == 1 else SMALL
            if all(text_width(line, written) <= room for line in lines):
                return [
                    Word(middle, top + LINE * at, line, written, "middle", "in", bar) for at, line in enumerate(lines)
                ]
        return []

    def _beside(self, bar: Bar, right: float, after: float) -> list[Word]:
        """Words right of a bar, if nothing stands there."""
        if not self.density.notes:
            return []
        limit, size = min(self.scale.right, after), self.density.size
        for text in dict.fromkeys((f"{bar.label} · {bar.way}" if bar.way else bar.label, bar.label)):
            if right + GAP + text_width(text, size) + GAP <= limit:
                return [Word(right + GAP, self.density.bar / 2 + 0.36 * size, text, size, "start", "beside")]
        return []

    def _spread(self, text: str, middle: float) -> tuple[float, float]:
        """Left and right of words below the bars, moved so that they stay between the names and the line at the end."""
        width = text_width(text, SMALL) * BOLD
        left = max(min(middle - width / 2, self.scale.right - CLEAR - width), self.scale.left)
        return left, left + width

    def _packed(self, tags: Sequence[tuple[list[int], float]]) -> list[tuple[Word, float, float]]:
        """Numbers below their bars; those that would touch go together, in the middle of theirs."""
        groups: list[tuple[list[int], list[float]]] = []
        for numbers, middle in tags:
            groups.append((numbers, [middle]))
            while len(groups) > 1 and self._span(groups[-2])[1] + GAP > self._span(groups[-1])[0]:
                more, middles = groups.pop()
                groups[-1] = (groups[-1][0] + more, groups[-1][1] + middles)
        placed = []
        for group in groups:
            left, right = self._span(group)
            word = Word((left + right) / 2, self._under, _ranges(group[0]), SMALL, "middle", "tag")
            placed.append((word, left, right))
        return placed

    def _span(self, group: tuple[list[int], list[float]]) -> tuple[float, float]:
        return self._spread(_ranges(group[0]), (group[1][0] + group[1][-1]) / 2)


def _inset(span: tuple[float, float], goals: Sequence[float], least: float) -> float:
    """How far words in a bar stay from its sides: off the head of an arrow to the next bar, which lies on its end."""
    return max(least, span[1] - _goal(span[1], goals) + HEAD)


def _goal(x: float, goals: Sequence[float]) -> float:
    """The first end of an arrow at x or right of it; infinite if there is none."""
    place = bisect_left(goals, x - 0.1)
    return goals[place] if place < len(goals) else inf


def _wordings(bar: Bar, room: float, *, two: bool) -> Iterator[list[str]]:
    """Ways of writing what a bar says on one line or two, the fullest first."""
    if bar.way:
        yield [f"{bar.label} · {bar.way}"]
        if two:
            yield [bar.label, bar.way]
    yield [bar.label]
    if two and max(text_width(word, SMALL) for word in bar.label.split() or [""]) <= room:  # no word is cut
        lines = balanced(bar.label, SMALL, room, 3)
        if len(lines) == 2:
            yield lines


def _ranges(numbers: Sequence[int]) -> str:
    """``2``, ``2, 3``, ``2-5``, ``2, 4-6``."""
    runs: list[list[int]] = []
    for number in numbers:
        if runs and number == runs[-1][-1] + 1:
            runs[-1].append(number)
        else:
            runs.append([number])
    if len(runs) > _MOST_RUNS:
        return f"{numbers[0]} … {numbers[-1]}"
    return ", ".join(f"{run[0]}\u2013{run[-1]}" if len(run) > 2 else ", ".join(str(one) for one in run) for run in runs)
