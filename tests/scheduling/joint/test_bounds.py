"""Paths and loads: by hand, and never above what can be done."""

from __future__ import annotations

from missiontree.mission.columns import AND, LEAF, XOR
from missiontree.scheduling.joint.chains import contracted
from missiontree.scheduling.joint.loads import loads_of
from missiontree.scheduling.joint.paths import paths_of
from missiontree.scheduling.joint.problem import problem_of
from tests.scheduling.joint.small_trees import columns, drawn, least_makespan


def test_a_path_takes_the_least_of_every_choice() -> None:
    """Leaf 2 (3 s), then the XOR of 5 s and 4 s: 7 s; before leaf 2 nothing, after it 4 s."""
    tree = columns([AND, XOR, LEAF, LEAF, LEAF], [-1, 0, 0, 1, 1], [0, 0, 0, 0, 1], [0, 0, 3, 5, 4], [(2, 1)])
    paths = paths_of(problem_of(tree))
    assert (paths.bound, paths.head, paths.rest) == (7, [0, 3, 0, 3, 3], [7, 4, 7, 5, 4])


def test_an_order_with_a_way_that_need_not_be_taken_does_not_lengthen_the_path() -> None:
    """Leaf 4 comes after leaf 2, but the XOR may take leaf 3 instead of leaf 2."""
    tree = columns([AND, XOR, LEAF, LEAF, LEAF], [-1, 0, 1, 1, 0], [0, 0, 0, 0, 1], [0, 0, 5, 5, 4], [(2, 4)])
    paths = paths_of(problem_of(tree))
    assert (paths.bound, paths.head[4], paths.rest[2]) == (5, 0, 9)


def test_the_load_is_shared_by_the_best_prices() -> None:
    """Three tasks, 4 s on either robot: 12 s of work for two, so 6 s by load; whole tasks need 8."""
    tree = columns(
        [AND] + [XOR] * 3 + [LEAF] * 6, [-1, 0, 0, 0, 1, 1, 2, 2, 3, 3], [0] * 4 + [0, 1] * 3, [0] * 4 + [4] * 6
    )
    problem = problem_of(tree)
    paths = paths_of(problem)
    assert paths.bound == 4
    assert loads_of(problem, paths, 4, 100, lambda: False).bound == 6


def test_no_bound_is_above_the_optimum() -> None:
    for seed in range(2000, 2080):
        tree = drawn(seed, leaves=5)
        best = least_makespan(tree)
        if best is None:
            continue
        problem = problem_of(tree)
        for looked_at in (problem, contracted(problem).problem):
            paths = paths_of(looked_at)
            assert paths.bound <= best
            assert loads_of(looked_at, paths, paths.bound, best + 5, lambda: False).bound <= best
            assert loads_of(looked_at, paths, paths.bound, best, lambda: False).bound <= best


def test_a_chain_of_one_robot_becomes_one_leaf_and_a_branching_one_does_not() -> None:
    kind, parent = [AND, AND, LEAF, LEAF, AND, LEAF, LEAF], [-1, 0, 1, 1, 0, 4, 4]
    tree = columns(kind, parent, [0] * 7, [0, 0, 2, 3, 0, 4, 5], [(2, 3)], robots=1)
    smaller = contracted(problem_of(tree))
    assert (smaller.problem.kind, smaller.problem.duration) == ([AND, LEAF, AND, LEAF, LEAF], [0, 5, 0, 4, 5])
    assert smaller.inside[1] == [2, 3]
