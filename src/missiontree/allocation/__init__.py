"""Grounded tree to the k best alternatives."""

from missiontree.allocation.allocator import Allocator
from missiontree.allocation.exhaustive import Exhaustive
from missiontree.allocation.kbest import ExactKBest
from missiontree.allocation.pruned import Pruned

__all__ = ["ALLOCATORS", "Allocator"]

ALLOCATORS: dict[str, Allocator] = {
    "exact": ExactKBest(),
    "pruned": Pruned(),
    "pruned_as_printed": Pruned(as_printed=True),
    "exhaustive": Exhaustive(),
}
