"""From a tree in arrays to its k best ways, with what is proven of them."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import islice
from typing import Any

from missiontree.allocation.arrays.column import Column, as_list
from missiontree.allocation.arrays.loops import PLAIN, Loops, fast_loops, fits
from missiontree.allocation.arrays.swept import Swept
from missiontree.allocation.arrays.tree import TreeArrays
from missiontree.allocation.arrays.ways import BestWays
from missiontree.allocation.compiled import can_compile
from missiontree.mission.certificate import Certificate

METHOD = "lazy_k_best"


@dataclass(frozen=True, slots=True, eq=False)
class Way:
    """
    A way through the tree.

    Parameters
    ----------
    utility
        Sum over its leaves, in the unit of the tree's.
    chosen
        Child taken at every reached XOR, in preorder.
    leaves
        Selected leaves, in preorder.
    """

    utility: int
    chosen: Column
    leaves: Column


@dataclass(frozen=True, slots=True, eq=False)
class Ways:
    """
    The k best ways and what is known.

    Parameters
    ----------
    ways
        Best first: by utility, then by choice indices in preorder. Fewer than k only if there are no more.
    certificate
        Proven; the bound, in the unit of the tree's utilities, holds for every way that is not listed.
    """

    ways: tuple[Way, ...]
    certificate: Certificate


def k_best(tree: TreeArrays, k: int, *, compiled: bool | None = None) -> Ways:
    """
    The k best ways through a tree in which nothing couples the choices.

    Parameters
    ----------
    tree
        The tree.
    k
        How many are wanted, at least 1.
    compiled
        Whether the sweeps run compiled, which needs numba (the extra ``fast``). Default: where numba is installed and the tree is in
        arrays. Columns of the answer are arrays then, else lists. The numbers are the same at either speed. Utilities whose sums could
        leave 61 bits are added up in plain Python whatever is said here.

    Raises
    ------
    ValueError
        If k is below 1, or if compiled sweeps are asked for and numba is not installed.
    """
    if k < 1:
        raise ValueError(f"k must be at least 1, got {k}.")
    if compiled and not can_compile():
        raise ValueError("compiled sweeps need numba: pip install 'missiontree[fast]', or leave compiled out.")
    wanted = can_compile() and tree.in_arrays if compiled is None else compiled
    quick = wanted and fits(tree.span)
    swept = _swept(tree, fast_loops() if quick else PLAIN)
    if not swept.possible:
        return Ways((), Certificate(claim="proven", method=METHOD, detail="There is no way through the tree."))
    ways = tuple(islice(_written(BestWays(swept, k)), k))
    if len(ways) < k:
        return Ways(ways, Certificate(claim="proven", method=METHOD, detail="There are no more ways."))
    detail = "Nothing that is not listed is better than the bound."
    return Ways(ways, Certificate(claim="proven", method=METHOD, bound=float(ways[-1].utility), detail=detail))


def _swept(tree: TreeArrays, loops: Loops) -> Swept:
    """The tree after the sweep up, its columns turned into such as the loops work on."""
    columns: list[Any] = [tree.kind, tree.parent, tree.utility]
    if loops is PLAIN:
        columns = [as_list(column) for column in columns]
    elif not tree.in_arrays:
        columns = [loops.column(column) for column in columns]
    return Swept(loops, *columns)


def _written(best: BestWays) -> Iterator[Way]:
    swept = best.swept
    chosen = swept.chosen()
    for draft in best:
        choices: list[Any] = []
        leaves: list[Any] = []
        for stretch in best.stretches(draft):
            choices.append(chosen[stretch.choices])
            leaves.append(swept.leaves[stretch.leaves])
            if stretch.option >= 0:
                choices.append([stretch.option])
        yield Way(draft.utility, swept.loops.joined(choices), swept.loops.joined(leaves))
