"""Groups that one robot fills, marks that keep robots apart, and contradictions between the two."""

from __future__ import annotations

from missiontree.mission.fleet import Fleet
from missiontree.scheduling.precedence import task_graph
from missiontree.scheduling.staffing import Staffing, staffing_conflicts, staffing_of
from tests.scheduling.instances import Group, Instance, Part, mission, robots, work


def staffing(made: Instance) -> Staffing:
    return staffing_of(task_graph(made.tree, made.alternative.choices))


def rules(made: Instance, *counts: tuple[str, int]) -> list[str]:
    graph = task_graph(made.tree, made.alternative.choices)
    fleet = Fleet(tuple(robots(name, count) for name, count in counts))
    return [reason.rule for reason in staffing_conflicts(graph, staffing_of(graph), fleet)]


ABC = [Part(name, "r", [work(1)]) for name in "abc"]


def test_same_robot_links_join_over_inner_nodes_and_chains() -> None:
    """G holds a and b; one link joins both with c."""
    made = mission([Group("G", ABC[:2]), ABC[2]], [("G", "c", "same_robot")])
    assert staffing(made).members == {0: (0, 1, 2)}
    chain = mission(ABC, [("c", "b", "same_robot"), ("b", "a", "same_robot")])
    assert staffing(chain).members == {0: (0, 1, 2)}


def test_different_robot_links_mark_both_sides_only() -> None:
    """a and b are on one side, so they may share a robot; c is on the other."""
    found = staffing(mission([Group("G", ABC[:2]), ABC[2]], [("G", "c", "different_robot")]))
    assert not found.avoids[0] & found.wears[1]
    assert found.avoids[0] & found.wears[2]
    assert found.avoids[2] & found.wears[1]


def test_one_robot_cannot_be_of_two_types() -> None:
    made = mission([Part("a", "r", [work(1)]), Part("b", "s", [work(1)])], [("a", "b", "same_robot")])
    assert rules(made, ("r", 2), ("s", 2)) == ["same_robot"]


def test_one_robot_cannot_fill_two_roles_of_a_team_or_work_with_itself() -> None:
    team = mission([Part(n, "r", [work(1)], team=3) for n in "ab"], [("a", "b", "same_robot")])
    assert rules(team, ("r", 2)) == ["same_robot"]
    joint = mission([Part(n, "r", [work(1, sync=3)]) for n in "ab"], [("a", "b", "same_robot")])
    assert rules(joint, ("r", 2)) == ["same_robot"]


def test_teams_count_robots_by_type() -> None:
    """Two of r and one of s are needed together."""
    made = mission([Part("a", "r", [work(1)], 0), Part("b", "r", [work(1)], 0), Part("c", "s", [work(1)], 0)])
    assert rules(made, ("r", 2), ("s", 1)) == []
    assert rules(made, ("r", 1), ("s", 1)) == ["too_few_robots"]
