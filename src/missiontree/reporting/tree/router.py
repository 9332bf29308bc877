"""Finds the ways of the links in a drawn tree: through the room between boxes, never over one."""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Sequence
from dataclasses import dataclass, field

from missiontree.mission.tree import LinkKind
from missiontree.reporting.text_box import text_width
from missiontree.reporting.tree.blocks import Blocks
from missiontree.reporting.tree.cards import Card
from missiontree.reporting.tree.layout import Layout
from missiontree.reporting.tree.routes import LINK_SIZE, LINK_WORDS, Anchor, Route, Run, in_lanes
from missiontree.reporting.tree.rows import SIBLING_GAP, half_width, height_of
from missiontree.reporting.tree.shape import Shape

PORT, PASS, BESIDE, MOST_ASIDE = 7.0, 4.0, 8.0, 10.0


@dataclass(slots=True)
class Router:
    """
    Finds the ways of links.

    Between neighbours on a row a precedence goes straight. Everything else leaves a box downwards or upwards, or a box in a column
    sideways, runs in a lane between two rows, and passes further rows to the left of the block above (or, upwards, below) its end's branch.

    Parameters
    ----------
    shape, blocks, layout, cards
        The tree, its blocks, their places from left to right, and the boxes.
    """

    shape: Shape
    blocks: Blocks
    layout: Layout
    cards: Sequence[Card]
    lanes: Counter[int] = field(default_factory=Counter)
    _ports: Counter[tuple[int, int, bool]] = field(default_factory=Counter)
    _gutters: Counter[tuple[int, int]] = field(default_factory=Counter)
    _place: list[int] = field(default_factory=list)
    _above: list[int] = field(default_factory=list)

    def routes(self) -> list[Route]:
        """The ways of all links, in their order; ``lanes`` then counts the lanes below each level."""
        self._place, self._above = self._places(), [-1] * len(self.blocks.members)
        for block, below in enumerate(self.blocks.children):
            for child in below:
                self._above[child] = block
        straight: set[tuple[int, int]] = set()
        found = [self._route(first, second, kind, straight) for first, second, kind in self.shape.links]
        by_gap: dict[int, list[Run]] = defaultdict(list)
        for route in found:
            for run in route.runs:
                by_gap[run.gap].append(run)
        for gap, runs in by_gap.items():
            self.lanes[gap] = in_lanes(runs)
        return found

    def _places(self) -> list[int]:
        """Number of each block in its row, from the left."""
        places, seen = [0] * len(self.layout.x), Counter[int]()
        for block in sorted(range(len(places)), key=lambda block: self.layout.x[block]):
            places[block] = seen[self.layout.level[block]]
            seen[self.layout.level[block]] += 1
        return places

    def _route(self, first: int, second: int, kind: LinkKind, straight: set[tuple[int, int]]) -> Route:
        one, other = self.blocks.of[first], self.blocks.of[second]
        if one == other:
            return self._in_column(first, second, kind, straight)
        pair = (min(first, second), max(first, second))
        level = self.layout.level
        near = level[one] == level[other] and abs(self._place[one] - self._place[other]) == 1
        if kind == "precedence" and near and pair not in straight:
            straight.add(pair)
            return self._across(first, second, kind)
        ahead = 1 if self.layout.x[other] >= self.layout.x[one] else -1
        facing = -ahead if near else ahead  # from column to column there must be room for a word
        start = self._anchor(first, ahead, facing, 1 if level[one] <= level[other] else -1)
        end = self._anchor(second, -ahead, -facing, 1 if level[one] >= level[other] else -1)
        runs, x = [], start.x
        for gap, block in self._turns(one, other):
            to = end.x if block == other else self._gutter(block, -1)
            runs.append(Run(gap, x, to, (min(x, to), max(x, to))))
            x = to
        longest = max(runs, key=lambda run: abs(run.end - run.start))
        middle, half = (longest.start + longest.end) / 2, text_width(LINK_WORDS[kind], LINK_SIZE) / 2
        longest.room = (min(longest.room[0], middle - half), max(longest.room[1], middle + half))
        return Route(kind, start, end, tuple(runs))

    def _in_column(self, first: int, second: int, kind: LinkKind, straight: set[tuple[int, int]]) -> Route:
        """Straight to the next box, else round the boxes between."""
        members = self.blocks.members[self.blocks.of[first]]
        ahead = 1 if members.index(second) > members.index(first) else -1
        pair = (min(first, second), max(first, second))
        if kind == "precedence" and abs(members.index(second) - members.index(first)) == 1 and pair not in straight:
            straight.add(pair)
            x = self.layout.x[self.blocks.of[first]]
            return Route(kind, Anchor(first, x, ahead, True), Anchor(second, x, -ahead, True))
        x = self._gutter(self.blocks.of[first], 1)
        return Route(kind, self._side(first, x, 1), self._side(second, x, 1))

    def _across(self, first: int, second: int, kind: LinkKind) -> Route:
        """To a neighbour on the row: straight from box to box, or with a turn between them where one is in a column."""
        one, other = self.blocks.of[first], self.blocks.of[second]
        ahead = 1 if self._place[other] > self._place[one] else -1
        if len(self.blocks.members[one]) == len(self.blocks.members[other]) == 1:
            x = self.layout.x[one] + ahead * self.cards[first].width / 2
            return Route(kind, Anchor(first, x, ahead, False), Anchor(second, x, -ahead, False))
        # Beside the higher of both nothing else is, down to its end.
        one_is_higher = height_of(one, self.blocks, self.cards) > height_of(other, self.blocks, self.cards)
        x = self._gutter(one, ahead) if one_is_higher else self._gutter(other, -ahead)
        return Route(kind, self._side(first, x, ahead), self._side(second, x, -ahead))

    def _anchor(self, node: int, right: int, facing: int, down: int) -> Anchor:
        """Where a line leaves a box: in a column at the side it faces, else through its lower or upper edge."""
        block = self.blocks.of[node]
        if len(self.blocks.members[block]) > 1:
            return self._side(node, self._gutter(block, facing), facing)
        number = self._ports[node, 2 * right + down, True]
        self._ports[node, 2 * right + down, True] += 1
        width = self.cards[node].width
        aside = min(width / 4 + PORT * number, width / 2 - PORT)
        return Anchor(node, self.layout.x[block] + right * aside, down, True)

    def _side(self, node: int, x: float, right: int) -> Anchor:
        number = self._ports[node, right, False]
        self._ports[node, right, False] += 1
        if right < 0 and self.blocks.hangs(self.blocks.of[node]):
            number += 1  # in the middle is the edge of the tree
        most = self.cards[node].height / 2 - PASS
        return Anchor(node, x, right, False, max(-most, min(most, _zigzag(number) * BESIDE)))

    def _gutter(self, block: int, right: int) -> float:
        """Where a line passes a block, at its right (1) or left (-1): in the middle of the least room there, or close to that."""
        key = (self.layout.level[block], self._place[block] + (right > 0))
        number = self._gutters[key]
        self._gutters[key] += 1
        aside = max(-MOST_ASIDE, min(MOST_ASIDE, _zigzag(number) * PASS))
        return self.layout.x[block] + right * (half_width(block, self.blocks, self.cards) + SIBLING_GAP / 2) + aside

    def _turns(self, one: int, other: int) -> list[tuple[int, int]]:
        """Gaps to run in (the level above each), with the block to the left of which the way then goes on; last the end itself."""
        above, below = self.layout.level[one], self.layout.level[other]
        if above == below:
            return [(above, other)]
        passed = []
        if above < below:
            while self.layout.level[other] > above:
                passed.append((self.layout.level[other] - 1, other))
                other = self._above[other]
            return passed[::-1]
        block = self._above[one]
        while self.layout.level[block] > below:
            passed.append((self.layout.level[block], block))
            block = self._above[block]
        return [*passed, (below, other)]


def _zigzag(number: int) -> int:
    """0, 1, -1, 2, -2 and so on."""
    return (number + 1) // 2 * (1 if number % 2 else -1)
