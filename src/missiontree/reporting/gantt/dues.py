"""Deadlines in a Gantt chart: what they are of, and the flags that stand at them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from missiontree.mission.grounded import GroundedTree
from missiontree.reporting.critical.bonds import Bonds
from missiontree.reporting.escape import one_line, xml_safe
from missiontree.reporting.gantt.content import Due, Row
from missiontree.reporting.gantt.layout import Place, Scale
from missiontree.reporting.gantt.time import exact
from missiontree.reporting.palette import RED
from missiontree.reporting.svg_numbers import n

FLAG = 7.0


def dues_of(tree: GroundedTree, leaves: Sequence[int]) -> list[Due]:
    """The deadlines that some actions have, each once; that of the whole mission is not told row by row."""
    found: dict[Due, None] = {}
    for leaf in leaves:
        node = tree.windows[leaf].due_to
        if node > 0:
            deadline_s = tree.nodes[node].deadline_s
            assert deadline_s is not None
            label = tree.action(leaf).text if node == leaf else tree.nodes[node].label
            found[Due(deadline_s, f"{one_line(label)} must end by {exact(deadline_s)}")] = None
    return sorted(found)


def times_of(tree: GroundedTree, leaf: int) -> Iterator[str]:
    """The times that an action has, for its title."""
    window = tree.windows[leaf]
    if window.release:
        yield f"may not start before {exact(window.release / 1000)}"
    if window.deadline is not None:
        yield f"must end by {exact(window.deadline / 1000)}"


def times_at(bonds: Bonds) -> dict[int, str]:
    """
    Release times and deadlines in words, by the scheduled action that has to keep them.

    A release time stands at the first action of what has it, a deadline at the last; those of the whole mission are told with the mission.
    """
    found: dict[int, list[str]] = {}
    for index, node in enumerate(bonds.tree.nodes):
        first, last = bonds.first_below(index), bonds.last_below(index)
        if index and node.release_s and first is not None:
            found.setdefault(first, []).append(f"not before {exact(node.release_s)}")
        if index and node.deadline_s is not None and last is not None:
            found.setdefault(last, []).append(f"due by {exact(node.deadline_s)}")
    return {leaf: ", ".join(dict.fromkeys(words)) for leaf, words in found.items()}


def flags(row: Row, scale: Scale, place: Place) -> Iterator[str]:
    """A flag at each deadline of a row that the axis reaches."""
    for due in row.dues:
        if due.time_s <= scale.makespan_s:
            x, top = scale.x(due.time_s), place.top + 3
            yield (
                f'<g class="mt-due"><title>{xml_safe(due.title)}</title>'
                f'<path class="mt-line" d="M{n(x)} {n(top)} V{n(place.bottom - 3)}" stroke="{RED}" stroke-width="1.6" fill="none"/>'
                f'<path class="mt-fill" d="M{n(x)} {n(top)} l-{n(FLAG)} {n(FLAG / 2)} l{n(FLAG)} {n(FLAG / 2)} Z" fill="{RED}"/></g>'
            )
