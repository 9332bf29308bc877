"""Robots on their branches, and the alternative that is lit."""

from __future__ import annotations

from dataclasses import replace

import pytest

from missiontree import plan
from missiontree.errors import InputError
from missiontree.mission.alternative import Choice
from missiontree.mission.plan import Plan
from missiontree.reporting.palette import liveries
from missiontree.reporting.tree.chosen import alternative_of, chosen_actions, chosen_tasks, team_of
from missiontree.reporting.tree.shape import Shape, shape_of
from missiontree.samples.catalogue import sample_file
from tests.builders import and_, grounded, leaf, xor_


@pytest.fixture(scope="module")
def rescue() -> Plan:
    """Both Tele-Robots search in parallel, the Transportation Robot brings the cat; three more alternatives."""
    return plan(sample_file("rescue"))


def tasks(made: Plan, rank: int) -> Shape:
    assert made.tree is not None
    return chosen_tasks(shape_of(made.tree), made.tree, made, rank)


def actions(made: Plan, rank: int | None) -> Shape:
    assert made.grounding is not None
    return chosen_actions(shape_of(made.grounding.tree), made.grounding.tree, made, rank)


def test_routines_bear_the_robots_of_the_alternative(rescue: Plan) -> None:
    teams = {node.label: [badge.text for badge in node.team] for node in tasks(rescue, 1).nodes if node.team}
    assert teams["ReachAndTransport(Cat, Safe Area)"] == ["Transportation Robot"]
    # there are two Tele-Robots, so they are told apart, and each search has its own
    assert sorted([*teams["Search(Firefighter)"], *teams["Search(Cat)"]]) == ["Tele-Robot · 1", "Tele-Robot · 2"]


def test_badges_have_the_liveries_that_the_robots_have_in_every_other_picture(rescue: Plan) -> None:
    own = liveries(rescue.brief.fleet)
    schedule = next(schedule for schedule in rescue.schedules if schedule.rank == 1)
    robots = {own[entry.robot] for entry in schedule.assignments}
    assert {badge.livery for node in tasks(rescue, 1).nodes for badge in node.team} == robots


def test_without_a_choice_between_tasks_everything_authored_is_lit(rescue: Plan) -> None:
    assert {node.state for node in tasks(rescue, 1).nodes} == {"lit"}


def test_in_the_grounded_tree_one_branch_of_each_choice_is_lit_with_all_above_it(rescue: Plan) -> None:
    assert rescue.grounding is not None
    tree, shape = rescue.grounding.tree, actions(rescue, 2)
    for index, node in enumerate(tree.nodes):
        if node.kind == "xor" and shape.nodes[index].state == "lit":
            assert [shape.nodes[child].state for child in tree.children[index]].count("lit") == 1
        if index and shape.nodes[index].state == "lit":
            assert shape.nodes[node.parent].state == "lit"
    assert {node.state for node in shape.nodes} == {"lit", "quiet"}


def test_another_alternative_lights_another_branch(rescue: Plan) -> None:
    lit = [
        {index for index, node in enumerate(actions(rescue, rank).nodes) if node.state == "lit"}
        for rank in (1, 2, 3, 4)
    ]
    assert len({frozenset(one) for one in lit}) == 4


def test_branches_bear_their_type_and_the_chosen_ones_their_robot(rescue: Plan) -> None:
    branches = [node for node in actions(rescue, 1).nodes if node.label == "search"]
    assert sorted((node.team[0].text, node.state) for node in branches) == [
        ("Tele-Robot · 1", "lit"),
        ("Tele-Robot · 2", "lit"),
        ("Transportation Robot", "quiet"),
        ("Transportation Robot", "quiet"),
    ]
    plain = [node for node in actions(rescue, None).nodes if node.label == "search"]
    assert sorted(node.team[0].text for node in plain) == ["Tele-Robot"] * 2 + ["Transportation Robot"] * 2
    assert {node.state for node in plain} == {"plain"}


def test_an_alternative_without_a_schedule_shows_types(rescue: Plan) -> None:
    unscheduled = replace(rescue, schedules=())
    teams = {node.label: [badge.text for badge in node.team] for node in tasks(unscheduled, 1).nodes if node.team}
    assert teams["Search(Cat)"] == ["Tele-Robot"]


def test_what_is_not_selected_is_quiet_in_the_mission_tree_too() -> None:
    made = plan(sample_file("airport"))
    assert made.tree is not None
    states = {node.id: drawn.state for node, drawn in zip(made.tree.nodes, tasks(made, 1).nodes, strict=True)}
    choices = [node for node in made.tree.nodes if node.gate == "xor"]
    assert choices
    for node in choices:
        assert [states[child] for child in node.children].count("lit") == 1
    for node in made.tree.nodes:
        if states[node.id] == "quiet":
            assert all(states[child] == "quiet" for child in node.children)


FOREIGN = grounded(
    and_(
        xor_(
            and_(leaf("look", "scout", role="r"), leaf("tell", "scout", role="r"), label="seek by Scout"), label="seek"
        ),
        leaf("wait", "cart"),
        and_(leaf("lift", "cart", role="x"), leaf("push", "scout", role="y"), label="joint"),
        label="all",
    )
)


def test_foreign_trees_name_their_types_themselves() -> None:
    shape = chosen_actions(shape_of(FOREIGN), FOREIGN, None, None)
    assert [(node.label, [badge.text for badge in node.team]) for node in shape.nodes] == [
        ("all", []),
        ("seek", []),
        ("seek", ["Scout"]),  # the branch says the name better than the id does
        ("look", []),
        ("tell", []),
        ("wait", ["cart"]),
        ("joint", []),
        ("lift", ["cart"]),
        ("push", ["scout"]),
    ]
    liveries_by_name = {badge.text.lower(): badge.livery for node in shape.nodes for badge in node.team}
    assert [liveries_by_name[name].number for name in ("scout", "cart")] == [0, 1]


def test_a_type_that_the_fleet_lacks_has_a_livery_of_its_own(rescue: Plan) -> None:
    team = team_of(FOREIGN, rescue)
    assert team.badge("scout").livery not in set(team.of_robots.values())


@pytest.mark.parametrize("rank", [0, 5, -1])
def test_ranks_that_there_are_not_are_refused(rescue: Plan, rank: int) -> None:
    with pytest.raises(InputError, match=rf"no alternative of rank {rank}(.|\n)*1 to 4"):
        alternative_of(rescue, rank)


def test_a_plan_without_alternatives_says_so(rescue: Plan) -> None:
    with pytest.raises(InputError, match="the plan has no alternatives"):
        alternative_of(replace(rescue, ranking=None, schedules=()), 1)


def test_a_damaged_plan_is_refused(rescue: Plan) -> None:
    assert rescue.ranking is not None
    first, *others = rescue.ranking.alternatives
    for choices in ((), (Choice(first.choices[0].xor, 0), *first.choices[1:]), (Choice(10_000, 1),)):
        damaged = replace(rescue.ranking, alternatives=(replace(first, choices=choices), *others))
        with pytest.raises(InputError, match="missiontree check"):
            alternative_of(replace(rescue, ranking=damaged), 1)
