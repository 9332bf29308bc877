"""The checker of trees in columns: nothing wrong with what is right, and every damage found."""

from __future__ import annotations

from dataclasses import replace

from missiontree.checking.columns import check_tree
from missiontree.mission.certificate import Certificate
from missiontree.mission.columns import AND, LEAF, XOR
from missiontree.mission.tree_schedule import TreeSchedule
from tests.scheduling.joint.small_trees import columns

TREE = columns(
    [AND, XOR, LEAF, LEAF, LEAF, AND, LEAF],
    [-1, 0, 0, 1, 1, 0, 5],
    [0, 0, 0, 0, 1, 0, 0],
    [0, 0, 3, 2, 1, 0, 4],
    [(2, 1), (5, 4)],
)
"""Leaf 2 (3 s, robot 0) before the XOR of leaf 3 (2 s, robot 0) and leaf 4 (1 s, robot 1); leaf 6 (4 s, robot 0) before leaf 4."""
GOOD = TreeSchedule(
    "optimal",
    Certificate(claim="proven", method="load", bound=8.0),
    {1: 4},
    {2: 0, 6: 3, 4: 7},
    {2: 0, 6: 0, 4: 0},
    8,
)


def test_a_schedule_that_keeps_all_rules_has_no_fault() -> None:
    assert check_tree(TREE, GOOD) == ()
    assert (
        check_tree(
            TREE,
            replace(
                GOOD,
                chosen={1: 3},
                start_s={2: 0, 6: 5, 3: 3},
                robot={2: 0, 6: 0, 3: 0},
                status="feasible",
                certificate=replace(GOOD.certificate, claim="bounded"),
                makespan_s=9,
            ),
        )
        == ()
    )


def test_every_damage_is_found() -> None:
    bound = GOOD.certificate
    damaged = {
        "no child of it is taken": replace(GOOD, chosen={}),
        "selected and has no time": replace(GOOD, chosen={1: 3}),
        "not selected and has a time": replace(GOOD, start_s={**GOOD.start_s, 3: 9}, robot={**GOOD.robot, 3: 0}),
        "which is no XOR that is reached": replace(GOOD, chosen={1: 4, 5: 6}),
        "is no action": replace(GOOD, start_s={**GOOD.start_s, 5: 0}),
        "before the mission": replace(GOOD, start_s={2: -1, 6: 3, 4: 7}),
        "of which there are 1": replace(GOOD, robot={2: 0, 6: 1, 4: 0}),
        "while robot 0 of robot-0 does": replace(GOOD, start_s={2: 0, 6: 2, 4: 7}),
        "before AND 5 ends": replace(
            GOOD, start_s={2: 0, 6: 3, 4: 6}, makespan_s=7, certificate=replace(bound, bound=7.0)
        ),
        "before leaf 2 ends": replace(
            GOOD, chosen={1: 3}, start_s={2: 2, 6: 5, 3: 0}, robot={2: 0, 6: 0, 3: 0}, makespan_s=9
        ),
        "not the end of the last action": replace(GOOD, makespan_s=9),
        "lies above the makespan": replace(GOOD, certificate=replace(bound, bound=9.0)),
        "called optimal": replace(GOOD, certificate=replace(bound, bound=7.0)),
        "something is scheduled": replace(GOOD, status="infeasible"),
    }
    for said, schedule in damaged.items():
        assert any(said in fault.message for fault in check_tree(TREE, schedule)), said
