"""An outline to the calls that make it, and what comes of them."""

from __future__ import annotations

from dataclasses import replace

from missiontree.authoring.building import built
from missiontree.authoring.composing.composition import Composition
from missiontree.authoring.desk import Desk
from missiontree.authoring.methods.mention import Mention
from missiontree.authoring.methods.outline import Outline, Piece
from missiontree.authoring.outcome import Authored
from missiontree.mission.entity import Entity
from missiontree.mission.reason import Reason
from missiontree.mission.scene import Scene
from tests.authoring.composing.goals import composition, do
from tests.builders import brief_of

GUESS = Reason(rule="words_unused", message="It is red.", severity="assumption")
DOUBT = Reason(rule="choice_unclear", message="How far does it reach?")
CAT = Mention("cat", "cat", "cat", "animal")
ANNA = Mention("Anna", "Anna", "Anna", "person", determined=False)
HALL = Mention("hall", "hall", "hall", "place")
SAFE = Mention("safe", "Safe", "Safe", "object", new=False, known=True)
HEAVY = Scene(entities=(Entity(id="safe", label="Safe", mass_kg=900),))


def author(made: Composition, text: str = "Find the cat and bring it to Anna", scene: Scene | None = None) -> Authored:
    brief = brief_of(text, scene=scene)
    weak = replace(brief.fleet, types=tuple(replace(kind, limits={"payload_kg": 90.0}) for kind in brief.fleet.types))
    return built(Desk(replace(brief, fleet=weak)), made, [GUESS])


def labels(made: Authored) -> list[str]:
    assert made.tree is not None
    return [node.label for node in made.tree.nodes[1:]]


def links(made: Authored) -> list[tuple[str, str, str]]:
    assert made.tree is not None
    return [(link.first, link.second, link.kind) for link in made.tree.links]


def called(made: Authored) -> list[str]:
    """Names of the functions called, in order."""
    names = (
        "HierarchicalTree_init",
        "introduceEntity",
        "addMultiSubtasks",
        "attachMultiSubTrees",
        "setLink",
        "declareImpossible",
    )
    messages = made.transcript[1:-1:2]
    return [next(name for name in names if f'"{name}"' in message) for message in messages]


def test_tree_is_built_level_by_level_and_neighbours_in_one_call() -> None:
    task = Piece("Bring the Cat", pieces=[do("Reach", CAT), do("ReachAndTransport", CAT, HALL)])
    made = author(composition(do("Search", CAT), do("Follow", CAT), task), "Find the cat and bring it to the hall")
    assert (made.status, made.reasons) == ("complete", ())
    # The two routines below the objective, the task, and below it its two routines.
    assert called(made) == [
        "HierarchicalTree_init",
        "attachMultiSubTrees",
        "addMultiSubtasks",
        "attachMultiSubTrees",
    ]
    assert labels(made) == ["Search(cat)", "Follow(cat)", "Bring the Cat", "Reach(cat)", "ReachAndTransport(cat, hall)"]
    assert made.assumptions[-1] == GUESS


def test_words_of_the_mission_introduce_what_they_name_and_what_they_do_not_is_introduced_first() -> None:
    made = author(composition(do("Search", CAT)), "Find the cat")
    assert "introduceEntity" not in called(made)
    hidden = Mention("Safe Area", "Safe Area", "Safe Area", "place")
    made = author(composition(do("ReachAndTransport", CAT, hidden)), "Rescue the cat")
    assert called(made)[:2] == ["HierarchicalTree_init", "introduceEntity"]


def test_word_whose_kind_is_another_than_the_mission_means_is_introduced_as_that() -> None:
    """A box may be a place if the mission only goes there."""
    box = Mention("box", "box", "box", "place")
    made = author(composition(do("Reach", box)), "Go to the box")
    assert made.tree is not None
    assert [(entity.id, entity.kind) for entity in made.tree.entities] == [("box", "place")]


def test_links_within_one_call_go_with_it_and_others_follow() -> None:
    search, follow = do("Search", CAT), do("Follow", CAT)
    inner = do("Reach", CAT)
    made = composition(search, follow, Piece("Go There", pieces=[inner]))
    made.outline.link(search, follow)
    made.outline.link(follow, inner, "until")
    answer = author(made)
    assert called(answer)[-1] == "setLink"
    assert links(answer) == [
        ("search-cat", "follow-cat", "precedence"),
        ("follow-cat", "reach-cat", "until"),
    ]


def test_order_that_nobody_said_is_left_out_if_it_contradicts_what_was_said() -> None:
    search, follow = do("Search", CAT), do("Follow", CAT)
    said = Composition(Outline([search, follow]))
    said.outline.link(follow, search)
    said.implied.append((search, follow))
    made = author(said)
    assert made.status == "complete"
    assert links(made) == [("follow-cat", "search-cat", "precedence")]


def test_robot_types_go_with_the_routine() -> None:
    search = do("Search", CAT)
    search.resources = ("tele_robot",)
    made = author(composition(search))
    assert made.tree is not None
    assert made.tree.nodes[1].resources == ("tele_robot",)


def test_doubt_makes_it_incomplete_and_the_tree_is_there_all_the_same() -> None:
    made = composition(do("Search", CAT))
    made.doubts.append(DOUBT)
    answer = author(made)
    assert (answer.status, answer.reasons) == ("incomplete", (DOUBT,))
    assert labels(answer) == ["Search(cat)"]


def test_option_that_nobody_can_do_falls_away_with_a_notice() -> None:
    """900 kg are more than the 90 kg that anybody can carry."""
    options = [do("ReachAndTransport", ANNA, SAFE), do("ReachAndTransport", SAFE, ANNA), do("Reach", SAFE)]
    made = author(composition(Piece("One of Them", pieces=options, gate="xor")), "Anna and the safe", HEAVY)
    assert made.status == "complete", made.reasons
    assert len(labels(made)) == 3  # the task and the two options that are left
    assert [notice.rule for notice in made.notices if notice.rule == "no_robot_able"] == ["no_robot_able"]


def test_mission_that_nobody_can_do_is_declared_so() -> None:
    made = author(composition(do("ReachAndTransport", SAFE, ANNA)), "Bring the safe to Anna", HEAVY)
    assert made.status == "cannot_be_done"
    assert called(made)[-1] == "declareImpossible"
    assert made.reasons[0].rule == "no_robot_able"
    assert "payload_kg 900" in made.reasons[0].needed, "the first reason names what is lacking, and carrying is not"
    # The one robot that can carry is too weak.
    weak = [
        reason for reason in made.reasons if reason.rule == "limit_too_low" and reason.robot == "transportation_robot"
    ]
    assert [(reason.found, "payload_kg 900" in reason.needed) for reason in weak] == [("payload_kg 90", True)]


def test_call_that_is_refused_for_another_reason_leaves_it_incomplete() -> None:
    lab = Mention("lab", "lab", "lab", "place")
    made = author(composition(do("ReachAndTransport", lab, ANNA)), "Bring the lab to Anna")
    assert made.status == "incomplete"
    assert made.reasons[0].rule == "wrong_kind"
