"""
The k best ways through a bare AND/XOR tree in arrays, proven: for trees of any size that nothing couples.

At most k - 1 options can matter. The best way through an option that the best way of all does not take earns a known amount less, and
different options have different best ways. Order the options as their best ways stand in the order of alternatives: whoever takes an
option behind the first k - 1 is behind the ways of these and the best of all, hence not among the k best. One sweep up and one down
find the losses, and what is left is small, however large or however tied the tree is. The sweeps run compiled where numba is
installed and the tree is in arrays.

    >>> from missiontree.allocation.arrays import TreeArrays, k_best
    >>> tree = TreeArrays(kind=[2, 0, 0, 0], parent=[-1, 0, 0, 0], utility=[0, 5, 9, 7])
    >>> [(way.utility, list(way.chosen)) for way in k_best(tree, 2).ways]
    [(9, [2]), (7, [3])]
"""

from missiontree.allocation.arrays.best import Way, Ways, k_best
from missiontree.allocation.arrays.tree import TreeArrays

__all__ = ["TreeArrays", "Way", "Ways", "k_best"]
