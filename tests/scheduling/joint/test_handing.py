"""What a solver's times become: the same order, nothing later, and nothing that waits without a reason."""

from __future__ import annotations

from random import Random

from missiontree.checking.columns import check_tree
from missiontree.mission.certificate import Certificate
from missiontree.mission.columns import AND, LEAF, TreeColumns
from missiontree.mission.tree_schedule import TreeSchedule
from missiontree.scheduling.joint.dispatching import dispatched
from missiontree.scheduling.joint.handing import handed_out
from missiontree.scheduling.joint.listing import Listed
from missiontree.scheduling.joint.paths import paths_of
from missiontree.scheduling.joint.problem import JointProblem, problem_of
from tests.scheduling.joint.small_trees import chosen_by_chance, columns, drawn


def sound(tree: TreeColumns, found: Listed) -> bool:
    certificate = Certificate(claim="bounded", method="load", bound=0.0)
    told = TreeSchedule("feasible", certificate, found.chosen, found.start, found.robot, found.makespan)
    return check_tree(tree, told) == ()


def test_gaps_that_cost_nothing_are_closed() -> None:
    """
    On machine 0: 3 s, then 4 s that follow 2 s on machine 1. The times wait 1 s before the 2 s and 5 s before the 4 s, and end at 12.

    By hand: 0 to 3 and 3 to 7 on machine 0, 0 to 2 on machine 1.
    """
    tree = columns([AND, LEAF, LEAF, LEAF], [-1, 0, 0, 0], [0, 0, 1, 0], [0, 3, 2, 4], [(2, 3)])
    problem = problem_of(tree)
    found = handed_out(problem, paths_of(problem), {}, {1: 0, 2: 1, 3: 8})
    assert found == Listed(7, {1: 0, 2: 0, 3: 3}, {1: 0, 2: 0, 3: 0}, {})


def test_robots_are_handed_out_among_equals() -> None:
    """Two robots of one type: 0 to 4, 0 to 2 and, by whoever is free first, 2 to 5."""
    tree = columns([AND, LEAF, LEAF, LEAF], [-1, 0, 0, 0], [0, 0, 0, 0], [0, 4, 2, 3], robots=1, count=[2])
    problem = problem_of(tree)
    found = handed_out(problem, paths_of(problem), {}, {1: 0, 2: 1, 3: 3})
    assert (found.makespan, found.start) == (5, {1: 0, 2: 0, 3: 2})
    assert found.robot[3] == found.robot[2] != found.robot[1]


def test_nothing_is_later_than_it_was_and_every_wait_has_a_reason() -> None:
    """Sound schedules of small trees of every form, with pauses by chance for all that is left to do."""
    made = closed = 0
    for seed in range(300):
        tree, luck = drawn(seed), Random(seed)  # noqa: S311 - luck for tests, not for secrets
        problem = problem_of(tree)
        chosen = chosen_by_chance(problem, luck)
        if chosen is None:
            continue
        given = _with_pauses(dispatched(problem, [luck.random() for _ in problem.kind], chosen), problem, luck)
        found = handed_out(problem, paths_of(problem), given.chosen, given.start)
        assert sound(tree, given)
        assert sound(tree, found)
        assert found.chosen == given.chosen
        assert all(found.start[leaf] <= begun for leaf, begun in given.start.items())
        assert not any(_could_start_earlier(tree, found, leaf) for leaf in found.start)
        made += 1
        closed += found.makespan < given.makespan
    assert (made >= 100, closed >= 100) == (True, True)


def _with_pauses(one: Listed, problem: JointProblem, luck: Random) -> Listed:
    """The same, but that from some moments on everything begins later; what is under way then goes on."""
    moments = sorted({*one.start.values()})
    pause = {moment: luck.choice((0, 0, 1, 4)) for moment in moments}
    start = {
        leaf: begun + sum(by for moment, by in pause.items() if moment <= begun) for leaf, begun in one.start.items()
    }
    makespan = max((begun + problem.duration[leaf] for leaf, begun in start.items()), default=0)
    return Listed(makespan, start, one.robot, one.chosen)


def _could_start_earlier(tree: TreeColumns, found: Listed, leaf: int) -> bool:
    """Whether one second less is sound, all else as it is: all times are whole, so what cannot begin a second earlier is held."""
    if not found.start[leaf]:
        return False
    start = {**found.start, leaf: found.start[leaf] - 1}
    makespan = max(begun + tree.duration[one] for one, begun in start.items())
    return sound(tree, Listed(makespan, start, found.robot, found.chosen))
