"""In what a mission tree differs from the plan that was expected, in words."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from itertools import islice, permutations, product

from missiontree.evaluation.expected import Expected, Group
from missiontree.evaluation.names import Words, pairings
from missiontree.evaluation.structure import Leaf, Named, Pairs, Structure, structure_of_expected, structure_of_tree
from missiontree.mission.brief import MissionBrief
from missiontree.mission.tree import MissionTree

Key = tuple[str, tuple[tuple[bool, str], ...]]
_MOST_PAIRINGS = 200
_MOST_ASSIGNMENTS = 5_000


def differences(expected: Expected, tree: MissionTree, brief: MissionBrief) -> tuple[str, ...]:
    """
    What is other in the tree than in the plan that was expected; empty if the tree is right.

    Gates that say nothing, the order in which leaves are listed, and the names of tasks make no difference. Where names or equal
    leaves can be matched in several ways, the way with the fewest differences counts; 200 ways to match names and 5,000 to match
    equal leaves are tried at most.

    Parameters
    ----------
    expected
        The plan that was expected.
    tree
        The tree that an author made.
    brief
        What the author was given; its fleet and scene say what robot types and names mean.
    """
    if tree.open_leaves:
        return tuple(f"unfinished: {node.label}" for node in tree.open_leaves)
    wanted, got = structure_of_expected(expected, brief), structure_of_tree(tree, brief)
    names = {name.key: name.words for leaf in got.leaves for name in leaf.arguments if not name.in_scene}
    asked = [name.words for leaf in wanted.leaves for name in leaf.arguments if not name.in_scene]
    found = (_compared(wanted, got, pairs) for pairs in islice(pairings(asked, names), _MOST_PAIRINGS))
    return _least(found)


def _least(found: Iterator[tuple[str, ...]]) -> tuple[str, ...]:
    best: tuple[str, ...] | None = None
    for each in found:
        if not each:
            return ()
        if best is None or len(each) < len(best):
            best = each
    return best or ()


def _compared(wanted: Structure, got: Structure, pairs: dict[str, Words]) -> tuple[str, ...]:
    want_keys = [leaf_key(leaf, None) for leaf in wanted.leaves]
    got_keys = [leaf_key(leaf, pairs) for leaf in got.leaves]
    if Counter(want_keys) != Counter(got_keys):
        return tuple(_leaf_differences(wanted, got, want_keys, got_keys))
    ways = islice(_assignments(wanted, got, want_keys, got_keys), _MOST_ASSIGNMENTS)
    return _least(tuple(_under(wanted, got, way)) for way in ways)


def leaf_key(leaf: Leaf, pairs: dict[str, Words] | None) -> Key:
    """What makes leaves equal, robot types aside: the routine and its arguments, in the suite's words where ``pairs`` gives them."""
    return leaf.routine, tuple(_name_key(name, pairs) for name in leaf.arguments)


def _name_key(name: Named, pairs: dict[str, Words] | None) -> tuple[bool, str]:
    """The name in the suite's words; what none of them is meant by keeps a key that no suite can have."""
    if name.in_scene or pairs is None:
        return name.in_scene, name.key
    return False, " ".join(pairs[name.key]) if name.key in pairs else f"?{name.key}"


def _leaf_differences(wanted: Structure, got: Structure, want_keys: list[Key], got_keys: list[Key]) -> Iterator[str]:
    for words, structure, keys, others in (
        ("missing", wanted, want_keys, got_keys),
        ("not expected", got, got_keys, want_keys),
    ):
        spare = Counter(others)
        for leaf, key in zip(structure.leaves, keys, strict=True):
            if spare[key]:
                spare[key] -= 1
            else:
                yield f"{words}: {leaf}"


def _assignments(
    wanted: Structure, got: Structure, want_keys: list[Key], got_keys: list[Key]
) -> Iterator[dict[int, int]]:
    """Ways to take the leaves of the tree for those expected: place there to place here; those of the same robot types first."""
    groups: list[list[dict[int, int]]] = []
    for key in dict.fromkeys(want_keys):
        here = [place for place, each in enumerate(want_keys) if each == key]
        there = [place for place, each in enumerate(got_keys) if each == key]
        ways = [dict(zip(way, here, strict=True)) for way in islice(permutations(there), _MOST_ASSIGNMENTS)]
        groups.append(sorted(ways, key=lambda way: _misfits(wanted, got, way)))
    for parts in product(*groups):
        yield {place: number for part in parts for place, number in part.items()}


def _misfits(wanted: Structure, got: Structure, way: dict[int, int]) -> int:
    return sum(got.leaves[there].types != wanted.leaves[here].types for there, here in way.items())


def _under(wanted: Structure, got: Structure, way: dict[int, int]) -> Iterator[str]:
    """Differences if leaves are matched so."""
    for there, here in sorted(way.items(), key=lambda pair: pair[1]):
        if got.leaves[there].types != wanted.leaves[here].types:
            allowed, given = (", ".join(sorted(leaf.types)) for leaf in (wanted.leaves[here], got.leaves[there]))
            yield f"robot types of {wanted.leaves[here]}: expected {allowed}; got {given}"
    if _unordered(wanted.shape, None) != _unordered(got.shape, way):
        yield f"choices: expected {_shown(wanted.shape, wanted)}; got {_shown(got.shape, got)}"
    for words, own, other in (
        ("{0} before {1}", wanted.before, got.before),
        ("{0} until the end of {1}", wanted.until, got.until),
        ("{0} and {1} by the same robot", wanted.same_robot, got.same_robot),
        ("{0} and {1} by different robots", wanted.different_robot, got.different_robot),
    ):
        yield from _relation_differences(words, own, frozenset((way[a], way[b]) for a, b in other), wanted)


def _relation_differences(words: str, own: Pairs, other: Pairs, wanted: Structure) -> Iterator[str]:
    for prefix, pairs in (("missing order", own - other), ("order not expected", other - own)):
        for first, second in sorted(pairs):
            yield f"{prefix}: {words.format(wanted.leaves[first], wanted.leaves[second])}"


def _unordered(shape: Group | int, way: dict[int, int] | None) -> object:
    """A form that is equal for equal choices."""
    if isinstance(shape, int):
        return shape if way is None else way[shape]
    return shape.gate, frozenset(_unordered(member, way) for member in shape.members)


def _shown(shape: Group | int, structure: Structure) -> str:
    if isinstance(shape, int):
        return str(structure.leaves[shape])
    return f"{shape.gate}({', '.join(_shown(member, structure) for member in shape.members)})"
