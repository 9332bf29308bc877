"""From when and until when every action may be under way, read off both trees and the mission."""

from __future__ import annotations

import math
from typing import NamedTuple

from missiontree.checking.case import Case
from missiontree.checking.clock import TICKS_PER_S, ticks_needed
from missiontree.checking.fault import named
from missiontree.checking.staffing import Staffing

Times = tuple[float, float | None, str]
"""Release time and deadline in seconds, and whose they are."""


class Window(NamedTuple):
    """Release and deadline of an action in ticks, and the nodes that set them; no deadline is None."""

    release: int = 0
    released_by: str = ""
    deadline: int | None = None
    due_to: str = ""


def mission_deadline(case: Case) -> int | None:
    """The last tick of the whole mission; None if it has none."""
    return None if case.plan.brief.deadline_s is None else _last(case.plan.brief.deadline_s)


def windows(case: Case, staffing: Staffing) -> dict[int, Window]:
    """The window of every selected action that has one; times of the mission tree bind even where grounding lost them."""
    found: dict[int, Window] = {}
    if not case.has_times:
        return found
    for leaf in staffing.actions:
        window = Window()
        for release_s, deadline_s, whose in _above(case, staffing, leaf):
            release = ticks_needed(release_s)
            if release > window.release:
                window = window._replace(release=release, released_by=whose)
            if deadline_s is not None:
                last = _last(deadline_s)
                if window.deadline is None or last < window.deadline:
                    window = window._replace(deadline=last, due_to=whose)
        if window != Window():
            found[leaf] = window
    return found


def _above(case: Case, staffing: Staffing, leaf: int) -> list[Times]:
    """The times that bind an action: its own, those of all nodes above it in both trees, and the mission's."""
    times: list[Times] = [(0.0, case.plan.brief.deadline_s, "the mission")]
    tree, authored = staffing.tree, case.mission_tree
    sources: dict[str, None] = {}
    node = leaf
    while node >= 0:
        here = tree.nodes[node]
        times.append((here.release_s, here.deadline_s, named(tree, node)))
        if here.source is not None and authored is not None and here.source in authored.by_id:
            sources |= dict.fromkeys((here.source, *authored.ancestors(here.source)))
        node = here.parent
    if authored is not None:
        times += [
            (authored.by_id[name].release_s, authored.by_id[name].deadline_s, authored.by_id[name].label)
            for name in sources
        ]
    return times


def _last(deadline_s: float) -> int:
    return math.floor(min(deadline_s, 1e12) * TICKS_PER_S + 1e-6)
