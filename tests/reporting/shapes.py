"""Random trees to be shown: every kind of node, robots on them, one alternative lit or none, links and frames."""

from __future__ import annotations

from random import Random

from hypothesis import strategies as st

from missiontree.mission.tree import LINK_KINDS, LinkKind
from missiontree.reporting.palette import livery
from missiontree.reporting.tree.shape import Badge, Shape, ShapeKind, ShapeNode, State

LABELS = (
    "Search(Child)",
    "Report detection of Child to server",
    "母を見つける",
    "A",
    "Reunite the Child with Mom in time",
    "ReachAndTransport(Injured_person_in_the_northern_corridor, Assembly_point)",
)
LEAVES: tuple[ShapeKind, ...] = ("routine", "action", "action", "task", "impossible")
TEAMS = (
    (),
    (),
    (Badge("Tele-Robot · 2", livery(1)),),
    tuple(Badge(f"Transportation Robot {number}", livery(number)) for number in range(6)),
)


def shapes(most: int = 25, links: int = 8) -> st.SearchStrategy[Shape]:
    """Trees with up to so many nodes, and up to so many links of any kind; size and luck are drawn apart, so that sizes shrink."""
    seeds = st.integers(0, 2**32 - 1).map(Random)
    return st.builds(random_shape, seeds, st.integers(1, most), st.integers(0, links))


def random_shape(rng: Random, size: int, links: int) -> Shape:
    """A tree of that size, with links of any kind between nodes neither of which contains the other."""
    reach = rng.choice((1, 3, 12, size))  # from chains to bushes
    parents = [-1, *(rng.randint(max(0, node - reach), node - 1) for node in range(1, size))]
    children = children_of(parents)
    has_chosen, nodes = rng.random() < 0.5, list[ShapeNode]()
    for node in range(size):
        above: State = "plain" if not has_chosen else nodes[parents[node]].state if node else "lit"
        nodes.append(_node(rng, node, bool(children[node]), _state(rng, above)))
    found: list[tuple[int, int, LinkKind]] = []
    for _ in range(links):
        first = rng.randrange(size)
        second = rng.choice((rng.randrange(size), min(first + 1, size - 1)))
        if not _contains(parents, first, second):
            found.append((first, second, rng.choice(LINK_KINDS)))
    frames = [child for child in children[0] if rng.random() < 0.3]
    return Shape(tuple(nodes), tuple(map(tuple, children)), tuple(found), tuple(frames))


def _node(rng: Random, number: int, has_children: bool, state: State) -> ShapeNode:
    name, label, team = f"n{number}", rng.choice(LABELS), rng.choice(TEAMS)
    if has_children:
        return ShapeNode(name, label, "", "task", rng.choice(("and", "and", "xor")), None, team, state)
    kind = rng.choice(LEAVES)
    role = rng.choice((0, 0, 1)) if kind == "action" else None
    return ShapeNode(name, label, rng.choice(("", "no routine yet")), kind, None, role, team, state)


def _state(rng: Random, above: State) -> State:
    """What is below something that is not chosen is not chosen either."""
    return "quiet" if above == "lit" and rng.random() < 0.3 else above


def children_of(parents: list[int]) -> list[list[int]]:
    """Children of each node, in order."""
    children: list[list[int]] = [[] for _ in parents]
    for node, parent in enumerate(parents):
        if parent >= 0:
            children[parent].append(node)
    return children


def _contains(parents: list[int], first: int, second: int) -> bool:
    """Whether one of two nodes stands above the other, or is the other."""
    for inner, outer in ((first, second), (second, first)):
        node = inner
        while node >= 0:
            if node == outer:
                return True
            node = parents[node]
    return False
