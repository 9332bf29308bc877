"""One way of doing a subtree, compared with another without spelling out either."""

from __future__ import annotations

LONG_DESCENT = 8


class Item:
    """
    A leaf or a settled subtree, a choice at an XOR, or two neighbouring parts of an AND.

    Items of one list (all ways of doing one subtree, best first) are compared: by utility, higher first, then by their choice
    indices in preorder. Choice vectors of one subtree are prefix-free, so two of them first differ at one place, and a single
    path leads there: into the left parts of an AND unless they are one and the same, else into the right ones; into the chosen
    child of an XOR. Where both have equal utility inside one list, their ranks in it decide and the path ends.

    Parameters
    ----------
    utility
        In millionths.
    first, second
        Parts; a choice has a first only, a settled subtree neither.
    xor, place
        For a choice: the XOR's node and the position of the chosen child; -1 otherwise.
    """

    __slots__ = ("first", "place", "rank", "remembered", "second", "utility", "xor")

    def __init__(
        self, utility: int, first: Item | None = None, second: Item | None = None, xor: int = -1, place: int = -1
    ) -> None:
        self.utility = utility
        self.first = first
        self.second = second
        self.xor = xor
        self.place = place
        self.rank = -1
        self.remembered: dict[Item, bool] | None = None

    def __lt__(self, other: Item) -> bool:
        if self.utility != other.utility:
            return self.utility > other.utility
        return _comes_first(self, other)


def _comes_first(a: Item, b: Item) -> bool:
    """Whether a's choice vector is lexicographically smaller; both are ways of doing the same subtree, and differ."""
    path: list[tuple[Item, Item]] = []
    while True:
        if a.place != b.place:
            answer = a.place < b.place
            break
        same_first = a.first is b.first
        below_a, below_b = (a.second, b.second) if same_first else (a.first, b.first)
        assert below_a is not None
        assert below_b is not None
        a, b = below_a, below_b
        if a.utility == b.utility:
            answer = a.rank < b.rank
            break
        if a.remembered is not None and b in a.remembered:
            answer = a.remembered[b]
            break
        path.append((a, b))
    # In deep trees the same long descents come back at every level; remembering a few of their steps keeps them short.
    if len(path) >= LONG_DESCENT:
        for upper, lower in path[::LONG_DESCENT]:
            if upper.remembered is None:
                upper.remembered = {}
            upper.remembered[lower] = answer
    return answer


def choices_of(item: Item) -> dict[int, int]:
    """Position of the chosen child by XOR node, for every choice in the item."""
    taken: dict[int, int] = {}
    stack: list[Item | None] = [item]
    while stack:
        part = stack.pop()
        if part is None:
            continue
        if part.xor >= 0:
            taken[part.xor] = part.place
        stack.append(part.second)
        stack.append(part.first)
    return taken
