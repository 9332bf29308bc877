"""Deadlines as far as allocation can decide them: never against a schedule that there is."""

from __future__ import annotations

from dataclasses import replace
from random import Random

import pytest
from hypothesis import HealthCheck, given, settings

from benchmarks.allocation_agreement import EVERYTHING, run
from benchmarks.random_trees import random_case
from missiontree.allocation import ALLOCATORS
from missiontree.allocation.exhaustive import Exhaustive
from missiontree.allocation.flat import flatten
from missiontree.allocation.lateness import late
from missiontree.allocation.possible import possible_nodes
from missiontree.allocation.selection import Selection
from missiontree.mission.alternative import Ranking, selected_leaves, selected_nodes
from missiontree.mission.control import Control
from missiontree.mission.estimate import Weights
from missiontree.mission.fleet import Fleet
from missiontree.mission.grounded import GroundedTree
from missiontree.scheduling.greedy import greedy
from tests.builders import Spec, and_, grounded, leaf, trivial_fleet, xor_
from tests.scheduling.instances import Instance
from tests.scheduling.strategies import fleets, instances, plane, timed

SLOW = settings(max_examples=300, deadline=None, suppress_health_check=list(HealthCheck), derandomize=True)
TRULY = ["exact", "exhaustive"]


def timed_tree(tree: GroundedTree, **times: tuple[float, float | None]) -> GroundedTree:
    """The tree with a release time and a deadline at nodes by label."""
    nodes = tuple(
        replace(node, release_s=times[node.label][0], deadline_s=times[node.label][1]) if node.label in times else node
        for node in tree.nodes
    )
    return replace(tree, nodes=nodes)


def ranked(allocator: str, tree: GroundedTree, fleet: Fleet, k: int = 9) -> Ranking:
    return ALLOCATORS[allocator](tree, fleet, Weights(), k, Control())


def utilities(ranking: Ranking) -> list[float]:
    return [alternative.utility for alternative in ranking.alternatives]


def either(name: str) -> Spec:
    """Done well in 10 s by type a, or less well in 4 s by type b."""
    return xor_(
        leaf(f"{name} by a", "a", role=name, quality=3, duration_s=10),
        leaf(f"{name} by b", "b", role=name, quality=2, duration_s=4),
        label=name,
    )


ROW = grounded(and_(either("x"), either("y"), label="both"), [("x", "y")])
AB = trivial_fleet(("a", "b"))


@SLOW
@given(instances().flatmap(timed), fleets())
def test_nothing_is_refused_that_has_a_schedule(instance: Instance, fleet: Fleet) -> None:
    result = greedy(instance.tree, instance.alternative, fleet, plane(), Control())
    choices = instance.alternative.choices
    selection = Selection(
        tuple((choice.xor, choice.child) for choice in choices),
        tuple(selected_nodes(instance.tree, choices)),
        selected_leaves(instance.tree, choices),
    )
    if result.status in {"optimal", "feasible"}:
        assert late(flatten(instance.tree, fleet, Weights()), selection) is None


def test_the_sweep_strikes_nothing_that_a_feasible_alternative_selects() -> None:
    """On 300 random trees; it strikes something in many of them."""
    struck = 0
    for index in range(300):
        case = random_case(Random(f"sweep:{index}"), ("release times and deadlines",))  # noqa: S311 - luck for tests
        possibility = possible_nodes(case.flat)
        struck += bool(possibility.late)
        for alternative in run(Exhaustive(), case, EVERYTHING).alternatives:
            assert all(possibility.possible[node] for node in selected_nodes(case.tree, alternative.choices))
    assert struck > 50


@pytest.mark.parametrize("allocator", TRULY)
def test_a_deadline_leaves_out_what_takes_too_long_in_a_row(allocator: str) -> None:
    """In a row 20, 14, 14 and 8 s: 6, 5, 5 and 4. By 14 s the first is left out, by 13.999 s three are, by 7 s all."""
    assert utilities(ranked(allocator, ROW, AB)) == [6, 5, 5, 4]
    assert utilities(ranked(allocator, timed_tree(ROW, both=(0, 14)), AB)) == [5, 5, 4]
    assert utilities(ranked(allocator, timed_tree(ROW, both=(0, 13.999)), AB)) == [4]
    assert ranked(allocator, timed_tree(ROW, both=(0, 7)), AB).status == "infeasible"


@pytest.mark.parametrize("allocator", TRULY)
def test_without_an_order_both_may_go_on_at_once(allocator: str) -> None:
    """Robots are not counted: even two roles of the one robot of type a are taken to be done by 10 s."""
    tree = grounded(and_(either("x"), either("y"), label="both"))
    assert utilities(ranked(allocator, timed_tree(tree, both=(0, 10)), AB)) == [6, 5, 5, 4]


@pytest.mark.parametrize("allocator", TRULY)
def test_a_release_time_counts_against_a_deadline(allocator: str) -> None:
    """x from 1 s: a would end at 11 s."""
    assert utilities(ranked(allocator, timed_tree(ROW, x=(1, 11)), AB)) == [6, 5, 5, 4]
    assert utilities(ranked(allocator, timed_tree(ROW, x=(1, 10)), AB)) == [5, 4]


def test_travel_that_is_certain_counts_and_an_approach_does_not() -> None:
    """5 s, 3 s of travel, 2 s: 10 s. Before the first action of a role nothing counts."""
    first = leaf("first", role="r", duration_s=5, travel_at_least_s=100)
    second = leaf("second", role="r", duration_s=2, travel_at_least_s=3)
    tree = grounded(and_(first, second, label="both"))
    fleet = trivial_fleet()
    assert ranked("exact", timed_tree(tree, both=(0, 10)), fleet).status == "exact"
    assert ranked("exact", timed_tree(tree, both=(0, 9)), fleet).status == "infeasible"


def test_a_move_takes_the_travel_that_is_certain() -> None:
    tree = grounded(leaf("go", duration_s=50, travel_at_least_s=3, moves=True))
    assert ranked("exact", timed_tree(tree, go=(0, 3)), trivial_fleet()).status == "exact"
    assert ranked("exact", timed_tree(tree, go=(0, 2)), trivial_fleet()).status == "infeasible"


def test_the_candidate_that_is_refused_is_told_with_its_chain() -> None:
    """Three in a row with both other orders at hand: nothing is struck beforehand, since each alone is in time."""
    tree = timed_tree(
        grounded(and_(and_(either("x"), label="X"), and_(either("y"), label="Y"), label="both"), [("x", "y")]),
        both=(0, 14),
    )
    ranking = ranked("exact", tree, AB)
    assert utilities(ranking) == [5, 5, 4]
    assert [(reason.rule, reason.severity) for reason in ranking.reasons] == [("deadline_missed", "notice")]
    assert ranking.reasons[0].message == (
        "1 candidate was refused. The best of them: The mission must end by 14 s, and it takes until 20 s at least: "
        "'x by a' 10 s, then 'y by a' 10 s."
    )


def test_what_cannot_be_in_time_whatever_is_chosen_is_told_before_the_search() -> None:
    ranking = ranked("exact", timed_tree(ROW, both=(0, 7)), AB)
    assert (ranking.status, ranking.examined) == ("infeasible", 0)
    assert (
        ranking.reasons[0].message
        == "The mission must end by 7 s, and whatever is chosen, it takes until 8 s at least."
    )


def test_what_waits_for_itself_never_ends() -> None:
    """x before y and y before x: with a deadline there is no way; without one allocation leaves that to the scheduler."""
    tree = grounded(
        and_(and_(either("x"), label="X"), and_(either("y"), label="Y"), label="both"), [("x", "y"), ("y", "x")]
    )
    assert ranked("exhaustive", timed_tree(tree, both=(0, 1000)), AB).status == "infeasible"
    ranking = ranked("exact", timed_tree(tree, both=(0, 1000)), AB)
    assert ranking.status == "infeasible"
    assert "what it waits for waits for it" in ranking.reasons[0].message
    assert ranked("exact", tree, AB).status == "exact"
