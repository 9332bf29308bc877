"""How near a mission tree comes to a plan that was expected, from 0 to 1."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from itertools import islice, permutations, product

from missiontree.evaluation.differences import Key, leaf_key
from missiontree.evaluation.expected import Expected
from missiontree.evaluation.names import pairings
from missiontree.evaluation.structure import Pairs, Structure, excluding, structure_of_expected, structure_of_tree
from missiontree.mission.brief import MissionBrief
from missiontree.mission.tree import MissionTree

_MOST_PAIRINGS = 200
_MOST_WAYS = 5_000


def score(expected: Expected, tree: MissionTree, brief: MissionBrief) -> float:
    """
    How near a tree comes to a plan: 1 if it says the same, 0 if nothing in it does.

    Both say a number of things: each routine with its arguments is one; each routine that not all robot types may do; each two
    routines that exclude each other; each order between two routines that does not follow from others, each *until*, and each two
    routines that are bound to one robot or to different ones. With P the share of what the tree says that the plan says, too, and
    R the share of what the plan says that the tree says, too, the score is 2PR / (P + R). Names and equal routines are matched so
    that it is highest; 200 ways to match names and 5,000 ways in all are tried at most.

    Parameters
    ----------
    expected
        The plan that was expected.
    tree
        The tree that an author made, finished.
    brief
        What the author was given; its fleet and scene say what robot types and names mean.
    """
    wanted, got = structure_of_expected(expected, brief), structure_of_tree(tree, brief)
    everybody = frozenset(brief.fleet.by_id)
    said, heard = _Said(wanted, everybody), _Said(got, everybody)
    best = 0.0
    for way in islice(_ways(wanted, got), _MOST_WAYS):
        back = {here: there for there, here in way.items()}
        best = max(best, _mean(heard.share_in(said, way), said.share_in(heard, back)))
        if best == 1:
            break
    return best


def _mean(precision: float, recall: float) -> float:
    return 2 * precision * recall / (precision + recall) if precision + recall else 0.0


class _Said:
    """What a plan says, thing by thing."""

    def __init__(self, plan: Structure, everybody: frozenset[str]) -> None:
        self._leaves = plan.leaves
        self._restricted = [place for place, leaf in enumerate(plan.leaves) if leaf.types != everybody]
        self._all = _Pairs(excluding(plan.shape), plan.before, plan.until, plan.same_robot, plan.different_robot)
        self._told = _Pairs(
            _one_way(self._all.apart),
            _not_following(plan.before),
            plan.until,
            _one_way(plan.same_robot),
            _one_way(plan.different_robot),
        )

    def share_in(self, other: _Said, way: Mapping[int, int]) -> float:
        """Share of what is said here that is said there, too; ``way`` is from places here to places there."""
        same = len(way)
        same += sum(
            place in way and self._leaves[place].types == other._leaves[way[place]].types for place in self._restricted
        )
        count = len(self._leaves) + len(self._restricted)
        for told, known in zip(self._told, other._all, strict=True):
            same += sum(a in way and b in way and (way[a], way[b]) in known for a, b in told)
            count += len(told)
        return same / count


@dataclass(frozen=True, slots=True)
class _Pairs:
    """Pairs of leaves, by what they say."""

    apart: Pairs
    before: Pairs
    until: Pairs
    same_robot: Pairs
    different_robot: Pairs

    def __iter__(self) -> Iterator[Pairs]:
        return iter((self.apart, self.before, self.until, self.same_robot, self.different_robot))


def _one_way(pairs: Pairs) -> Pairs:
    return frozenset(pair for pair in pairs if pair[0] < pair[1])


def _not_following(before: Pairs) -> Pairs:
    """The order without what follows by way of others."""
    after: dict[int, set[int]] = {}
    for first, second in before:
        after.setdefault(first, set()).add(second)
    further = {first: set().union(*(after.get(second, ()) for second in later)) for first, later in after.items()}
    return frozenset((first, second) for first, second in before if second not in further[first])


def _ways(wanted: Structure, got: Structure) -> Iterator[dict[int, int]]:
    """Ways to take leaves of the tree for leaves of the plan, as many as there are of each: place there to place here."""
    names = {name.key: name.words for leaf in got.leaves for name in leaf.arguments if not name.in_scene}
    asked = [name.words for leaf in wanted.leaves for name in leaf.arguments if not name.in_scene]
    want_keys = [leaf_key(leaf, None) for leaf in wanted.leaves]
    for pairs in islice(pairings(asked, names), _MOST_PAIRINGS):
        got_keys = [leaf_key(leaf, pairs) for leaf in got.leaves]
        groups = [_matchings(key, want_keys, got_keys) for key in dict.fromkeys(want_keys)]
        for parts in product(*groups):
            yield {there: here for part in parts for there, here in part}


def _matchings(key: Key, want_keys: list[Key], got_keys: list[Key]) -> list[tuple[tuple[int, int], ...]]:
    """Ways to match the leaves of one routine and the same arguments."""
    here = [place for place, each in enumerate(want_keys) if each == key]
    there = [place for place, each in enumerate(got_keys) if each == key]
    if len(there) < len(here):
        ways = (tuple(zip(there, way, strict=True)) for way in permutations(here, len(there)))
    else:
        ways = (tuple(zip(way, here, strict=True)) for way in permutations(there, len(here)))
    return list(islice(ways, _MOST_WAYS))
