"""How cost grows with the work: seconds over leaves and over robots, with a fitted exponent."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from itertools import takewhile
from math import exp, log
from pathlib import Path

from benchmarks.contenders import ARRAYS, Question, quickest, warm
from missiontree.formats.importers.tree_json import read_tree

LIMIT_S = 60.0
K = 10


@dataclass(frozen=True, slots=True)
class Series:
    """
    Trees of which one measure grows.

    Parameters
    ----------
    name, words
        What it is called, in tables and in pictures.
    over
        ``leaves`` or ``robots``: what grows.
    sizes
        How it grows.
    other
        The other of the two, which stays.
    budgets
        Whether budgets limit the robots.
    fitted_from
        Smallest size that the exponent is fitted to; below it, what every call costs rules.
    contender
        Who is measured, as :mod:`benchmarks.contenders` names it. Default ``exact``.
    """

    name: str
    words: str
    over: str
    sizes: tuple[int, ...]
    other: int
    budgets: bool
    fitted_from: int
    contender: str = "exact"

    def tree(self, size: int) -> tuple[int, int]:
        """Leaves and robots."""
        return (size, self.other) if self.over == "leaves" else (self.other, size)


LEAVES = (10, 100, 1_000, 10_000, 100_000, 1_000_000)
ROBOTS = (1, 3, 10, 30, 100, 300, 1_000)
SERIES = (
    Series("free-leaves", "no budgets, 10 robots", "leaves", LEAVES, 10, False, 1_000),
    Series("tight-leaves", "budgets, 10 robots", "leaves", LEAVES, 10, True, 100),
    Series("free-robots", "no budgets, 10,000 leaves", "robots", ROBOTS, 10_000, False, 1),
    Series("tight-robots", "budgets, 10,000 leaves", "robots", ROBOTS, 10_000, True, 1),
    Series("arrays-leaves", "no budgets, bare arrays, compiled", "leaves", LEAVES, 10, False, 10_000, ARRAYS),
    Series("arrays-robots", "no budgets, bare arrays, compiled", "robots", ROBOTS, 10_000, False, 1, ARRAYS),
)


@dataclass(frozen=True, slots=True)
class Point:
    """
    A measurement.

    Parameters
    ----------
    size
        Leaves or robots.
    seconds
        For the 10 best, from arrays to the list.
    proven
        Whether they are proven; if not, the limit was reached.
    """

    size: int
    seconds: float
    proven: bool


Grown = dict[Series, list[Point]]


def grown(
    file: Callable[[tuple[str, int, int, int]], Path], limit_s: float, seed: int, series: Sequence[Series] = SERIES
) -> Grown:
    """Measure every series; ``file`` gives the tree of a family, a number of leaves and robots, and a seed."""
    points: Grown = {}
    for one in series:
        points[one] = []
        warm(one.contender)
        for size in one.sizes:
            question = Question(file(("mission", *one.tree(size), 0)), K, one.budgets, limit_s, seed)
            points[one].append(_point(one.contender, size, question))
    return points


def _point(contender: str, size: int, question: Question) -> Point:
    answer = quickest(contender, read_tree(question.file), question)
    return Point(size, answer.seconds, answer.proven)


def fitted(series: Series, points: Sequence[Point]) -> tuple[float, float] | None:
    """
    Exponent and factor of seconds = factor * size ** exponent, by least squares over logarithms; None for fewer than three points.

    Where one ended at the limit, only those of smaller sizes count: what is quick again beyond it is another kind of problem.
    """
    measured = [p for p in points if p.size >= series.fitted_from and p.seconds > 0]
    known = [(log(p.size), log(p.seconds)) for p in takewhile(lambda p: p.proven, measured)]
    if len(known) < 3:
        return None
    mean_x, mean_y = (sum(column) / len(known) for column in zip(*known, strict=True))
    slope = sum((x - mean_x) * (y - mean_y) for x, y in known) / sum((x - mean_x) ** 2 for x, _ in known)
    return slope, exp(mean_y - slope * mean_x)


def growth_table(points: Grown) -> str:
    """The measurements as a Markdown table."""
    return "\n".join(_lines(points))


def _lines(points: Grown) -> Iterator[str]:
    yield "| 10 best | over | seconds by size | fitted exponent |"
    yield "|---|---|---|---|"
    for series, measured in points.items():
        shown = ", ".join(f"{p.size:,}: {p.seconds:.4g}{'' if p.proven else ' (limit)'}" for p in measured)
        fit = fitted(series, measured)
        exponent = "-" if fit is None else f"{fit[0]:.2f} (from {series.fitted_from:,})"
        yield f"| {series.words} | {series.over} | {shown} | {exponent} |"
