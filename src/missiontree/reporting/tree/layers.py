"""The layers of a drawn tree, each from a tree with everything at its place: what is chosen, frames, edges, links, words on them, marks."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

from missiontree.reporting.palette import PAPER, RED
from missiontree.reporting.svg_numbers import n
from missiontree.reporting.text_box import text_width
from missiontree.reporting.tree.ink import (
    EDGE_WIDTH,
    LINK_STYLES,
    NODE_WIDTH,
    XOR_DASHES,
    line_colour,
    link_line,
)
from missiontree.reporting.tree.marks import gate_arc, gate_mark, tick
from missiontree.reporting.tree.placing import Placed
from missiontree.reporting.tree.routes import LINK_SIZE, LINK_WORDS
from missiontree.reporting.tree.rows import FRAME_PADDING
from missiontree.reporting.tree.shape import State


def glows(tree: Placed) -> Iterator[str]:
    """A marker's stroke along the edges of the chosen alternative."""
    for fork in tree.forks:
        lit = [branch for branch in fork.branches if _edge_state(tree, fork.node, branch.child) == "lit"]
        if lit:
            yield f'<path class="mt-glow" d="{fork.stem()}"/>'
        yield from (f'<path class="mt-glow" d="{branch.path()}"/>' for branch in lit)
    for upper, lower in _followers(tree):
        if _edge_state(tree, upper, lower) == "lit":
            x, start, end = tree.rows.x[upper], tree.rows.y[upper], tree.rows.y[lower]
            yield f'<path class="mt-glow" d="M{n(x)} {n(start)} L{n(x)} {n(end)}"/>'


def frames(tree: Placed) -> Iterator[str]:
    """Red frames round attached routines."""
    rows, cards = tree.rows, tree.cards
    bottoms = [rows.y[node] + card.height / 2 for node, card in enumerate(cards)]
    for node in reversed(range(len(bottoms))):  # children stand after their parents
        bottoms[node] = max([bottoms[node], *(bottoms[child] for child in tree.shape.children[node])])
    for node, (low, high) in rows.spans.items():
        top = rows.y[node] - cards[node].height / 2 - FRAME_PADDING
        state = tree.shape.nodes[node].state
        yield (
            f'<rect class="mt-frame mt-{state}" x="{n(low)}" y="{n(top)}" width="{n(high - low)}" '
            f'height="{n(bottoms[node] + FRAME_PADDING - top)}" rx="6" stroke="{line_colour(state, RED)}" '
            f'stroke-width="{n(min(NODE_WIDTH[state], 2))}"/>'
        )


def edges(tree: Placed) -> Iterator[str]:
    """From boxes to forks, and on to the parts; the chosen ones on top."""
    for fork in tree.forks:
        states = [_edge_state(tree, fork.node, branch.child) for branch in fork.branches]
        stem: State = "lit" if "lit" in states else states[0]
        yield f'<path class="mt-edge mt-{stem}" d="{fork.stem()}" {_stroke(stem)}/>'
        dashes = f' stroke-dasharray="{XOR_DASHES}"' if fork.gate == "xor" else ""
        for branch, state in sorted(zip(fork.branches, states, strict=True), key=lambda one: one[1] == "lit"):
            whole = state == "lit" and fork.gate == "xor"  # those above it in its column are not lit
            line = branch.path(whole)
            yield f'<path class="mt-edge mt-{fork.gate} mt-{state}" d="{line}" {_stroke(state)}{dashes}/>'


def links(tree: Placed) -> Iterator[str]:
    """Links, and short arrows from action to action of a role."""
    for arrow, (first, second, _) in zip(tree.arrows, tree.shape.links, strict=True):
        state = _link_state(tree, first, second)
        yield f'<g class="mt-link mt-{LINK_STYLES[arrow.kind].name} mt-{state}">'
        yield from link_line(arrow.kind, arrow.points, state)
        yield "</g>"
    for upper, lower in _followers(tree):
        state = _link_state(tree, upper, lower)
        start = (tree.rows.x[upper], tree.rows.y[upper] + tree.cards[upper].height / 2)
        end = (tree.rows.x[lower], tree.rows.y[lower] - tree.cards[lower].height / 2)
        yield f'<g class="mt-order mt-{state}">'
        yield from link_line("precedence", (start, end), state)
        yield "</g>"


def words_on_links(tree: Placed) -> Iterator[str]:
    """Words on links, on a patch of paper that keeps lines off the letters."""
    for arrow, (first, second, _) in zip(tree.arrows, tree.shape.links, strict=True):
        if words := LINK_WORDS[arrow.kind]:
            x, y = arrow.label_at
            colour = line_colour(_link_state(tree, first, second), LINK_STYLES[arrow.kind].colour)
            turned = f' transform="rotate(-90 {n(x)} {n(y)})"' if arrow.upright else ""
            width = text_width(words, LINK_SIZE) + 6
            patch = f'x="{n(x - width / 2)}" y="{n(y - 6)}" width="{n(width)}" height="12"'
            yield f'<rect class="mt-paper" {patch}{turned} fill="{PAPER}"/>'
            yield f'<text class="mt-word" x="{n(x)}" y="{n(y + 3.4)}"{turned} fill="{colour}">{words}</text>'


def marks(tree: Placed) -> Iterator[str]:
    """Gates at the forks, with arcs over what they join, and ticks at what is chosen."""
    for fork in tree.forks:
        state = tree.shape.nodes[fork.node].state
        if fork.is_marked:
            if fork.ways > 1:
                yield gate_arc(fork.at, fork.branches[0].over, fork.branches[-1].over, fork.gate, state)
            yield gate_mark(fork.at[0], fork.mark_top, fork.gate, state)
        for branch in fork.branches:
            if fork.gate == "xor" and _edge_state(tree, fork.node, branch.child) == "lit":
                yield from tick(*branch.tick_at)


def _followers(tree: Placed) -> Iterator[tuple[int, int]]:
    """Actions of a role that stand one above the other."""
    blocks = tree.rows.blocks
    for members, ordered in zip(blocks.members, blocks.ordered, strict=True):
        if ordered:
            yield from pairwise(members)


def _edge_state(tree: Placed, parent: int, child: int) -> State:
    states = {tree.shape.nodes[parent].state, tree.shape.nodes[child].state}
    return "quiet" if "quiet" in states else "lit" if states == {"lit"} else "plain"


def _link_state(tree: Placed, first: int, second: int) -> State:
    return "quiet" if _edge_state(tree, first, second) == "quiet" else "plain"


def _stroke(state: State) -> str:
    return f'stroke="{line_colour(state)}" stroke-width="{n(EDGE_WIDTH[state])}"'
