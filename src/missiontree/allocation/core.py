"""
The tree boiled down to what is left to choose: sums and picks.

What has no choice in it becomes one number with its uses; nested ANDs become one; an XOR with one possible child disappears.
Children come before parents, and the last part is the whole mission.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import NamedTuple

from missiontree.allocation.flat import Flat, Uses
from missiontree.allocation.purses import Purses

Way = dict[int, int]  # index of the option taken, by reached pick


class Option(NamedTuple):
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
    Columns over parts, each of which is a sum or a pick.

    Parameters
    ----------
    utility, uses
        Of a sum beside its parts, in millionths and in units of the purses.
    parts
        Of a sum: what is done as well; empty if it is settled.
    options
        Of a pick; empty for others.
    forced
        Position of the child by XOR whose other children were ruled out, and which is no pick for that.
    """

    utility: list[int] = field(default_factory=list)
    uses: list[Uses] = field(default_factory=list)
    parts: list[tuple[int, ...]] = field(default_factory=list)
    options: list[tuple[Option, ...]] = field(default_factory=list)
    forced: dict[int, int] = field(default_factory=dict)

    def __len__(self) -> int:
        return len(self.utility)

    def add(
        self,
        utility: int = 0,
        uses: Uses = (),
        parts: tuple[int, ...] = (),
        options: tuple[Option, ...] = (),
    ) -> int:
        """Add a part; its number."""
        self.utility.append(utility)
        self.uses.append(uses)
        self.parts.append(parts)
        self.options.append(options)
        return len(self.utility) - 1

    def end_at(self, top: int) -> None:
        """Make a part the last, which stands for the whole; what comes behind it belongs to subtrees that turned out impossible."""
        for column in (self.utility, self.uses, self.parts, self.options):
            del column[top + 1 :]

    def parts_under(self, top: int, picked: Sequence[int] | Way) -> Iterator[int]:
        """The parts that the way which takes the picked options reaches from a part, that one first."""
        stack = [top]
        while stack:
            part = stack.pop()
            yield part
            if options := self.options[part]:
                stack.append(options[picked[part]].part)
            else:
                stack += self.parts[part]

    def way_under(self, top: int, picked: Sequence[int] | Way) -> tuple[Way, int, dict[int, int]]:
        """The way that takes the picked options below a part: its picks, its utility, its use by purse."""
        way, utility, used = Way(), 0, dict[int, int]()
        for part in self.parts_under(top, picked):
            if self.options[part]:
                way[part] = picked[part]
            else:
                utility += self.utility[part]
                for purse, amount in self.uses[part]:
                    used[purse] = used.get(purse, 0) + amount
        return way, utility, used

    def picks_under(self, top: int, picked: Sequence[int] | Way) -> Way:
        """The picks of the way that takes the picked options below a part."""
        return {part: picked[part] for part in self.parts_under(top, picked) if self.options[part]}

    def best(self) -> tuple[int, list[int]]:
        """The most utility of any way, whatever it uses; by pick, the index of the option that it takes, the first of equal ones."""
        most, taken = list(self.utility), [0] * len(self)
        for part, options in enumerate(self.options):
            if options:
                taken[part] = max(range(len(options)), key=lambda index: most[options[index].part])
                most[part] = most[options[taken[part]].part]
            else:
                most[part] += sum([most[below] for below in self.parts[part]])
        return most[-1], taken

    def sums(self) -> Sums:
        """What there is below parts that have no choice among or below them; of others, nothing yet."""
        inner = [part for part, options in enumerate(self.options) if options or self.parts[part]]
        return Sums(self, inner, list(self.utility), [dict(uses) for uses in self.uses])

    def taken(self, way: Way) -> dict[int, int]:
        """Position of the chosen child by XOR node."""
        options = (self.options[pick][index] for pick, index in way.items())
        return self.forced | {option.xor: option.place for option in options}


@dataclass(frozen=True, slots=True)
class Sums:
    """
    Utility and use below every part, of ways that take picked options.

    Parameters
    ----------
    core
        What there is to choose.
    inner
        The parts that are not settled.
    utility, used
        By part; use by purse.
    """

    core: Core
    inner: Sequence[int]
    utility: list[int]
    used: list[Mapping[int, int]]

    def under(self, picked: Sequence[int]) -> Sums:
        """The same for other picked options, for all parts in one go."""
        core, utility, used = self.core, self.utility.copy(), self.used.copy()
        for part in self.inner:
            if options := core.options[part]:
                below = options[picked[part]].part
                utility[part], used[part] = utility[below], used[below]
                continue
            earned, total = core.utility[part], dict(core.uses[part])
            for below in core.parts[part]:
                earned += utility[below]
                for purse, amount in used[below].items():
                    total[purse] = total.get(purse, 0) + amount
            utility[part], used[part] = earned, total
        return Sums(core, self.inner, utility, used)


@dataclass(slots=True)
class _Bundle:
    """What a subtree consists of: settled sums, and parts with a choice."""

    utility: int
    uses: dict[int, int]
    open: list[int]


def core_of(flat: Flat, possible: Sequence[bool], purses: Purses) -> Core:
    """Boil down a tree whose root is possible."""
    core, leaf_uses, kind = Core(), purses.of_leaves(flat), flat.kind
    bundles: dict[int, _Bundle] = {}  # of inner nodes; a leaf needs none of its own where it goes into an AND

    def bundle_of(child: int) -> _Bundle:
        if kind[child] == "action":
            return _Bundle(flat.utility[child], dict(leaf_uses[child]), [])
        return bundles.pop(child)

    def option_of(xor: int, place: int, child: int) -> Option:
        bundle = bundle_of(child)
        if purses.turnouts:
            bundle.uses.update(purses.of_choice(xor, child))
        return Option(_part(core, bundle), xor, place, child)

    for node in range(len(kind) - 1, -1, -1):
        if kind[node] == "action":
            continue
        children = flat.children[node]
        if not possible[node]:
            for child in children:
                bundles.pop(child, None)
        elif kind[node] == "and":
            whole = _together([bundles.pop(child) for child in children if kind[child] != "action"])
            for child in children:
                if kind[child] == "action":
                    whole.utility += flat.utility[child]
                    _add(whole.uses, leaf_uses[child])
            bundles[node] = whole
        else:
            below = [(place, child) for place, child in enumerate(children) if possible[child]]
            if len(below) == 1:
                bundles[node] = bundle_of(below[0][1])
            else:
                options = tuple([option_of(node, place, child) for place, child in below])
                bundles[node] = _Bundle(0, {}, [core.add(options=options)])
    core.end_at(_part(core, bundle_of(0)))
    return core


def narrowed(core: Core, kept: Sequence[Sequence[int]]) -> Core:
    """
    Boil a core down further.

    Parameters
    ----------
    core
        What there is to choose; every reached pick keeps an option.
    kept
        By pick, the indices of the options that are left.
    """
    new, bundles = Core(forced=dict(core.forced)), dict[int, _Bundle]()
    for part in _reached(core, kept):
        if not core.options[part]:
            own = _Bundle(core.utility[part], dict(core.uses[part]), [])
            bundles[part] = _together([own, *(bundles.pop(below) for below in core.parts[part])])
            continue
        left = [core.options[part][index] for index in kept[part]]
        if len(left) == 1:
            new.forced[left[0].xor] = left[0].place
            bundles[part] = bundles.pop(left[0].part)
        else:
            options = [Option(_part(new, bundles.pop(one.part)), one.xor, one.place, one.child) for one in left]
            bundles[part] = _Bundle(0, {}, [new.add(options=tuple(options))])
    _part(new, bundles[len(core) - 1])
    return new


def _reached(core: Core, kept: Sequence[Sequence[int]]) -> Iterable[int]:
    seen = [False] * len(core)
    seen[-1] = True
    for part in range(len(core) - 1, -1, -1):
        if seen[part]:
            for below in core.parts[part]:
                seen[below] = True
            if core.options[part]:
                for index in kept[part]:
                    seen[core.options[part][index].part] = True
    return (part for part, there in enumerate(seen) if there)


def _together(bundles: list[_Bundle]) -> _Bundle:
    if not bundles:
        return _Bundle(0, {}, [])
    if len(bundles) == 1:
        return bundles[0]
    whole = max(bundles, key=lambda bundle: len(bundle.uses) + len(bundle.open))
    for bundle in bundles:
        if bundle is not whole:
            whole.utility += bundle.utility
            whole.open += bundle.open
            _add(whole.uses, bundle.uses.items())
    return whole


def _add(total: dict[int, int], uses: Iterable[tuple[int, int]]) -> None:
    for purse, amount in uses:
        total[purse] = total.get(purse, 0) + amount


def _part(core: Core, bundle: _Bundle) -> int:
    if len(bundle.open) == 1 and not bundle.utility and not bundle.uses:
        return bundle.open[0]
    return core.add(bundle.utility, tuple(sorted(bundle.uses.items())), tuple(sorted(bundle.open)))
