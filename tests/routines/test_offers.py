"""What a call has on offer, and every Reason why the rest is not."""

from __future__ import annotations

import pytest

from missiontree.errors import InputError
from missiontree.mission.entity import Entity
from missiontree.mission.routine import ActionStep, Argument, Branch, RoleSpec, Routine
from missiontree.mission.scene import Scene
from missiontree.routines.library import built_in, with_routines
from missiontree.routines.offers import Offers, offers_for
from tests.builders import paper_fleet, trivial_fleet

CAT = Entity(id="cat", kind="animal", mass_kg=4)
YARD = Entity(id="yard", kind="place")


def transport(resources: tuple[str, ...] | None = None, check_kinds: bool = True) -> Offers:
    library = built_in()
    entities = {"agent": CAT, "location": YARD}
    return offers_for(
        library.by_id["Transport"],
        entities,
        paper_fleet(),
        Scene(),
        library,
        resources=resources,
        check_kinds=check_kinds,
    )


def pair(robots: int = 1, second: str = "lift") -> Routine:
    step = (ActionStep(name="lift", text="Lift {thing}", sync="up"),)
    roles = (
        RoleSpec(name="left", rating="lift", actions=step, robots=robots),
        RoleSpec(name="right", rating=second, actions=step),
    )
    return Routine(
        id="Lift",
        purpose="Lift {thing}",
        arguments=(Argument(name="thing", kinds=("object",)),),
        branches=(Branch(name="pair", roles=roles),),
    )


def test_a_message_needs_a_reader() -> None:
    offers = transport()
    assert [(offer.branch.name, offer.types) for offer in offers.branches] == [("carry", (("transportation_robot",),))]
    (refusal,) = [reason for reason in offers.refused if reason.rule == "kind_refused"]
    assert (
        refusal.message
        == "Transport(cat, yard) by message_display takes as agent only person, and cat is of kind animal."
    )
    assert offers.able_types == ("transportation_robot",)


def test_with_kinds_off_the_cat_reads() -> None:
    offers = transport(check_kinds=False)
    assert [offer.types for offer in offers.branches] == [(("transportation_robot",),), (("social_robot",),)]


def test_the_missing_payload_is_an_assumption() -> None:
    assert [reason.rule for reason in transport().assumptions] == ["limit_unknown"]


def test_resources_leave_only_the_types_named() -> None:
    offers = transport(resources=("social_robot",))
    assert not offers.able
    excluded = [reason.robot for reason in offers.refused if reason.rule == "resource_excluded"]
    assert excluded == ["mobile_scooter", "tele_robot", "transportation_robot"]


def test_an_unknown_resource_is_bad_input_with_the_nearest_match() -> None:
    with pytest.raises(InputError, match="Did you mean 'social_robot'"):
        transport(resources=("social_robto",))


@pytest.mark.parametrize("entities", [{"agent": CAT}, {"agent": CAT, "location": YARD, "colour": CAT}])
def test_arguments_must_be_the_routines(entities: dict[str, Entity]) -> None:
    library = built_in()
    with pytest.raises(InputError) as caught:
        offers_for(library.by_id["Transport"], entities, paper_fleet(), Scene(), library)
    assert caught.value.accepted == "agent, location"


def lift(routine: Routine, counts: dict[str, int], capability: str = "lift") -> Offers:
    library = with_routines(built_in(), [routine])
    fleet = trivial_fleet(counts, capabilities={capability: 1})
    return offers_for(routine, {"thing": Entity(id="crate")}, fleet, Scene(), library)


def test_a_team_needs_different_robots() -> None:
    assert lift(pair(), {"a": 2}).able
    assert [reason.rule for reason in lift(pair(), {"a": 1}).refused] == ["too_few_robots"]
    assert lift(pair(robots=2), {"a": 1, "b": 2}).able
    assert not lift(pair(robots=2), {"a": 1, "b": 1}).able


def test_a_role_that_nobody_fills_loses_the_branch_and_says_which() -> None:
    offers = lift(pair(second="push"), {"a": 5})
    assert not offers.able
    # a can be left but not right; that the branch is lost to a as left, too, is said by the second.
    assert [(reason.rule, reason.robot) for reason in offers.refused] == [
        ("capability_missing", "a"),
        ("no_robot_able", ""),
    ]
    assert "as right" in offers.refused[1].message
