"""
The tree boiled down to what is left to choose: settled parts, pairs and picks.

What has no choice in it becomes one number with its uses; nested ANDs become one, and a wide AND a chain of pairs; an XOR with
one possible child disappears. Children come before parents, and the last part is the whole mission.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

from missiontree.allocation.flat import Flat
from missiontree.allocation.purses import Purses, Uses

Way = dict[int, int]  # index of the option taken, by reached pick


@dataclass(frozen=True, slots=True)
class Option:
    """
    One thing to pick.

    Parameters
    ----------
    part
        What is done then.
    xor, place, child
        The XOR, the position of the child among all its children, and the child's node.
    """

    part: int
    xor: int
    place: int
    child: int


@dataclass(frozen=True, slots=True)
class Core:
    """
    Columns over parts.

    Parameters
    ----------
    utility, uses
        Of a settled part, in millionths and in units of the purses.
    pair
        The two parts of a pair; None for others.
    options
        Of a pick; empty for others.
    """

    utility: list[int] = field(default_factory=list)
    uses: list[Uses] = field(default_factory=list)
    pair: list[tuple[int, int] | None] = field(default_factory=list)
    options: list[tuple[Option, ...]] = field(default_factory=list)

    def __len__(self) -> int:
        return len(self.utility)

    def add(
        self,
        utility: int = 0,
        uses: Uses = (),
        pair: tuple[int, int] | None = None,
        options: tuple[Option, ...] = (),
    ) -> int:
        """Add a part; its number."""
        self.utility.append(utility)
        self.uses.append(uses)
        self.pair.append(pair)
        self.options.append(options)
        return len(self.utility) - 1

    def end_at(self, top: int) -> None:
        """Make a part the last, which stands for the whole; what comes behind it belongs to subtrees that turned out impossible."""
        for column in (self.utility, self.uses, self.pair, self.options):
            del column[top + 1 :]

    def way_under(self, top: int, picked: Sequence[int] | Way) -> tuple[Way, int, dict[int, int]]:
        """The way that takes the picked options below a part: its picks, its utility, its use by purse."""
        way, utility, used = Way(), 0, dict[int, int]()
        stack = [top]
        while stack:
            part = stack.pop()
            pair = self.pair[part]
            if pair is not None:
                stack += pair
            elif self.options[part]:
                way[part] = picked[part]
                stack.append(self.options[part][picked[part]].part)
            else:
                utility += self.utility[part]
                for purse, amount in self.uses[part]:
                    used[purse] = used.get(purse, 0) + amount
        return way, utility, used

    def taken(self, way: Way) -> dict[int, int]:
        """Position of the chosen child by XOR node."""
        options = (self.options[pick][index] for pick, index in way.items())
        return {option.xor: option.place for option in options}


@dataclass(slots=True)
class _Bundle:
    """What a subtree consists of: settled sums, and parts with a choice."""

    utility: int
    uses: dict[int, int]
    open: list[int]


def core_of(flat: Flat, possible: Sequence[bool], purses: Purses) -> Core:
    """Boil down a tree whose root is possible."""
    core, bundles = Core(), dict[int, _Bundle]()
    for node in range(len(flat.kind) - 1, -1, -1):
        below = [(place, child) for place, child in enumerate(flat.children[node]) if child in bundles]
        if not possible[node]:
            for _, child in below:
                del bundles[child]
        elif flat.kind[node] == "action":
            bundles[node] = _Bundle(flat.utility[node], dict(purses.of_leaf(flat, node)), [])
        elif flat.kind[node] == "and":
            bundles[node] = _together([bundles.pop(child) for _, child in below])
        elif len(below) == 1:
            bundles[node] = bundles.pop(below[0][1])
        else:
            options = [Option(_part(core, bundles.pop(child)), node, place, child) for place, child in below]
            bundles[node] = _Bundle(0, {}, [core.add(options=tuple(options))])
    core.end_at(_part(core, bundles[0]))
    return core


def _together(bundles: list[_Bundle]) -> _Bundle:
    if not bundles:
        return _Bundle(0, {}, [])
    whole = max(bundles, key=lambda bundle: len(bundle.uses) + len(bundle.open))
    for bundle in bundles:
        if bundle is not whole:
            whole.utility += bundle.utility
            whole.open += bundle.open
            for purse, amount in bundle.uses.items():
                whole.uses[purse] = whole.uses.get(purse, 0) + amount
    return whole


def _part(core: Core, bundle: _Bundle) -> int:
    parts = sorted(bundle.open)[::-1]  # higher numbers stand earlier in the tree
    if bundle.utility or bundle.uses or not parts:
        parts.insert(0, core.add(bundle.utility, tuple(sorted(bundle.uses.items()))))
    whole = parts[0]
    for part in parts[1:]:
        whole = core.add(pair=(whole, part))
    return whole
