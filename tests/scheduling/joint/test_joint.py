"""Choice and schedule together: against everything tried, and by hand."""

from __future__ import annotations

import pytest

from benchmarks.trees import instance, text_of
from missiontree.checking.columns import check_tree
from missiontree.errors import InputError
from missiontree.formats.importers.tree_json import columns_of
from missiontree.formats.reader import parse
from missiontree.mission.columns import AND, LEAF, XOR
from missiontree.mission.control import Control
from missiontree.scheduling.joint.joint import schedule_tree
from tests.scheduling.joint.small_trees import columns, drawn, least_makespan


class Late:
    """A clock that gives every search a few looks before time is up."""

    def __init__(self) -> None:
        self.now = 0.0

    def __call__(self) -> float:
        self.now += 0.001
        return self.now


@pytest.mark.parametrize("block", range(8))
def test_without_solver_no_bound_is_false_and_no_optimum_called_so_is_missed(block: int) -> None:
    for seed in range(20 * block, 20 * block + 20):
        tree = drawn(seed, leaves=5)
        best = least_makespan(tree)
        found = schedule_tree(tree, Control(time_limit_s=0.3, clock=Late(), seed=seed), solver=False)
        assert check_tree(tree, found) == ()
        if best is None:
            assert found.status == "infeasible"
            continue
        bound = found.certificate.bound
        assert bound is not None
        assert bound <= best <= found.makespan_s
        assert found.status != "optimal" or found.makespan_s == best


def test_with_solver_every_small_tree_is_solved_and_confirmed() -> None:
    for seed in range(1000, 1020):
        tree = drawn(seed, leaves=6)
        best = least_makespan(tree)
        found = schedule_tree(tree, Control(time_limit_s=30.0, seed=seed))
        assert check_tree(tree, found) == ()
        if best is None:
            assert found.status == "infeasible"
        else:
            assert (found.status, found.certificate.claim, found.makespan_s) == ("optimal", "proven", best)


def test_bounds_raised_by_asking_are_not_above_the_optimum() -> None:
    """Nine actions of 3 s, each on either of two machines: 27 s of work, 14 s by load, and 15 s as 3 does not divide 14."""
    kind, parent = [AND] + [XOR] * 9 + [LEAF] * 18, [-1] + [0] * 9 + [1 + place // 2 for place in range(18)]
    tree = columns(kind, parent, [0] * 10 + [0, 1] * 9, [0] * 10 + [3] * 18)
    found = schedule_tree(tree, Control(time_limit_s=30.0), bound_share=0.5)
    assert (found.status, found.makespan_s, found.certificate.bound) == ("optimal", 15, 15.0)
    assert check_tree(tree, found) == ()


def test_the_trap_of_shared_starts_and_ends_is_not_stepped_into() -> None:
    """Durations by robot [[4,3,4],[1,9,6],[4,7,8],[5,3,2]], task 3 after 1 and 2: 7 is feasible, and no path allows less than 4 + 2."""
    times = [[4, 3, 4], [1, 9, 6], [4, 7, 8], [5, 3, 2]]
    able = [[1, 1, 1], [1, 1, 0], [1, 0, 1], [1, 0, 1]]
    kind, parent, robot, duration = [AND, XOR, XOR, XOR, XOR], [-1, 0, 0, 0, 0], [0] * 5, [0] * 5
    for task in range(4):
        for which in range(3):
            if able[task][which]:
                kind.append(LEAF)
                parent.append(1 + task)
                robot.append(which)
                duration.append(times[task][which])
    tree = columns(kind, parent, robot, duration, [(2, 4), (3, 4)], robots=3)
    assert least_makespan(tree) == 7
    found = schedule_tree(tree, Control(time_limit_s=30.0))
    assert (found.status, found.makespan_s, check_tree(tree, found)) == ("optimal", 7, ())


def test_a_slower_robot_is_taken_where_the_quick_one_would_be_late() -> None:
    """Two tasks of 3 s by robot 0 or 4 s by robot 1: together 4 s, one after the other on the quick robot 6 s."""
    tree = columns(
        [AND, XOR, XOR, LEAF, LEAF, LEAF, LEAF], [-1, 0, 0, 1, 1, 2, 2], [0, 0, 0, 0, 1, 0, 1], [0, 0, 0, 3, 4, 3, 4]
    )
    found = schedule_tree(tree, Control(time_limit_s=30.0))
    assert (found.status, found.makespan_s) == ("optimal", 4)


def test_equal_robots_share_the_work() -> None:
    """Five actions of 2 s for two equal robots: three rounds."""
    tree = columns([AND] + [LEAF] * 5, [-1] + [0] * 5, [0] * 6, [0] + [2] * 5, robots=1, count=[2])
    found = schedule_tree(tree, Control(time_limit_s=30.0))
    assert (found.status, found.makespan_s, check_tree(tree, found)) == ("optimal", 6, ())
    assert sorted(found.robot.values()) == [0, 0, 0, 1, 1]


def test_large_mission_trees_are_settled_by_lists_and_paths_alone() -> None:
    for leaves, robots, seed, makespan in ((1000, 10, 3, 160), (4000, 20, 8, 226)):
        tree = columns_of(parse(text_of(instance("mission", leaves, robots, seed)), "tree.json"))
        found = schedule_tree(tree, Control(), solver=False)
        assert (found.status, found.makespan_s, found.certificate.method) == ("optimal", makespan, "critical_path")
        assert check_tree(tree, found) == ()


def test_nothing_to_choose_from_is_infeasible_and_an_and_of_nothing_is_refused() -> None:
    assert schedule_tree(columns([XOR], [-1], [0], [0]), Control()).status == "infeasible"
    with pytest.raises(InputError, match="AND 0 has no children"):
        schedule_tree(columns([AND], [-1], [0], [0]), Control())


def test_time_that_is_up_from_the_start_still_gives_a_schedule() -> None:
    tree = columns_of(parse(text_of(instance("mission", 300, 3, 1)), "tree.json"))
    found = schedule_tree(tree, Control(time_limit_s=0.0))
    assert found.status in {"feasible", "optimal"}
    assert check_tree(tree, found) == ()


def test_the_same_seed_gives_the_same_schedule() -> None:
    tree = drawn(7, leaves=8)
    first, second = (
        schedule_tree(tree, Control(time_limit_s=0.3, clock=Late(), seed=5), solver=False) for _ in range(2)
    )
    assert first == second
