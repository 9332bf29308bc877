"""The tree as an outline for the terminal, and as a picture."""

from __future__ import annotations

from collections.abc import Iterator

from missiontree.mission.grounded import GroundedTree
from missiontree.mission.tree import MissionTree
from missiontree.reporting.tree_shape import Shape, ShapeNode, link_words, shape_of
from missiontree.reporting.tree_svg import svg_of


def tree_text(tree: MissionTree | GroundedTree) -> str:
    """
    A tree as an outline: a line per node with the gate over its children, then a line per link, in words.

    Names are harmless: on one line, without control characters. The text ends in a line feed.
    """
    shape = shape_of(tree)
    return "".join(f"{line}\n" for line in (*_outline(shape), *link_words(shape)))


def tree_svg(tree: MissionTree | GroundedTree) -> str:
    """
    A tree as a picture, as an SVG document.

    Tasks are round, actions and routines are red boxes, routines expanded over the fleet stand in red frames; edges below an XOR
    are dashed, precedence is a blue arrow. Levels, order and distances are those of
    :func:`missiontree.reporting.tree_layout.tidy_layout`. Names are shown as words, never as markup. The same tree
    gives the same bytes.
    """
    return svg_of(shape_of(tree))


def _outline(shape: Shape) -> Iterator[str]:
    stack = [(0, "", "")]
    while stack:
        index, lead, below = stack.pop()
        yield lead + _line(shape.nodes[index])
        children = shape.children[index]
        last = children[-1:]
        for child in reversed(children):
            branch, further = ("└── ", "    ") if (child,) == last else ("├── ", "│   ")
            stack.append((child, below + branch, below + further))


def _line(node: ShapeNode) -> str:
    gate = f" [{node.gate.upper()}]" if node.gate else ""
    note = f" ({node.note})" if node.note else ""
    return f"{node.label}{gate}{note}"
