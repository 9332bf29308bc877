"""The peer reads the same job shop as missiontree does, without it."""

from __future__ import annotations

from random import Random

from benchmarks.peer_pyjobshop import jobs_of
from missiontree.formats.importers.fjsp import shop_of
from missiontree.mission.columns import LEAF, XOR


def test_both_read_the_same_operations() -> None:
    """Operation by operation, in order: the same machines, numbered from 0, and the same times."""
    luck = Random(5)  # noqa: S311 - luck for tests, not for secrets
    for _ in range(20):
        lines = ["3 4 2.5"]
        for _ in range(3):
            operations = []
            for _ in range(luck.randint(1, 3)):
                able = luck.sample(range(4), luck.randint(1, 4))
                operations.append(" ".join([str(len(able)), *(f"{machine} {luck.randint(1, 9)}" for machine in able)]))
            lines.append(" ".join([str(len(operations)), *operations]))
        text = "\n".join(lines) + "\n\n"
        jobs, machines = jobs_of(text)
        tree = shop_of(text)
        ways: dict[int, list[tuple[int, int]]] = {node: [] for node, kind in enumerate(tree.kind) if kind == XOR}
        for node, kind in enumerate(tree.kind):
            if kind == LEAF:
                ways.setdefault(tree.parent[node] if tree.parent[node] in ways else node, []).append(
                    (tree.robot[node], tree.duration[node])
                )
        assert machines == tree.robots
        assert sorted(map(sorted, ways.values())) == sorted(sorted(one) for job in jobs for one in job)
