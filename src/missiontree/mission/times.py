"""Release times and deadlines of nodes, and what a node has of its own and from the nodes above it."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from missiontree.mission.ticks import ticks, ticks_within


@dataclass(frozen=True, slots=True)
class Window:
    """
    When a node may be under way, in ticks.

    Parameters
    ----------
    release
        It starts no earlier. Default 0.
    deadline
        It has ended by then; None (default) means no deadline.
    due_to
        Index of the node that sets the deadline: itself, or one above it; of equal deadlines the lowest. -1 (default) if there is none.
    """

    release: int = 0
    deadline: int | None = None
    due_to: int = -1


ALWAYS = Window()


def windows_of(nodes: Iterable[tuple[int, float, float | None]]) -> tuple[Window, ...]:
    """
    The window of each node: the latest release and the earliest deadline of itself and all above it.

    Parameters
    ----------
    nodes
        Parent, release time and deadline in seconds of each node, parents before children; -1 is the parent of the root.
    """
    windows: list[Window] = []
    for index, (parent, release_s, deadline_s) in enumerate(nodes):
        above = windows[parent] if parent >= 0 else ALWAYS
        if not release_s and deadline_s is None:
            windows.append(above)
            continue
        deadline, due_to = above.deadline, above.due_to
        if deadline_s is not None and (deadline is None or ticks_within(deadline_s) <= deadline):
            deadline, due_to = ticks_within(deadline_s), index
        windows.append(Window(max(above.release, ticks(release_s)), deadline, due_to))
    return tuple(windows)


def check_times(what: str, release_s: float, deadline_s: float | None) -> None:
    """
    Refuse a deadline that lies before the release time.

    Raises
    ------
    ValueError
        Naming both.
    """
    if deadline_s is not None and deadline_s < release_s:
        raise ValueError(
            f"{what} has the deadline {deadline_s:g} s, before its release time {release_s:g} s; nothing can be done in between."
        )


def words_of_times(release_s: float, deadline_s: float | None) -> tuple[str, ...]:
    """Times as people read them: ``from 30 s`` and ``by 120 s``; what is not given is left out."""
    release = (f"from {release_s:g} s",) if release_s else ()
    return (*release, f"by {deadline_s:g} s") if deadline_s is not None else release
