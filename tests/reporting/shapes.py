"""Random trees to be shown, links between them included."""

from hypothesis import strategies as st

from missiontree.mission.tree import LINK_KINDS
from missiontree.reporting.tree_shape import Shape, ShapeNode

LABELS = (
    "Search(Child)",
    "Report detection of Child to server",
    "母を見つける",
    "A",
    "Reunite the Child with Mom in time",
)


@st.composite
def shapes(draw: st.DrawFn, most: int = 25) -> Shape:
    """Trees with up to so many nodes, and up to eight links of any kind."""
    size = draw(st.integers(1, most))
    children: list[list[int]] = [[] for _ in range(size)]
    parents = [-1, *(draw(st.integers(0, node - 1)) for node in range(1, size))]
    for node in range(1, size):
        children[parents[node]].append(node)
    nodes = []
    for node in range(size):
        label = draw(st.sampled_from(LABELS))
        if children[node]:
            nodes.append(ShapeNode(f"n{node}", label, "", "task", draw(st.sampled_from(("and", "xor")))))
        else:
            nodes.append(ShapeNode(f"n{node}", label, "", draw(st.sampled_from(("routine", "action", "task"))), None))
    ends = st.tuples(st.integers(0, size - 1), st.integers(0, size - 1), st.sampled_from(LINK_KINDS))
    links = [link for link in draw(st.lists(ends, max_size=8)) if not _contains(parents, link[0], link[1])]
    frames = draw(st.sets(st.sampled_from(children[0]))) if children[0] else set()
    return Shape(tuple(nodes), tuple(map(tuple, children)), tuple(links), tuple(sorted(frames)))


def _contains(parents: list[int], first: int, second: int) -> bool:
    """Whether one of two nodes stands above the other, or is the other."""
    for inner, outer in ((first, second), (second, first)):
        node = inner
        while node >= 0:
            if node == outer:
                return True
            node = parents[node]
    return False
