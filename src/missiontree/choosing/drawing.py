"""Alternatives in the order of their utility, of those that could end by some time as far as allocation can tell."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace

from missiontree.allocation.aimed import reaching
from missiontree.allocation.flat import Flat, flatten
from missiontree.allocation.kbest import ExactKBest
from missiontree.allocation.possible import structurally_possible
from missiontree.allocation.soonest import soonest_end
from missiontree.allocation.timing import timing_of
from missiontree.mission.aim import Aim
from missiontree.mission.alternative import Alternative, selected_leaves
from missiontree.mission.brief import MissionBrief
from missiontree.mission.control import Control
from missiontree.mission.estimate import MICRO
from missiontree.mission.grounded import GroundedTree
from missiontree.mission.search_limit import SearchLimit
from missiontree.mission.ticks import seconds, ticks_within

FIRST_DRAWN = 4
MOST_EXAMINED, MOST_NODES = 20_000, (2_000_000, 20_000)
"""What a single search of allocation may take: far less than a ranking, since there are many of them."""
_LATEST = 10**15  # ticks: later than anything ends


class Draws:
    """
    Where alternatives are drawn from, by the exact allocator.

    Parameters
    ----------
    tree
        The mission over the fleet.
    brief
        Fleet, weights, terms, and how utilities add up. That teams are to differ plays no part.
    control
        Limits of every single search.
    worth
        What each leaf counts instead of its utility, in millionths. Default: its utility.
    """

    def __init__(
        self, tree: GroundedTree, brief: MissionBrief, control: Control, worth: Mapping[int, int] | None = None
    ) -> None:
        self._tree, self._brief, self._control = tree, brief, control
        flat = flatten(tree, brief.fleet, brief.weights, brief.terms)
        self._utility = None if worth is None else flat.utility
        if worth is not None:
            flat = replace(flat, utility=tuple(worth.get(node, 0) for node in range(len(flat.kind))))
        self._flat = flat
        self._allocate = reaching(
            Aim(accumulate=brief.accumulate),
            ExactKBest(max_examined=MOST_EXAMINED, max_nodes=MOST_NODES, explain=False),
        )

    def under(self, deadline: int | None) -> Line:
        """
        Alternatives that could end by a tick as far as allocation can tell, best first; None: all there are.

        Nobody who is left out has a schedule that ends by then.
        """
        flat = None if deadline is None else self._due(deadline)
        return Line(self, flat, nothing=deadline is not None and flat is None)

    def ranked(self, flat: Flat | None, wanted: int) -> tuple[tuple[Alternative, ...], bool, SearchLimit | None]:
        """The best so many, whether there are proven to be no more, and what ended the search."""
        brief = self._brief
        found = self._allocate(self._flat if flat is None else flat, brief.fleet, brief.weights, wanted, self._control)
        alternatives = tuple(self._restated(one) for one in found.alternatives)
        if found.status not in {"exact", "infeasible"}:
            return alternatives, False, found.certificate.limit or SearchLimit("candidates", wanted)
        return alternatives, len(alternatives) < wanted, None

    def _restated(self, alternative: Alternative) -> Alternative:
        """With the utility that it has for the mission, by whatever it was drawn."""
        if self._utility is None:
            return alternative
        leaves = selected_leaves(self._tree, alternative.choices)
        return replace(alternative, utility=sum(self._utility[leaf] for leaf in leaves) / MICRO)

    def soonest(self) -> int:
        """A tick before which no alternative ends, whatever is chosen."""
        flat = self._due(_LATEST)
        return 0 if flat is None else soonest_end(flat, structurally_possible(flat))

    def _due(self, deadline: int) -> Flat | None:
        """The problem with a deadline of the whole mission; None if it is due before it may begin."""
        root = self._tree.nodes[0]
        if root.deadline_s is not None:
            deadline = min(deadline, ticks_within(root.deadline_s))
        if deadline < 0 or seconds(deadline) < root.release_s:
            return None
        due = replace(root, deadline_s=seconds(deadline))
        tree = replace(self._tree, nodes=(due, *self._tree.nodes[1:]))
        return replace(self._flat, timing=timing_of(tree))


class Line:
    """
    Alternatives as they are drawn, more and more at a time.

    Attributes
    ----------
    whole
        Whether all there are were drawn, and that is proven. It is known when nothing more comes.
    limit
        What ended the drawing before that.
    """

    def __init__(self, draws: Draws, flat: Flat | None, nothing: bool = False) -> None:
        self._draws, self._flat = draws, flat
        self.whole = nothing
        self.limit: SearchLimit | None = None

    def __iter__(self) -> Iterator[Alternative]:
        drawn, wanted = 0, FIRST_DRAWN
        while not self.whole and self.limit is None:
            found, whole, limit = self._draws.ranked(self._flat, wanted)
            yield from found[drawn:]
            drawn, wanted = len(found), 2 * wanted
            self.whole, self.limit = whole, limit
