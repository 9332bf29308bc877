"""The k best ways drawn from what can matter, and each put together from stretches that were followed once."""

from __future__ import annotations

from bisect import bisect_left
from collections import defaultdict
from collections.abc import Iterator, Mapping
from typing import NamedTuple

from missiontree.allocation.arrays.swept import Region, Swept
from missiontree.allocation.item import choices_of
from missiontree.allocation.kernel.sweeping import NOTHING
from missiontree.allocation.streams import Either, Stream, best_first, joined


class Stretch(NamedTuple):
    """
    A part of a way that was followed already, and the option that is taken behind it.

    Parameters
    ----------
    choices, leaves
        Where it stands in the columns of what was followed.
    option
        Option chosen behind it, which the best way does not take; -1 if none.
    """

    choices: slice
    leaves: slice
    option: int


class Draft(NamedTuple):
    """
    A way that is not written down yet.

    Parameters
    ----------
    utility
        What it earns.
    options
        What it takes and the best way does not, by XOR.
    """

    utility: int
    options: Mapping[int, int]


class BestWays:
    """
    The k best ways, best first.

    Parameters
    ----------
    swept
        The tree, which has a way.
    k
        How many are wanted, at least 1.

    Attributes
    ----------
    regions
        What was followed: by node at the top.
    """

    def __init__(self, swept: Swept, k: int) -> None:
        self.swept = swept
        options = swept.options(k - 1)
        self.regions: dict[int, Region] = {top: swept.follow(top) for top in (0, *sorted(options))}
        self._open: dict[int, list[int]] = defaultdict(list)  # options by XOR
        for option in sorted(options):
            self._open[int(swept.parent[option])].append(option)

    def __iter__(self) -> Iterator[Draft]:
        taken = self.swept.taken
        for item in best_first(self._stream()):
            yield Draft(item.utility, {xor: node for xor, node in choices_of(item).items() if node != taken[xor]})

    def _stream(self) -> Stream:
        """Of the whole tree, narrowed to the options that can matter."""
        swept = self.swept
        places = sorted((int(swept.at[xor]), xor) for xor in self._open)
        below: dict[int, Stream] = {}
        for top in sorted(self.regions, reverse=True):  # an option's region comes before the one that it leaves
            inside: list[tuple[int, Stream]] = []  # the first in preorder is the last
            while places and places[-1][0] >= self.regions[top].choices_from:
                place, xor = places.pop()
                taken = int(swept.taken[xor])
                under = []
                while inside and inside[-1][0] < swept.until[place]:
                    under.append(inside.pop()[1])
                branches = [
                    (taken, self._all_of(taken, under)),
                    *((option, below.pop(option)) for option in self._open[xor]),
                ]
                inside.append((place, Either(xor, sorted(branches, key=lambda branch: branch[0]))))
            below[top] = self._all_of(top, [stream for _, stream in reversed(inside)])
        return below[0]

    def _all_of(self, top: int, open_parts: list[Stream]) -> Stream:
        """Parts with a choice, in preorder, and the rest below a node."""
        settled = int(self.swept.value[top]) - sum(part.items[0].utility for part in open_parts)
        return joined(settled, open_parts)

    def stretches(self, draft: Draft) -> Iterator[Stretch]:
        """What the way consists of, in preorder."""
        swept = self.swept
        options = {int(swept.at[xor]): option for xor, option in draft.options.items()}
        places = sorted(options)
        rest = [self.regions[0]]
        while rest:
            here = rest.pop()
            after = bisect_left(places, here.choices_from)
            if after == len(places) or places[after] >= here.choices_until:
                yield Stretch(slice(*here[:2]), slice(*here[2:]), NOTHING)
                continue
            place = places[after]
            option = options[place]
            rest.append(
                Region(int(swept.until[place]), here.choices_until, int(swept.leaf_until[place]), here.leaves_until)
            )
            rest.append(self.regions[option])
            yield Stretch(slice(here.choices_from, place), slice(here.leaves_from, int(swept.leaf_from[place])), option)
