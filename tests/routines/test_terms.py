"""Grounding under the terms of a mission: who is left out, and who would not do well enough, is not offered."""

from __future__ import annotations

from itertools import product
from random import Random
from typing import Any

import pytest

from missiontree.allocation.exhaustive import Exhaustive
from missiontree.allocation.flat import Flat, flatten
from missiontree.allocation.kbest import ExactKBest
from missiontree.estimation.own import own_estimator
from missiontree.estimation.table import TableEstimator
from missiontree.mission.alternative import selected_leaves
from missiontree.mission.brief import MissionBrief
from missiontree.mission.control import Control
from missiontree.mission.estimate import Estimate
from missiontree.mission.estimator_source import EstimatorSource
from missiontree.mission.fleet import Fleet, RobotType
from missiontree.mission.grounded import Grounding
from missiontree.mission.routine import ActionStep, Argument, Branch, RoleSpec, Routine, RoutineLibrary
from missiontree.mission.tree import MissionTree
from missiontree.routines.ground import ground
from tests.builders import actions_of, brief_of, flat_tree, grounding_of, paper_fleet, people, routine_node

SEARCH = flat_tree(routine_node("search", "Search", agent="Child"), entities=people("Child"))
LEAD = flat_tree(routine_node("lead", "SearchAndFollow", agent="Child"), entities=people("Child"))
ABILITIES = ("search", "follow", "reach", "carry", "message_display")
DRAWN = 300


def types_of(grounding: Grounding) -> set[str]:
    return {action.robot_type for action in actions_of(grounding.tree)}


def test_a_type_left_out_is_not_offered_and_the_reason_says_so() -> None:
    """Of those that search, tele_robot (1.0) and transportation_robot (0.3), the second is left."""
    grounding = grounding_of(SEARCH, without=("tele_robot",))
    assert types_of(grounding) == {"transportation_robot"}
    (reason,) = [reason for reason in grounding.not_offered if reason.rule == "left_out"]
    assert (reason.robot, reason.node) == ("tele_robot", "search")
    assert "Tele-Robot does not do Search(Child): the mission leaves it out." in reason.message


def test_a_type_with_one_robot_left_is_offered() -> None:
    assert types_of(grounding_of(SEARCH, without=("tele_robot-1",))) == {"tele_robot", "transportation_robot"}


def test_a_team_cannot_count_on_robots_that_are_left_out_or_may_not_be_in_use() -> None:
    """Two tele-robots, and a routine that needs two of them at once."""
    both = RoleSpec(name="side", rating="search", robots=2, actions=(ActionStep(name="sweep", text="Sweep"),))
    argument = Argument(name="agent", kinds=("person",))
    sweep = Routine(
        id="Sweep", purpose="Sweep for {agent}", arguments=(argument,), branches=(Branch(name="b", roles=(both,)),)
    )
    tree = flat_tree(routine_node("sweep", "Sweep", agent="Child"), entities=people("Child"))
    library = RoutineLibrary(routines=(sweep,))
    two = Fleet((RobotType(id="t", count=2, capabilities={"search": 1.0}),))
    capped = Fleet((RobotType(id="t", count=2, max_in_use=1, capabilities={"search": 1.0}),))
    assert types_of(grounding_of(tree, fleet=two, routines=library)) == {"t"}
    for grounding in (
        grounding_of(tree, fleet=two, routines=library, without=("t-1",)),
        grounding_of(tree, fleet=capped, routines=library),
    ):
        assert [reason.rule for reason in grounding.not_offered] == ["too_few_robots"]


@pytest.mark.parametrize("least", [0.5, {"Search": 0.5}, {"search": 0.5}])
def test_who_would_not_do_well_enough_is_not_offered(least: object) -> None:
    """The transportation robot searches at 0.3."""
    grounding = grounding_of(SEARCH, min_quality=least)
    assert types_of(grounding) == {"tele_robot"}
    (reason,) = [reason for reason in grounding.not_offered if reason.rule == "quality_below_minimum"]
    assert (reason.robot, reason.found, reason.needed) == ("transportation_robot", "search 0.3", "search 0.5")


def test_a_quality_at_the_minimum_is_enough() -> None:
    assert types_of(grounding_of(SEARCH, min_quality=0.3)) == {"tele_robot", "transportation_robot"}


@pytest.mark.parametrize(
    ("least", "able"),
    [
        ({"follow": 0.4}, {"tele_robot"}),  # follows at 0.5, the transportation robot at 0.3
        ({"Follow": 0.4}, {"tele_robot"}),  # by the part of the composed routine
        ({"SearchAndFollow": 0.4}, {"tele_robot"}),  # by the call
        ({"SearchAndFollow": 0.6}, set()),  # every action of the call: tele_robot follows at 0.5
        ({"Search": 0.9}, {"tele_robot"}),
        ({"Reach": 0.9, "carry": 2}, {"tele_robot", "transportation_robot"}),  # nothing of these in it
    ],
)
def test_a_minimum_counts_where_its_routine_or_capability_does(least: dict[str, float], able: set[str]) -> None:
    assert types_of(grounding_of(LEAD, min_quality=least)) == able


def test_the_best_under_a_minimum_are_those_of_all_that_keep_it() -> None:
    """300 missions: what is ranked under a minimum is what enumeration ranks without one, less what breaks it."""
    refused = 0
    for index in range(DRAWN):
        rng = Random(f"quality:{index}")  # noqa: S311 - luck for tests, not for secrets
        tree, fleet, least = drawn(rng)
        bare, strict = brief_of(tree, fleet=fleet), brief_of(tree, fleet=fleet, min_quality=least)
        everything = list(of_oracle(tree, bare))
        kept = [entry for entry in everything if keeps(entry, least)]
        refused += len(kept) < len(everything)
        ranking = ExactKBest()(flat_of(tree, strict), fleet, strict.weights, 1000, Control())
        found = [alternative.utility for alternative in ranking.alternatives]
        assert found == [utility for utility, _ in kept], f"mission {index}"
    assert refused > DRAWN // 10


def test_an_estimator_that_says_what_the_fleet_states_refuses_those_that_the_fleet_does() -> None:
    """The two ways to hold types to a minimum, offers by the fleet and calls by an estimator, on 300 missions."""
    refused = 0
    for index in range(DRAWN):
        rng = Random(f"estimator:{index}")  # noqa: S311 - luck for tests, not for secrets
        tree, fleet, least = drawn(rng)
        by_fleet = ground(tree, brief_of(tree, fleet=fleet, min_quality=least))
        brief = brief_of(tree, fleet=fleet, min_quality=least, estimator=EstimatorSource(name="the table"))
        by_estimator = ground(tree, brief, TableEstimator())
        assert by_estimator.tree == by_fleet.tree, f"mission {index}"
        assert by_estimator.not_offered == by_fleet.not_offered, f"mission {index}"
        refused += any(reason.rule == "quality_below_minimum" for reason in by_fleet.not_offered)
    assert refused > DRAWN // 10


def test_a_way_that_takes_several_is_lost_if_nobody_is_good_enough_for_one_part() -> None:
    """The carrier lifts well, and by the estimator's word nobody guides better than 0.4."""
    steps = {name: ActionStep(name=name, text=name) for name in ("lift", "guide")}
    roles = tuple(RoleSpec(name=name, rating=name, actions=(step,)) for name, step in steps.items())
    both = Routine(
        id="Both",
        purpose="Lift and guide {agent}",
        arguments=(Argument(name="agent", kinds=("person",)),),
        branches=(Branch(name="b", roles=roles),),
    )
    fleet = Fleet(tuple(RobotType(id=name, count=2, capabilities={"lift": 1.0, "guide": 1.0}) for name in ("a", "b")))
    tree = flat_tree(routine_node("both", "Both", agent="Child"), entities=people("Child"))

    def said(*question: Any, rating: str, **about: str) -> Estimate:
        return Estimate(0.4 if rating == "guide" else 1.0)

    own = own_estimator(said)
    assert own is not None
    library = RoutineLibrary(routines=(both,))
    brief = brief_of(tree, fleet=fleet, routines=library, min_quality=0.5, estimator=own.source)
    grounding = ground(tree, brief, own)
    assert types_of(grounding) == set()
    rules = [(reason.rule, reason.robot, reason.needed) for reason in grounding.not_offered]
    assert rules == [
        ("quality_below_minimum", "a", "guide 0.5"),
        ("quality_below_minimum", "b", "guide 0.5"),
        ("no_robot_able", "", "guide"),
    ]


Entry = tuple[float, list[tuple[str, str, float]]]
"""Utility, and routine called, capability and quality of every action."""


def drawn(rng: Random) -> tuple[MissionTree, Fleet, float | dict[str, float]]:
    types = tuple(
        RobotType(
            id=f"t{number}",
            count=rng.randint(1, 2),
            capabilities={name: rng.randint(1, 10) / 10 for name in rng.sample(ABILITIES, rng.randint(2, 5))},
        )
        for number in range(rng.randint(1, 3))
    )
    routines = [rng.choice(("Search", "Follow", "Reach", "SearchAndFollow")) for _ in range(rng.randint(1, 3))]
    leaves = (routine_node(f"n{place}", name, agent="Child") for place, name in enumerate(routines))
    tree = flat_tree(*leaves, entities=people("Child"))
    if rng.random() < 0.3:
        return tree, Fleet(types), rng.randint(1, 8) / 10
    able = {name for kind in types for name in kind.capabilities}
    names = sorted(able | {"Search", "Follow", "Reach", "SearchAndFollow"})
    return tree, Fleet(types), {name: rng.randint(1, 9) / 10 for name in rng.sample(names, rng.randint(1, 3))}


def flat_of(tree: MissionTree, brief: MissionBrief) -> Flat:
    return flatten(ground(tree, brief).tree, brief.fleet, brief.weights, brief.terms)


def of_oracle(tree: MissionTree, brief: MissionBrief) -> list[Entry]:
    made = ground(tree, brief).tree
    called = {node.id: node.routine or "" for node in tree.nodes}
    ranking = Exhaustive()(made, brief.fleet, brief.weights, 10**6, Control())
    return [
        (
            alternative.utility,
            [
                (
                    called[made.nodes[leaf].source or ""],
                    made.action(leaf).capability,
                    made.action(leaf).estimate.quality,
                )
                for leaf in selected_leaves(made, alternative.choices)
            ],
        )
        for alternative in ranking.alternatives
    ]


def keeps(entry: Entry, least: float | dict[str, float]) -> bool:
    """Read off each action: the part of a composed routine is told by the capability that rates it."""
    part_of = {"search": "Search", "follow": "Follow", "reach": "Reach"}
    for routine, capability, quality in entry[1]:
        names = (routine, capability, part_of[capability])
        wanted = max(least.get(name, 0) for name in names) if isinstance(least, dict) else least
        if quality < wanted:
            return False
    return True


def test_the_paper_fleet_is_offered_as_ever_without_terms() -> None:
    for least, without in product((0.0, {}), ((),)):
        brief = brief_of(SEARCH, fleet=paper_fleet(), min_quality=least, without=without)
        assert ground(SEARCH, brief) == ground(SEARCH, brief_of(SEARCH))
