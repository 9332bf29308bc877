"""Routines whose roles hand over to each other."""

from __future__ import annotations

from typing import Any

import pytest

from missiontree.mission.brief import MissionBrief
from missiontree.mission.entity import Entity
from missiontree.mission.routine import (
    ActionStep,
    Argument,
    Branch,
    HandOver,
    Part,
    RoleSpec,
    Routine,
    RoutineLibrary,
)
from missiontree.mission.scene import Scene
from missiontree.routines.ground import ground
from tests.builders import brief_of, flat_tree, routine_node, trivial_fleet


def step(name: str, **given: Any) -> ActionStep:
    return ActionStep(name=name, text=name, **given)


def role(name: str, *steps: ActionStep, **given: Any) -> RoleSpec:
    return RoleSpec(name=name, rating="work", actions=steps, **given)


BRING = step("bring", goes_to="place", brings=("load",))
TAKE = step("take", at="load")


def branch(*roles: RoleSpec, hand_overs: tuple[tuple[str, str], ...] = (("giver", "taker"),)) -> Branch:
    return Branch(
        name="relay",
        roles=roles or (role("giver", BRING), role("taker", TAKE)),
        hand_overs=tuple(HandOver(giver=giver, taker=taker) for giver, taker in hand_overs),
    )


def brief(*more: Routine) -> MissionBrief:
    relay = Routine(
        id="Relay",
        purpose="Bring {load} to {place} and on.",
        arguments=(Argument(name="load", kinds=("object",)), Argument(name="place", kinds=("place",))),
        branches=(branch(),),
    )
    scene = Scene(places=(Entity(id="p", kind="place"),), entities=(Entity(id="box"),))
    fleet = trivial_fleet({"r": 2}, capabilities={"work": 1.0})
    return brief_of("Mission", fleet, RoutineLibrary(routines=(relay, *more)), scene=scene)


def test_the_roles_of_a_routine_are_linked_in_the_grounded_tree() -> None:
    """Each role is a choice of types below an AND; the link joins the two choices."""
    tree = ground(flat_tree(routine_node("go", "Relay", load="box", place="p")), brief()).tree
    (link,) = tree.links
    assert link.kind == "hand_over"
    assert [tree.nodes[end].label for end in (link.first, link.second)] == ["giver", "taker"]


def test_a_routine_composed_of_one_that_hands_over_keeps_it() -> None:
    twice = Routine(
        id="Twice",
        purpose="Bring {load} to {place}, twice.",
        arguments=(Argument(name="load", kinds=("object",)), Argument(name="place", kinds=("place",))),
        parts=(Part(routine="Relay"), Part(routine="Relay")),
    )
    tree = ground(flat_tree(routine_node("go", "Twice", load="box", place="p")), brief(twice)).tree
    pairs = [(link.first, link.second) for link in tree.links if link.kind == "hand_over"]
    assert [[tree.nodes[end].label for end in pair] for pair in pairs] == [["giver", "taker"]] * 2
    assert len({end for pair in pairs for end in pair}) == 4


def test_a_role_may_end_with_what_has_no_place_of_its_own() -> None:
    """It is still where its last move led, and so is what that brought; and what is done at either leaves it there."""
    for last in (step("hold"), step("hold", at="place"), step("hold", at="load")):
        for first in (step("take", at="load"), step("take", at="place")):
            assert branch(role("giver", BRING, last), role("taker", first)).hand_overs


@pytest.mark.parametrize(
    ("roles", "hand_overs", "why"),
    [
        ((), (("giver", "nobody"),), "there is no role 'nobody'; roles are giver, taker"),
        ((), (("giver", "giver"),), "it is one role"),
        ((), (("giver", "taker"), ("giver", "taker")), "giver 'giver' stands twice"),
        ((role("giver", BRING), role("taker", step("take"))), None, "'take' is done at no place; give it at"),
        ((role("giver", BRING), role("taker", step("go", goes_to="place"))), None, "'go' is done at no place"),
        ((role("giver", step("look")), role("taker", TAKE)), None, "'giver' ends at a place, which it has not"),
        (
            (role("giver", BRING, step("see", at="other")), role("taker", TAKE)),
            None,
            "'take' is done at 'load', and 'giver' ends at other",
        ),
        ((role("giver", step("keep", at="load", open_ended=True)), role("taker", TAKE)), None, "'keep' has no end"),
        (
            (role("giver", BRING, robots=2), role("taker", TAKE)),
            None,
            "'giver' has 2 robots, which do 'bring' not jointly",
        ),
        (
            (role("giver", step("a", at="load", sync="s")), role("taker", step("b", at="load", sync="s"))),
            None,
            "they are done jointly",
        ),
        (
            (role("giver", BRING), role("taker", TAKE), role("third", TAKE)),
            (("giver", "taker"), ("taker", "third")),
            "'taker' takes over, too; give it a second action",
        ),
    ],
)
def test_what_can_never_be_handed_over_is_refused(roles: tuple[RoleSpec, ...], hand_overs: Any, why: str) -> None:
    with pytest.raises(ValueError, match=why):
        branch(*roles, **({} if hand_overs is None else {"hand_overs": hand_overs}))
