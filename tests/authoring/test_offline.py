"""The offline author beyond single sentences: any text, scenes, fleets and routines of the user's own."""

from __future__ import annotations

import re
import time
from dataclasses import replace

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from missiontree.authoring.methods.method import MethodLibrary, built_in_methods, read_methods
from missiontree.authoring.offline import author_offline
from missiontree.authoring.outcome import Authored
from missiontree.formats.document import read_file
from missiontree.mission.brief import MissionBrief
from missiontree.mission.entity import Entity
from missiontree.mission.fleet import Fleet
from missiontree.mission.position import Position
from missiontree.mission.routine import ActionStep, Argument, Branch, RoleSpec, Routine, RoutineLibrary
from missiontree.mission.scene import Scene
from missiontree.routines.library import built_in, with_routines
from missiontree.samples.catalogue import FOLDER

FLEET: Fleet = read_file(FOLDER / "fleet.yaml", "fleet")
HALL = Scene(
    places=(
        Entity(id="lobby", kind="place", label="Lobby", position=Position(0, 0)),
        Entity(
            id="meeting_point",
            kind="place",
            label="Meeting Point",
            aliases=("assembly point",),
            position=Position(9, 9),
        ),
    ),
    entities=(
        Entity(id="anna", kind="person", label="Anna", aliases=("mom",), position=Position(1, 1)),
        Entity(id="leo", kind="person", label="Leo", aliases=("child",)),
        Entity(id="box_red", kind="object", label="Red Box", traits=("red",), position=Position(2, 2)),
        Entity(id="box_blue", kind="object", label="Blue Box", traits=("blue", "heavy"), position=Position(3, 3)),
        Entity(id="safe", kind="object", label="Safe", mass_kg=900, position=Position(4, 4)),
    ),
)


def authored(
    text: str, scene: Scene | None = None, routines: RoutineLibrary | None = None, fleet: Fleet = FLEET
) -> Authored:
    brief = MissionBrief(text=text, fleet=fleet, routines=routines or built_in(), scene=scene)
    return author_offline(brief, built_in_methods())


def calls(made: Authored) -> list[str]:
    """Routines with the ids of their entities, in tree order."""
    assert made.tree is not None, made.reasons
    return [f"{node.routine}({', '.join(node.arguments.values())})" for node in made.tree.nodes if node.routine]


def rules(made: Authored) -> set[str]:
    return {reason.rule for reason in (*made.reasons, *made.notices, *made.assumptions)}


_KNOWN = """
find the lost dog and bring it back to its owner then while before after until rescue not two cat , . ; if her there home trapped
in a building on fire help with save from Anna is found keep an eye on of to room 12 recommend please who evacuate reunite
"""
WORDS = st.sampled_from(sorted(set(re.split(r"\s+", _KNOWN.strip()))))


@given(st.text(max_size=200))
@settings(max_examples=150, deadline=None)
def test_any_text_gives_a_value(text: str) -> None:
    assert authored(text).status in {"complete", "cannot_be_done", "incomplete"}


@given(st.lists(WORDS, max_size=30).map(" ".join))
@settings(max_examples=300, deadline=None)
def test_any_order_of_words_it_knows_gives_a_value_and_the_same_one_again(text: str) -> None:
    made = authored(text)
    assert made.status in {"complete", "cannot_be_done", "incomplete"}
    assert made == authored(text)
    assert (made.status == "complete") == (not made.reasons)


@pytest.mark.parametrize(
    "text",
    [
        "find " * 10_000,
        "the cat " * 5_000,
        "and " * 10_000,
        "find the cat and " * 100,
        "a " * 900,
        "find " + "x" * 100_000,
        "with of " * 400,
    ],
)
def test_long_text_is_answered_at_once(text: str) -> None:
    begun = time.perf_counter()
    made = authored(text)
    assert made.status == "incomplete"
    assert time.perf_counter() - begun < 2  # seconds; a quadratic reader would need minutes


def test_hundred_clauses_are_built_as_they_stand() -> None:
    made = authored(". ".join(f"Go to room {number}" for number in range(100)))
    assert made.status == "complete"
    assert len(calls(made)) == 100


def test_empty_mission_says_so() -> None:
    assert rules(authored("")) == {"empty_mission"}


def test_entities_come_from_the_scene_by_alias_and_what_is_lost_is_searched_for() -> None:
    made = authored("Bring the child to mom", HALL)
    # Leo, called child, has no position; Anna, called mom, has one.
    assert calls(made) == ["Search(leo)", "ReachAndTransport(leo, anna)"]
    assert made.tree is not None
    assert [(link.first, link.second) for link in made.tree.links] == [("search-leo", "reach-and-transport-leo-anna")]
    assert {"search_added", "order_added"} <= rules(made)


def test_what_has_a_known_position_is_searched_for_only_if_the_words_ask_for_it() -> None:
    assert calls(authored("Bring the red box to Anna", HALL)) == ["ReachAndTransport(box_red, anna)"]
    assert calls(authored("Bring the lost red box to Anna", HALL)) == [
        "Search(box_red)",
        "ReachAndTransport(box_red, anna)",
    ]
    assert calls(authored("Rescue Anna", HALL))[0].startswith("ReachAndTransport(anna")


def test_reunite_searches_for_the_one_that_the_scene_does_not_know_where() -> None:
    assert calls(authored("Reunite mom with her child", HALL)) == ["Search(leo)", "ReachAndTransport(leo, anna)"]


def test_several_matches_are_a_question_and_a_trait_answers_it() -> None:
    made = authored("Bring the box to Anna", HALL)
    assert made.status == "incomplete"
    assert "box_blue" in made.reasons[0].message
    assert "box_red" in made.reasons[0].message
    assert calls(authored("Bring the heavy box to Anna", HALL)) == ["ReachAndTransport(box_blue, anna)"]
    assert calls(authored("Bring the boxes to Anna", HALL)) == [
        "ReachAndTransport(box_red, anna)",
        "ReachAndTransport(box_blue, anna)",
    ]


def test_safe_place_is_taken_from_the_scene() -> None:
    assert calls(authored("Evacuate Anna", HALL)) == ["ReachAndTransport(anna, meeting_point)"]


def test_entity_that_the_scene_lacks_is_introduced_with_an_assumption() -> None:
    made = authored("Bring the parcel to the lobby", HALL)
    assert made.tree is not None
    assert [(entity.label, entity.kind) for entity in made.tree.entities] == [("Parcel", "object")]
    assert "entity_introduced" in rules(made)


def test_load_that_nobody_can_carry_cannot_be_done_and_the_limits_are_named() -> None:
    weak = replace(FLEET, types=tuple(replace(kind, limits={"payload_kg": 50.0}) for kind in FLEET.types))
    made = authored("Bring the safe to Anna", HALL, fleet=weak)
    assert made.status == "cannot_be_done"
    assert any("900" in reason.needed + reason.message for reason in made.reasons)


def test_way_that_nobody_can_do_is_left_out_of_an_either_or_with_a_notice() -> None:
    """Of two ways to bring two together, the one in which 900 kg are carried falls away."""
    text = """format: methods/1
methods:
  - id: together
    purpose: One is brought to the other.
    says: ["<reunite> {one} with {other}"]
    steps:
      - task: "Bring {the one} and {the other} Together"
        gate: xor
        steps: [{do: "ReachAndTransport(one, other)"}, {do: "ReachAndTransport(other, one)"}]
"""
    weak = replace(FLEET, types=tuple(replace(kind, limits={"payload_kg": 90.0}) for kind in FLEET.types))
    brief = MissionBrief(text="Reunite Anna with the safe", fleet=weak, routines=built_in(), scene=HALL)
    made = author_offline(brief, MethodLibrary(methods=read_methods(text, "own.yaml").methods))
    assert made.status == "complete", made.reasons
    assert calls(made) == ["ReachAndTransport(anna, safe)"]
    assert "no_robot_able" in rules(made)


def test_verbs_of_a_users_routine_are_understood_without_a_method() -> None:
    water = Routine(
        id="Irrigate",
        purpose="Water {plant} with water from {tank}.",
        arguments=(Argument(name="plant", kinds=("object",)), Argument(name="tank", kinds=("object", "place"))),
        verbs=("water", "hydrate"),
        branches=(
            Branch(
                name="hose",
                roles=(
                    RoleSpec(name="gardener", rating="reach", actions=(ActionStep(name="pour", text="Water {plant}"),)),
                ),
            ),
        ),
    )
    library = with_routines(built_in(), [water])
    assert authored("Water the tomatoes from the tank").status == "cannot_be_done"
    assert calls(authored("Water the tomatoes from the tank", routines=library)) == ["Irrigate(tomatoes, tank)"]
    assert calls(authored("Hydrate the tomatoes with the tank then go to the lobby", routines=library)) == [
        "Irrigate(tomatoes, tank)",
        "Reach(lobby)",
    ]
    assert authored("Water the tomatoes", routines=library).status == "incomplete"


def test_reading_names_the_method_and_the_words() -> None:
    made = authored("Please rescue the cat quickly")
    assert made.reading == (
        "'rescue the cat': method rescue, <rescue> {victim}; victim = the cat (Cat); passed over: please, quickly",
    )


def test_two_things_of_one_name_are_not_taken_for_one() -> None:
    made = authored("Find the man in the blue coat and follow the man with the dog")
    assert made.status == "incomplete"


def test_a_robot_of_the_fleet_is_nobody_to_be_searched_for() -> None:
    assert authored("Find the Tele-Robot").status == "incomplete"
    assert authored("Find the Tele-Robot's charger").status == "incomplete"


def test_a_statement_is_no_goal() -> None:
    assert authored("The dog has been found").status == "incomplete"
    assert calls(authored("The dog must be found")) == ["Search(dog)"]


def test_choice_among_very_many_has_a_label_that_fits() -> None:
    made = authored(" or ".join(["find the dog"] * 90))
    assert made.status == "complete"
    assert made.tree is not None
    assert all(len(node.label) < 200 for node in made.tree.nodes[1:])


def test_nobody_is_told_that_a_capability_is_there_that_who_is_asked_for_lacks() -> None:
    made = authored("The mobile scooter should bring the box to Anna.")
    assert made.status == "cannot_be_done"
    assert made.reasons[0].needed == "carry"
    assert [notice.rule for notice in made.notices if notice.rule == "capability_present"] == []
