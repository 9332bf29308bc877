"""Alternatives side by side, with the paper's numbers."""

from __future__ import annotations

from dataclasses import replace

import pytest

from missiontree import plan
from missiontree.mission.fleet import Fleet, RobotType
from missiontree.mission.plan import Plan
from missiontree.reporting.team.view import Task, TeamView, team_view
from missiontree.samples.catalogue import sample_file
from tests.builders import brief_of, paper_fleet


def viewed(made: Plan) -> TeamView:
    view = team_view(made)
    assert view is not None
    return view


@pytest.fixture(scope="module")
def reunite() -> TeamView:
    return viewed(plan(sample_file("reunite")))


def who(task: Task) -> list[tuple[tuple[str, ...], str, bool]]:
    return [(cell.types, cell.way, cell.differs) for cell in task.doers]


def test_the_four_alternatives_of_the_first_mission(reunite: TeamView) -> None:
    """Design section 13: 5.6, 5.6, 3.5, 3.5, all proven; the equal ones are said to be tied."""
    assert [column.utility for column in reunite.columns] == pytest.approx([5.6, 5.6, 3.5, 3.5])
    assert [column.tied for column in reunite.columns] == [(2,), (1,), (4,), (3,)]
    assert [column.behind for column in reunite.columns] == pytest.approx([0, 0, 2.1, 2.1])
    assert all(column.rank_proven for column in reunite.columns)
    assert reunite.columns[0].known == "rank proven, shortest, proven"


def test_who_does_what_in_the_first_mission(reunite: TeamView) -> None:
    """The two best differ in who brings the child, and how; the others in who searches."""
    search, bring = reunite.tasks
    assert search.label == "Search(Child)"
    tele, porter = (("Tele-Robot",), "", False), (("Transportation Robot",), "", True)
    assert who(search) == [tele, tele, porter, porter]
    carried = (("Transportation Robot",), "carry", False)
    led = (("Social Robot",), "message_display", True)
    assert who(bring) == [carried, led, carried, led]
    assert bring.doers[1].robots == ("social_robot-1",)


def test_makespans_are_those_of_the_schedules(reunite: TeamView) -> None:
    """Search 5 + 60 + 2 s; then 5 + 60 + 20 + 60 s by carrying, 10 in place of 20 s by leading: 212 and 202 s."""
    assert [column.makespan_s for column in reunite.columns] == [212, 202, 212, 202]
    assert [column.robots for column in reunite.columns] == [2, 2, 1, 2]
    assert all(column.travel_m == 0 for column in reunite.columns)


def test_rescue_has_three_utilities_and_one_tie() -> None:
    """With kinds on: 8.6, 6.5, 6.5, 4.4."""
    view = viewed(plan(sample_file("rescue")))
    assert [column.utility for column in view.columns] == pytest.approx([8.6, 6.5, 6.5, 4.4])
    assert [column.tied for column in view.columns] == [(), (3,), (2,), ()]
    assert view.columns[0].schedule == "optimal"


def test_a_mission_that_cannot_be_done_has_nothing_to_compare() -> None:
    assert team_view(plan(sample_file("restaurants"))) is None


def test_what_was_chosen_is_said_and_the_other_task_is_not_done() -> None:
    """Either the cup or the key: two alternatives that do one each."""
    fleet = Fleet((RobotType(id="walker", label="Walker", count=1, capabilities={"search": 1.0}),))
    view = viewed(plan("Find the cup or find the key", fleet=fleet))
    assert len(view.columns) == 2
    chosen = [column.choices for column in view.columns]
    assert chosen[0] != chosen[1]
    assert all(len(choices) == 1 for choices in chosen)
    first, second = view.tasks
    assert [cell.types for cell in first.doers] == [("Walker",), ()]
    assert [cell.types for cell in second.doers] == [(), ("Walker",)]
    assert second.doers[1].differs
    assert second.differs


def test_without_schedules_types_are_told_and_no_robots(reunite: TeamView) -> None:
    made = plan(sample_file("reunite"))
    view = viewed(replace(made, schedules=()))
    assert [cell.types for cell in view.tasks[0].doers] == [cell.types for cell in reunite.tasks[0].doers]
    assert all(cell.robots == () for task in view.tasks for cell in task.doers)
    assert {column.makespan_s for column in view.columns} == {None}
    assert {column.robots for column in view.columns} == {None}
    assert view.columns[0].known == "rank proven"


def test_an_unproven_rank_is_not_called_proven() -> None:
    made = plan(sample_file("reunite"))
    assert made.ranking is not None
    first = made.ranking.alternatives[0]
    doubtful = replace(first, certificate=replace(first.certificate, claim="unproven"))
    ranking = replace(made.ranking, alternatives=(doubtful,), status="partial")
    (column,) = viewed(replace(made, ranking=ranking, schedules=made.schedules[:1])).columns
    assert not column.rank_proven
    assert column.known.startswith("rank not proven")


def test_a_foreign_instance_without_a_mission_tree_is_told_by_its_roles() -> None:
    made = plan(sample_file("reunite"))
    assert made.grounding is not None
    tree = made.grounding.tree
    foreign = replace(
        tree,
        nodes=tuple(replace(node, source=None) for node in tree.nodes),
        roles=tuple(replace(role, source=None) for role in tree.roles),
    )
    view = viewed(replace(made, tree=None, grounding=replace(made.grounding, tree=foreign)))
    assert [task.label for task in view.tasks] == ["Search(Child)", "ReachAndTransport(Child, Mom)"]
    assert [cell.types for cell in view.tasks[1].doers][:2] == [("Transportation Robot",), ("Social Robot",)]
    assert len(view.columns[0].choices) == 2  # nobody knows which gates are the mission's own


def test_names_are_on_one_line() -> None:
    kinds = paper_fleet().types
    fleet = Fleet((replace(kinds[1], label="Tele\n\x1b[31mRobot"), *kinds[2:]))
    view = viewed(plan(brief_of("Find the child").text, fleet=fleet))
    assert view.tasks[0].doers[0].types == ("Tele Robot",)
