"""What a plan says whatever its form: leaves, choices, and the order between leaves."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import combinations, product

from missiontree.evaluation.closure import closure
from missiontree.evaluation.expected import Expected, Group
from missiontree.evaluation.names import Words, scene_id, words_of
from missiontree.mission.brief import MissionBrief
from missiontree.mission.tree import IN_ORDER, MissionNode, MissionTree
from missiontree.routines.open_ended import is_open_ended

Pairs = frozenset[tuple[int, int]]


@dataclass(frozen=True, slots=True)
class Named:
    """
    Somebody or something that a leaf is about.

    Parameters
    ----------
    key
        What tells it from others of the plan: its id, or its words.
    words
        Its name, as names are compared.
    in_scene
        Whether it is an entity of the scene, whose id is the key; names do not matter then.
    label
        What people read.
    """

    key: str
    words: Words
    in_scene: bool
    label: str


@dataclass(frozen=True, slots=True)
class Leaf:
    """A routine, what it is about, and the robot types that may do it."""

    routine: str
    arguments: tuple[Named, ...]
    types: frozenset[str]

    def __str__(self) -> str:
        return f"{self.routine}({', '.join(named.label for named in self.arguments)})"


@dataclass(frozen=True, slots=True)
class Structure:
    """
    A plan in a form in which plans are compared.

    Parameters
    ----------
    leaves
        In the order of the plan; the other fields give them by place, from 0.
    shape
        Gates over leaves: nothing stands directly under a gate of its own kind, and every gate has two members or more.
    before
        The first ends before the second starts, with all that follows from it; none between leaves that exclude each other.
    until
        The first lasts until the second ends; only the latest ends, and only of leaves that have no end of their own.
    same_robot, different_robot
        Leaves that are bound to one robot, or to different ones, each pair in both directions.
    linked
        ``before`` as it is written, leaf by leaf: without what follows, and before choices are looked at.
    lasting
        ``until`` as it is written, of leaves that have no end of their own.
    """

    leaves: tuple[Leaf, ...]
    shape: Group | int
    before: Pairs
    until: Pairs
    same_robot: Pairs = frozenset()
    different_robot: Pairs = frozenset()
    linked: Pairs = frozenset()
    lasting: Pairs = frozenset()

    def within(self, leaves: frozenset[int]) -> tuple[Pairs, Pairs]:
        """``before`` and ``until`` if only these leaves are done; what follows by way of others does not bind them."""
        closed = closure({pair for pair in self.linked if leaves.issuperset(pair)})
        return frozenset(closed), _latest({pair for pair in self.lasting if leaves.issuperset(pair)}, closed)


def structure_of_expected(expected: Expected, brief: MissionBrief) -> Structure:
    """The structure of a plan as a suite writes it."""
    everybody = frozenset(brief.fleet.by_id)
    leaves = tuple(
        Leaf(
            _routine_id(call.routine, brief),
            tuple(_named(name, brief) for name in call.arguments),
            frozenset(call.by) if call.by is not None else everybody - set(call.not_by),
        )
        for call in expected.calls
    )
    pairs = {sign: {(o.first - 1, o.second - 1) for o in expected.relations if o.relation == sign} for sign in "<~"}
    return _structure(leaves, expected.shape, pairs["<"], pairs["~"], brief)


def structure_of_tree(tree: MissionTree, brief: MissionBrief) -> Structure:
    """The structure of a finished mission tree."""
    nodes = [node for node in tree.nodes if node.routine is not None]
    place = {node.id: number for number, node in enumerate(nodes)}
    below = _leaves_below(tree, place)
    pairs: dict[str, set[tuple[int, int]]] = {}
    for link in tree.links:
        pairs.setdefault(link.kind, set()).update(product(below[link.first], below[link.second]))
    bound = (
        frozenset(pair for first, second in pairs.get(kind, ()) for pair in ((first, second), (second, first)))
        for kind in ("same_robot", "different_robot")
    )
    before = set[tuple[int, int]]().union(*(pairs.get(kind, ()) for kind in IN_ORDER))
    leaves = tuple(_leaf(node, tree, brief) for node in nodes)
    shape = _shape(tree, tree.root, place)
    return _structure(leaves, shape, before, pairs.get("until", set()), brief, *bound)


def _structure(
    leaves: tuple[Leaf, ...],
    shape: Group | int,
    before: set[tuple[int, int]],
    until: set[tuple[int, int]],
    brief: MissionBrief,
    *bound: Pairs,
) -> Structure:
    flat = _flat(shape)
    apart = excluding(flat)
    closed = closure(before)
    open_ended = {(a, b) for a, b in until if _has_no_end(leaves[a], brief)}
    latest = _latest(open_ended, closed)
    same, different = bound or (frozenset(), frozenset())
    return Structure(
        leaves,
        flat,
        before=frozenset(closed - apart),
        until=latest - apart,
        same_robot=same,
        different_robot=different,
        linked=frozenset(before),
        lasting=frozenset(open_ended),
    )


def _latest(lasting: set[tuple[int, int]], before: set[tuple[int, int]]) -> Pairs:
    """Of several ends that one leaf lasts until, the latest."""
    return frozenset((a, b) for a, b in lasting if not any((a, c) in lasting for x, c in before if x == b))


def _leaf(node: MissionNode, tree: MissionTree, brief: MissionBrief) -> Leaf:
    assert node.routine is not None, "only routine nodes are leaves"
    routine = brief.routines.find(node.routine)
    names = [argument.name for argument in routine.arguments] if routine else list(node.arguments)
    labels = {entity.id: entity.label for entity in tree.entities}
    arguments: list[Named] = []
    for name in names:
        entity = node.arguments.get(name, "")
        if entity in brief.world.by_id:
            arguments.append(Named(entity, (), True, brief.world.by_id[entity].label))
        else:
            label = labels.get(entity, entity)
            shown = f"a new {label}" if scene_id(label, brief.world) else label
            arguments.append(Named(entity, words_of(label), False, shown))
    types = frozenset(brief.fleet.by_id if node.resources is None else node.resources)
    return Leaf(_routine_id(node.routine, brief), tuple(arguments), types)


def _named(name: str, brief: MissionBrief) -> Named:
    known = scene_id(name, brief.world)
    if known is not None:
        return Named(known, (), True, brief.world.by_id[known].label)
    words = words_of(name)
    return Named(" ".join(words), words, False, name)


def _routine_id(spelling: str, brief: MissionBrief) -> str:
    routine = brief.routines.find(spelling)
    return spelling if routine is None else routine.id


def _has_no_end(leaf: Leaf, brief: MissionBrief) -> bool:
    routine = brief.routines.find(leaf.routine)
    return routine is not None and is_open_ended(routine, brief.routines)


def _leaves_below(tree: MissionTree, place: dict[str, int]) -> dict[str, list[int]]:
    below: dict[str, list[int]] = {}
    for node in reversed(tree.nodes):  # preorder, so children come before their parent
        own = [place[node.id]] if node.id in place else []
        below[node.id] = own + [leaf for child in node.children for leaf in below[child]]
    return below


def _shape(tree: MissionTree, node: MissionNode, place: dict[str, int]) -> Group | int:
    if node.id in place:
        return place[node.id]
    members = tuple(_shape(tree, tree.by_id[child], place) for child in node.children)
    return Group(node.gate or "and", members)


def _flat(shape: Group | int) -> Group | int:
    """The same choices without gates that say nothing: one member only, or under a gate of the same kind."""
    if isinstance(shape, int):
        return shape
    members: list[Group | int] = []
    for member in map(_flat, shape.members):
        same = isinstance(member, Group) and member.gate == shape.gate
        members += member.members if same and isinstance(member, Group) else [member]
    return members[0] if len(members) == 1 else Group(shape.gate, tuple(members))


def excluding(shape: Group | int) -> Pairs:
    """Pairs of leaves of which a choice takes one at most, in both directions."""
    return frozenset(_excluding(shape))


def _excluding(shape: Group | int) -> Iterator[tuple[int, int]]:
    if isinstance(shape, int):
        return
    for member in shape.members:
        yield from _excluding(member)
    if shape.gate == "xor":
        for one, other in combinations(shape.members, 2):
            for first, second in product(leaves_in(one), leaves_in(other)):
                yield first, second
                yield second, first


def leaves_in(shape: Group | int) -> Iterator[int]:
    """Places of the leaves below a gate."""
    if isinstance(shape, int):
        yield shape
        return
    for member in shape.members:
        yield from leaves_in(member)
