"""Schedules whose pictures are kept: the paper's four missions that can be planned, as Gantt charts and in a terminal."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial

from missiontree.reporting.gantt.view import gantt_svg
from missiontree.reporting.text import render
from missiontree.reporting.timeline.view import timeline
from missiontree.samples.catalogue import PAPER
from tests.reporting.golden_trees import planned

WIDTH = 100


def pictures() -> Iterator[tuple[str, Callable[[], str]]]:
    """Names of files, and how their content is made."""
    for name in PAPER:
        if name != "restaurants":  # nothing can be done there, so nothing is scheduled
            for rank in (1, 2):
                yield f"gantt-{name}-{rank}.svg", partial(_chart, name, rank)
            yield f"timeline-{name}.txt", partial(_lines, name)


def _chart(name: str, rank: int) -> str:
    return gantt_svg(planned(name), rank)


def _lines(name: str) -> str:
    made = planned(name)
    return render(timeline(made.schedules[0], made), WIDTH)
