"""From a tree to a page of it: boxes, levels, ways of links, rows, forks."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from missiontree.reporting.tree.blocks import Blocks, blocks_of
from missiontree.reporting.tree.cards import Card, card_of
from missiontree.reporting.tree.forks import Fork, forks_of, gaps
from missiontree.reporting.tree.layout import Layout
from missiontree.reporting.tree.links import Arrow, draw
from missiontree.reporting.tree.router import Router
from missiontree.reporting.tree.rows import Rows, even_columns, lay_out, set_rows
from missiontree.reporting.tree.shape import Shape


@dataclass(frozen=True, slots=True)
class Draft:
    """
    A tree laid out from left to right.

    Parameters
    ----------
    shape
        The tree.
    blocks, cards
        What is laid out, and the boxes.
    layout
        Levels and places of the blocks.
    """

    shape: Shape
    blocks: Blocks
    cards: Sequence[Card]
    layout: Layout


@dataclass(frozen=True, slots=True)
class Placed:
    """
    A tree with everything at its place.

    Parameters
    ----------
    shape, cards
        The tree and its boxes.
    rows
        Where the boxes stand.
    forks
        Where the edges run.
    arrows
        The links, in their order.
    """

    shape: Shape
    cards: Sequence[Card]
    rows: Rows
    forks: Sequence[Fork]
    arrows: Sequence[Arrow]


def draft_of(shape: Shape) -> Draft:
    """Lay a tree out from left to right."""
    blocks = blocks_of(shape)
    cards = even_columns([card_of(node) for node in shape.nodes], blocks)
    return Draft(shape, blocks, cards, lay_out(shape, cards, blocks))


def placed(draft: Draft, least_width: float = 0.0) -> Placed:
    """
    Give everything its place.

    Parameters
    ----------
    draft
        The tree.
    least_width
        How wide the page is at least.
    """
    shape, blocks, cards, layout = draft.shape, draft.blocks, draft.cards, draft.layout
    router = Router(shape, blocks, layout, cards)
    routes = router.routes()
    rooms = gaps(shape, blocks, layout, cards, router.lanes)
    rows = set_rows(layout, cards, blocks, rooms, router.lanes.keys(), least_width)
    forks = forks_of(shape, rows, cards)
    forked = frozenset(rows.level[fork.node] for fork in forks)
    return Placed(shape, cards, rows, forks, draw(routes, rows, cards, rows.x[0] - layout.x[0], forked))
