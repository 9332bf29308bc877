"""The ways of choosing that a plan leaves open: which leaves are done in each."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import islice, product

from missiontree.evaluation.expected import Group

MOST_WAYS = 1_000


def ways_of_choosing(shape: Group | int) -> tuple[frozenset[int], ...]:
    """The leaves that are done, for each way of choosing one branch of every XOR; the first thousand ways if there are more."""
    return tuple(dict.fromkeys(islice(_ways(shape), MOST_WAYS)))


def _ways(shape: Group | int) -> Iterator[frozenset[int]]:
    if isinstance(shape, int):
        yield frozenset((shape,))
        return
    leaves = frozenset(member for member in shape.members if isinstance(member, int))
    groups = [member for member in shape.members if isinstance(member, Group)]
    if shape.gate == "xor":
        yield from map(frozenset, zip(leaves, strict=True))
        for group in groups:
            yield from _ways(group)
        return
    for parts in product(*(list(islice(_ways(group), MOST_WAYS)) for group in groups)):
        yield leaves.union(*parts)
