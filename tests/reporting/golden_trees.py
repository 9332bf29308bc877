"""Trees whose pictures are kept: the paper's five missions, and a large, a deep and a wide one."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import cache, partial

from missiontree import plan
from missiontree.mission.plan import Plan
from missiontree.mission.tree import LINK_KINDS, Gate, Link, MissionNode, MissionTree
from missiontree.reporting.tree.view import tree_svg
from missiontree.samples.catalogue import PAPER, sample_file

PLACES = ("north hall", "east corridor", "pump room", "loading dock", "archive", "gate", "tower crane")


@cache
def planned(name: str) -> Plan:
    """The plan of a sample mission."""
    return plan(sample_file(name))


def pictures() -> Iterator[tuple[str, Callable[[], str]]]:
    """Names of files, and how their content is made."""
    for name in PAPER:
        yield f"tree-{name}.svg", partial(_tree, name)
        if name != "restaurants":  # nothing can be done there, so nothing is chosen
            yield f"tree-{name}-alternative-1.svg", partial(_tree, name, 1)
            yield f"tree-{name}-unfolded-2.svg", partial(_tree, name, 2, unfolded=True)
    yield "tree-large.svg", lambda: tree_svg(large(), most=160)
    yield "tree-deep.svg", lambda: tree_svg(deep())
    yield "tree-wide.svg", lambda: tree_svg(wide())


def _tree(name: str, rank: int | None = None, unfolded: bool = False) -> str:
    made = planned(name)
    assert made.tree is not None
    return tree_svg(made.tree, plan=made, rank=rank, unfolded=unfolded)


def large() -> MissionTree:
    """781 nodes: five parts each, four levels deep."""
    nodes: list[MissionNode] = []
    stack = [("n", 0)]
    while stack:
        name, depth = stack.pop()
        parts = [f"{name}-{number}" for number in range(1, 6 if depth < 4 else 1)]
        place = PLACES[sum(map(ord, name)) % len(PLACES)]
        if parts:
            gate: Gate = "xor" if depth % 3 == 2 else "and"
            nodes.append(MissionNode(id=name, label=f"Secure the {place}", gate=gate, children=tuple(parts)))
        else:
            nodes.append(_search(name, place))
        stack += [(part, depth + 1) for part in reversed(parts)]
    links = (Link("n-1", "n-2"), Link("n-2", "n-3"), Link("n-3-1", "n-3-3"), Link("n-4", "n-5", "until"))
    return MissionTree(objective="Secure the whole site", nodes=tuple(nodes), links=links)


def deep() -> MissionTree:
    """24 levels, each with a routine before what is below."""
    nodes: list[MissionNode] = []
    depth = 24
    for level in range(depth):
        children = (f"r{level}", f"t{level + 1}") if level < depth - 1 else (f"r{level}",)
        gate: Gate = "xor" if level % 4 == 3 else "and"
        nodes.append(MissionNode(id=f"t{level}", label=f"Go {level + 1} floors down", gate=gate, children=children))
        nodes.append(_search(f"r{level}", PLACES[level % len(PLACES)]))
    links = (Link("r0", "t1"), Link("r2", "r9", "same_robot"), Link("r20", "r4"), Link("r11", "r12", "different_robot"))
    return MissionTree(objective="Go down", nodes=tuple(nodes), links=links)


def wide() -> MissionTree:
    """Sixty parts side by side, in columns, with links of every kind."""
    parts = [
        _search(f"r{number}", f"{PLACES[number % len(PLACES)]} {number // len(PLACES) + 1}") for number in range(60)
    ]
    root = MissionNode(id="root", label="Search everywhere", gate="and", children=tuple(part.id for part in parts))
    links = [Link(f"r{number}", f"r{number + 1}") for number in (0, 1, 2, 9)]
    links += [Link(f"r{5 + 7 * place}", f"r{17 + 9 * place}", kind) for place, kind in enumerate(LINK_KINDS)]
    return MissionTree(objective="Search everywhere", nodes=(root, *parts), links=tuple(links))


def _search(name: str, place: str) -> MissionNode:
    return MissionNode(
        id=name, label=f"Search({place})", routine="Search", arguments={"agent": place.replace(" ", "_")}
    )
