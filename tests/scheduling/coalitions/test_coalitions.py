"""Coalitions, routes and times: against everything tried, by hand, and as the values that other stages take."""

from __future__ import annotations

from dataclasses import replace
from itertools import count

from missiontree.checking.coalitions import check_coalitions
from missiontree.formats.importers.coalition_grounded import coalition_fleet, coalition_scene, coalition_tree
from missiontree.mission.alternative import Alternative, Choice, RoleType, selected_leaves
from missiontree.mission.certificate import Certificate
from missiontree.mission.coalitions import CoalitionMission, CoalitionSchedule, CoalitionTask
from missiontree.mission.control import Control
from missiontree.scheduling import SCHEDULERS
from missiontree.scheduling.coalitions import coalitions as road
from missiontree.scheduling.coalitions.bounds import outlook_of
from missiontree.scheduling.coalitions.coalitions import schedule_coalitions
from missiontree.scheduling.coalitions.labels import search
from tests.scheduling.coalitions.drawn import drawn, least_makespan

GRID_S = 0.01
"""Ways are rounded up to 1 ms each, and a robot that could be spared may pass by a task without a detour."""


def task(needs: tuple[int, ...], duration_s: float, x_m: float, y_m: float = 0.0) -> CoalitionTask:
    return CoalitionTask(needs=needs, duration_s=duration_s, x_m=x_m, y_m=y_m)


def test_the_optimum_is_that_of_trying_everything() -> None:
    for seed in range(25):
        mission = drawn(seed)
        best = least_makespan(mission)
        found = schedule_coalitions(mission, Control())
        assert check_coalitions(mission, found) == ()
        if best is None:
            assert found.status == "infeasible"
        else:
            assert (found.status, found.certificate.claim) == ("optimal", "proven")
            assert abs(found.makespan_s - best / 1000) <= GRID_S


def test_no_bound_is_above_the_optimum_however_narrow_the_layers() -> None:
    for seed in range(100, 112):
        mission = drawn(seed)
        best = least_makespan(mission)
        if best is None:
            continue
        outlook = outlook_of(mission)
        start = len(mission.tasks)
        robots = len(mission.skills)
        assert outlook.bound(0, (start,) * robots, (0,) * robots, (0,) * start) <= best + 8
        found = search(mission, outlook, 1 << 60, 1, lambda: False)
        assert found.bound <= best + 8
        assert found.makespan >= best


def test_two_who_are_needed_together_meet_and_go_home_apart() -> None:
    """Both walk 3 m to the task, which takes 2 s, and then 4 m to the end: 3 + 2 + 4 = 9 s."""
    mission = CoalitionMission(skills=((0,), (1,)), tasks=(task((0, 1), 2, 3),), start=(0, 0), end=(7, 0))
    found = schedule_coalitions(mission, Control())
    assert (found.status, found.makespan_s, found.arrivals_s) == ("optimal", 9.0, (9.0, 9.0))
    assert found.visits[0].robots == (0, 1)


def test_who_can_do_both_alone_saves_the_other_the_way() -> None:
    """Robot 2 has both skills; of the coalitions that cover, only those count in which nobody can be spared."""
    mission = CoalitionMission(skills=((0,), (1,), (0, 1)), tasks=(task((0, 1), 2, 3),), start=(0, 0), end=(0, 0))
    assert mission.coalitions == (((2,), (0, 1)),)


def test_a_skill_that_all_lack_cannot_be_had_and_a_circle_not_be_kept() -> None:
    lacking = CoalitionMission(skills=((0,),), tasks=(task((1,), 1, 1),), start=(0, 0), end=(0, 0))
    found = schedule_coalitions(lacking, Control())
    assert (found.status, found.certificate.method) == ("infeasible", "coverage")
    both = (task((0,), 1, 1), task((0,), 1, 2))
    circle = CoalitionMission(skills=((0,),), tasks=both, start=(0, 0), end=(0, 0), precedence=((0, 1), (1, 0)))
    assert schedule_coalitions(circle, Control()).certificate.method == "precedence"


def test_time_that_is_up_still_gives_a_schedule_with_a_bound() -> None:
    mission = drawn(5, tasks=9)
    ticking = count()
    found = schedule_coalitions(mission, Control(time_limit_s=0.0, clock=lambda: float(next(ticking))))
    assert found.status in {"feasible", "optimal"}
    assert check_coalitions(mission, found) == ()
    assert road.WIDTHS[0] < road.WIDTHS[-1]


def test_every_damage_is_found() -> None:
    mission = CoalitionMission(
        skills=((0,), (1,)),
        tasks=(task((0,), 2, 3), task((1,), 2, 4), task((0, 1), 5, 5)),
        start=(0, 0),
        end=(7, 0),
        precedence=((0, 2),),
    )
    good = schedule_coalitions(mission, Control())
    assert check_coalitions(mission, good) == ()
    first, second, third = good.visits
    damaged: list[CoalitionSchedule] = [
        replace(good, visits=(first, second)),
        replace(good, visits=(first, first, second, third)),
        replace(good, visits=(replace(first, robots=(1 - first.robots[0],)), second, third)),
        replace(good, visits=(first, second, replace(third, robots=(0,)))),
        replace(good, visits=(first, second, replace(third, robots=(0, 0, 1)))),
        replace(good, visits=(first, second, replace(third, start_s=third.start_s - 1, end_s=third.end_s - 1))),
        replace(good, visits=(first, second, replace(third, end_s=third.end_s - 1))),
        replace(good, visits=(first, second, replace(third, task=7))),
        replace(good, arrivals_s=(good.arrivals_s[0] - 1, good.arrivals_s[1])),
        replace(good, arrivals_s=good.arrivals_s[:1]),
        replace(good, makespan_s=good.makespan_s - 1),
        replace(good, certificate=Certificate(claim="proven", method="labels", bound=good.makespan_s + 1)),
        replace(good, certificate=Certificate(claim="proven", method="labels", bound=good.makespan_s - 1)),
        replace(good, status="unknown"),
    ]
    assert all(check_coalitions(mission, one) for one in damaged)


def test_as_a_grounded_tree_the_same_choice_is_scheduled_no_shorter_and_with_the_way_home() -> None:
    """The tree that other stages take means the same: greedy, given the coalitions found, is never below the optimum."""
    for seed in range(200, 220):
        mission = drawn(seed)
        best = schedule_coalitions(mission, Control())
        if best.status == "infeasible":
            continue
        tree, fleet, scene = coalition_tree(mission), coalition_fleet(mission), coalition_scene(mission)
        tasks = [node for node in tree.children[0] if tree.nodes[node].kind == "xor"]
        chosen = {visit.task: mission.coalitions[visit.task].index(visit.robots) for visit in best.visits}
        choices = tuple(Choice(xor, tree.children[xor][chosen[number]]) for number, xor in enumerate(tasks))
        actions = [tree.action(leaf) for leaf in selected_leaves(tree, choices)]
        roles = tuple(RoleType(action.role, action.robot_type) for action in sorted(actions, key=lambda one: one.role))
        known = Certificate(claim="unproven", method="labels")
        alternative = Alternative(rank=1, utility=0.0, choices=choices, roles=roles, certificate=known)
        schedule = SCHEDULERS["greedy"](tree, alternative, fleet, scene, Control())
        assert schedule.status in {"optimal", "feasible"}, schedule.reasons
        assert schedule.makespan_s >= best.makespan_s - GRID_S
        assert len(schedule.actions) == len(actions)
