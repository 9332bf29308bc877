"""The tree as a picture, in the style of the paper's figures: a page of SVG without scripts, styles or fonts of its own."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from missiontree.reporting.palette import hatch_lines
from missiontree.reporting.svg_numbers import n
from missiontree.reporting.svg_page import opening
from missiontree.reporting.tree.boxes import box
from missiontree.reporting.tree.cards import NOTE_SIZE, SIZE
from missiontree.reporting.tree.folding import folded
from missiontree.reporting.tree.ink import GLOW
from missiontree.reporting.tree.layers import edges, frames, glows, links, marks, words_on_links
from missiontree.reporting.tree.legend import ROW, Entry, in_lines, legend_lines, legend_of, width_of
from missiontree.reporting.tree.placing import Placed, draft_of, placed
from missiontree.reporting.tree.routes import LINK_SIZE
from missiontree.reporting.tree.rows import MARGIN
from missiontree.reporting.tree.shape import Shape
from missiontree.reporting.tree.words import description, folding_words

MOST_NODES = 500


def svg_of(whole: Shape, most: int = MOST_NODES, rank: int | None = None, ranks: int = 0, prefix: str = "tree") -> str:
    """
    Draw a tree. Equal trees give equal bytes; linear in nodes, plus links times their depth.

    Parameters
    ----------
    whole
        The tree.
    most
        How many nodes are drawn at most; if there are more, subtrees are folded.
    rank, ranks
        Which of how many alternatives is lit; None if none is.
    prefix
        Start of the ids in the picture.
    """
    draft = draft_of(folded(whole, most))
    chosen = "" if rank is None else f"alternative {rank} of {ranks}"
    hidden = folding_words(draft.shape, whole)
    legend = in_lines(legend_of(draft.shape, any(draft.blocks.ordered), chosen, hidden), draft.layout.width)
    tree = placed(draft, width_of(legend) + 2 * MARGIN)
    told = description(draft.shape, whole, rank, ranks)
    return "\n".join(_page(tree, legend, told, prefix)) + "\n"


def _page(tree: Placed, legend: Sequence[Sequence[Entry]], told: str, prefix: str) -> Iterator[str]:
    """Everything placed, from back to front."""
    height = tree.rows.height + ROW * len(legend)
    yield opening(tree.rows.width, height, tree.shape.nodes[0].label, told, prefix)
    shown = [tag.livery for card in tree.cards for tag in card.tags if tag.livery is not None]
    if patterns := list(hatch_lines(shown, prefix)):
        yield from ("<defs>", *patterns, "</defs>")
    middle, small = 'text-anchor="middle"', f'font-size="{n(NOTE_SIZE)}"'
    marker = f'fill="none" stroke="{GLOW}" stroke-width="9" stroke-linejoin="round"'
    yield from _group("mt-glows", marker, glows(tree))
    yield from _group("mt-frames", 'fill="none"', frames(tree))
    yield from _group("mt-edges", 'fill="none" stroke-linejoin="round"', edges(tree))
    yield from _group("mt-nodes", f'{middle} font-size="{n(SIZE)}"', _boxes(tree, prefix))
    yield from _group("mt-links", 'stroke-linejoin="round"', links(tree))
    yield from _group("mt-marks", f'stroke-width="1" {middle} {small}', marks(tree))
    yield from _group("mt-words", f'{middle} font-size="{n(LINK_SIZE)}"', words_on_links(tree))
    yield from _group("mt-legend", small, legend_lines(legend, MARGIN, tree.rows.height - MARGIN / 2))
    yield "</svg>"


def _boxes(tree: Placed, prefix: str) -> Iterator[str]:
    for index, (node, card) in enumerate(zip(tree.shape.nodes, tree.cards, strict=True)):
        yield from box(node, card, tree.rows.x[index], tree.rows.y[index], prefix)


def _group(name: str, style: str, content: Iterable[str]) -> Iterator[str]:
    lines = list(content)
    if lines:
        yield f'<g class="{name}" {style}>'
        yield from lines
        yield "</g>"
