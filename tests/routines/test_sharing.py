"""What the actions of a routine hold: shared resources by name, or those that an argument stands for."""

from __future__ import annotations

from typing import Any

import pytest

from missiontree.mission.brief import MissionBrief
from missiontree.mission.entity import Entity
from missiontree.mission.grounded import Grounding
from missiontree.mission.routine import ActionStep, Argument, Branch, Part, RoleSpec, Routine, RoutineLibrary
from missiontree.mission.scene import Scene
from missiontree.mission.shared_resource import SharedResource
from missiontree.routines.ground import ground
from tests.builders import actions_of, brief_of, flat_tree, routine_node, trivial_fleet

DOOR = Entity(id="door", kind="place")


def passing(*holds: str, robots: int = 1, sync: str | None = None) -> Routine:
    """One action at an argument, which holds something."""
    step = ActionStep(name="pass", text="Pass {gate}", duration_s=3, at="gate", holds=holds, sync=sync)
    role = RoleSpec(name="walker", rating="walk", actions=(step,), robots=robots)
    return Routine(
        id="Pass",
        purpose="Pass {gate}.",
        arguments=(Argument(name="gate", kinds=("place",)),),
        branches=(Branch(name="walk", roles=(role,)),),
    )


def brief(routines: tuple[Routine, ...], *shared: SharedResource, **more: Any) -> MissionBrief:
    scene = Scene(places=(DOOR,), resources=shared)
    fleet = trivial_fleet({"r": 2}, capabilities={"walk": 1.0})
    return brief_of("Mission", fleet, RoutineLibrary(routines=routines), **{"scene": scene, **more})


def grounded(routine: Routine, *shared: SharedResource) -> Grounding:
    """One call of the routine on the door."""
    tree = flat_tree(routine_node("go", "Pass", gate="door"))
    return ground(tree, brief((routine,), *shared))


def test_an_argument_in_braces_stands_for_the_resource_of_its_name() -> None:
    made = grounded(passing("{gate}", "key"), SharedResource(id="door"), SharedResource(id="key", capacity=2))
    assert [action.holds for action in actions_of(made.tree)] == [("door", "key")]
    assert [one.rule for one in made.assumptions] == ["position_unknown"]


def test_the_arguments_of_parts_are_those_of_the_routine_around_them() -> None:
    outer = Routine(
        id="Visit",
        purpose="Visit {place}.",
        arguments=(Argument(name="place", kinds=("place",)),),
        parts=(Part(routine="Pass", arguments={"gate": "place"}),),
    )
    tree = flat_tree(routine_node("go", "Visit", place="door"))
    made = ground(tree, brief((passing("{gate}"), outer), SharedResource(id="door")))
    assert [action.holds for action in actions_of(made.tree)] == [("door",)]


def test_an_argument_that_is_no_resource_has_no_limit_and_that_is_said() -> None:
    made = grounded(passing("{gate}"), SharedResource(id="key"))
    assert [action.holds for action in actions_of(made.tree)] == [()]
    (reason,) = [one for one in made.assumptions if one.rule == "resource_unlimited"]
    assert (reason.rule, reason.found, reason.needed) == ("resource_unlimited", "door", "key")
    assert "{id: door, capacity: 1}" in reason.hint


def test_joint_work_that_asks_for_more_than_there_is_room_for_is_not_offered() -> None:
    """Two robots hold the door together, which has room for one; one after the other they may."""
    both = passing("{gate}", robots=2, sync="walk")
    made = grounded(both, SharedResource(id="door", label="Door"))
    assert actions_of(made.tree) == []
    (reason,) = [one for one in made.not_offered if one.rule == "resource_too_small"]
    assert (reason.found, reason.needed) == ("capacity 1", "capacity 2")
    assert reason.message == "Pass(door) has 2 robots hold Door at once, and it has room for 1."
    assert len(actions_of(grounded(both, SharedResource(id="door", capacity=2)).tree)) == 2
    assert len(actions_of(grounded(passing("{gate}", robots=2), SharedResource(id="door")).tree)) == 2


def test_a_name_that_the_scene_does_not_have_is_refused_with_the_nearest() -> None:
    with pytest.raises(
        ValueError, match=r"holds 'kye', which is no shared resource .* the nearest is 'key'\. It has key"
    ):
        brief((passing("kye"),), SharedResource(id="key"))
    assert brief((passing("kye"),), scene=None).scene is None  # without a scene there is nothing to share


@pytest.mark.parametrize("held", ["", "two words", "{gate", "{}", "gate}"])
def test_what_is_no_name_is_refused(held: str) -> None:
    with pytest.raises(ValueError, match="accepted are ids of the scene's resources, and an argument in braces"):
        passing(held)


def test_an_argument_that_the_routine_does_not_have_is_refused() -> None:
    with pytest.raises(ValueError, match="speaks of 'lift', which is not among its arguments gate"):
        passing("{lift}")


def test_what_is_held_twice_is_refused() -> None:
    with pytest.raises(ValueError, match="'key' stands twice"):
        passing("key", "key")
