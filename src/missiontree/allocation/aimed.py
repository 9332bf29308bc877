"""Which allocator is for which aim."""

from __future__ import annotations

from dataclasses import dataclass

from missiontree.allocation import ALLOCATORS
from missiontree.allocation.allocator import Allocator
from missiontree.allocation.bottleneck import LeastKBest
from missiontree.allocation.clash_wording import with_clash
from missiontree.allocation.diverse import Diverse
from missiontree.allocation.enumerated import Enumerated
from missiontree.allocation.flat import Flat, flatten
from missiontree.allocation.kbest import ExactKBest
from missiontree.allocation.means import MeanKBest
from missiontree.errors import InputError
from missiontree.mission.aim import PLAIN_AIM, Aim
from missiontree.mission.alternative import Ranking
from missiontree.mission.control import Control
from missiontree.mission.estimate import Weights
from missiontree.mission.fleet import Fleet
from missiontree.mission.grounded import GroundedTree


@dataclass(frozen=True, slots=True)
class Explained:
    """
    Seeks the limits that clash where there is no alternative: once for the mission, not in each of the searches that a ranking takes.

    Parameters
    ----------
    best
        Ranks.
    """

    best: Allocator

    def __call__(self, tree: GroundedTree | Flat, fleet: Fleet, weights: Weights, k: int, control: Control) -> Ranking:
        """See :class:`missiontree.allocation.allocator.Allocator`."""
        flat = flatten(tree, fleet, weights)
        return with_clash(self.best(flat, fleet, weights, k, control), flat, control)


def allocators_for(aim: Aim) -> dict[str, Allocator]:
    """All allocators that reach an aim, by name."""
    if aim == PLAIN_AIM:
        return dict(ALLOCATORS)
    return {"exact": Explained(reaching(aim, ExactKBest(explain=False))), "exhaustive": Enumerated(aim)}


def allocator_for(name: str, aim: Aim) -> Allocator:
    """
    An allocator that reaches an aim.

    Raises
    ------
    InputError
        If there is none of that name, or if it cannot.
    """
    if name not in ALLOCATORS:
        raise InputError(f"there is no allocator {name!r}", accepted=", ".join(ALLOCATORS))
    able = allocators_for(aim)
    if name not in able:
        raise InputError(
            f"the allocator {name!r} ranks by sums alone, and {aim.in_words} is asked for",
            accepted=" or ".join(able),
            hint="Take another allocator, or leave out accumulate and diverse.",
        )
    return able[name]


def reaching(aim: Aim, by_sum: Allocator) -> Allocator:
    """An allocator for an aim, on top of one that ranks by sums: exact if that is, proven and bounded as far as that is."""
    best = by_sum
    if aim.accumulate != "sum":
        best = MeanKBest(by_sum) if aim.accumulate == "mean" else LeastKBest(by_sum)
    return Diverse(best, aim.accumulate) if aim.diverse else best
