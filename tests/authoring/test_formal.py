"""Goals that are stated formally: the same trees as in words, and refusals that say what there is."""

from __future__ import annotations

import re
from typing import Any

import pytest

from missiontree.authoring.formal import author_formal
from missiontree.authoring.methods.method import MethodLibrary, built_in_methods, read_methods
from missiontree.authoring.offline import author_offline
from missiontree.authoring.outcome import Authored
from missiontree.authoring.transcript import replay
from missiontree.mission.brief import MissionBrief
from missiontree.mission.entity import Entity
from missiontree.mission.fleet import Fleet, Robot, RobotType
from missiontree.mission.goal import Goal, check_goals, in_words
from missiontree.mission.position import Position
from missiontree.mission.scene import Scene
from missiontree.mission.tree import MUTUAL, MissionTree
from missiontree.routines.library import built_in

SCENE = Scene(
    places=(Entity(id="hall", kind="place", label="Great Hall", position=Position(9, 9)),),
    entities=(
        Entity(id="anna", kind="person", label="Anna", position=Position(1, 1)),
        Entity(id="leo", kind="person", label="Leo", aliases=("the boy",)),
        Entity(id="crate_1", kind="object", label="Crate", position=Position(2, 2)),
        Entity(id="crate_2", kind="object", label="Crate", position=Position(3, 3)),
    ),
)


def goal(**fields: Any) -> Goal:
    """A goal whose lists are written as lists."""
    return Goal(**fields)


def brief(fleet: Fleet, *goals: Goal, **more: Any) -> MissionBrief:
    return MissionBrief(**{"text": in_words(goals), "fleet": fleet, "routines": built_in(), "goals": goals, **more})


def shape(made: Authored) -> tuple[list[tuple[Any, ...]], set[tuple[str, str, str]]]:
    """Gates, routines, arguments and resources in preorder, and the links; labels and the root's id aside."""
    assert made.tree is not None, made.reasons
    nodes = [
        (len(list(made.tree.ancestors(n.id))), n.gate, n.routine, tuple(n.arguments.items()), n.resources)
        for n in made.tree.nodes
    ]
    order = {node.id: str(index) for index, node in enumerate(made.tree.nodes)}
    return nodes, {(order[link.first], order[link.second], link.kind) for link in made.tree.links}


def calls(tree: MissionTree | None) -> list[str]:
    assert tree is not None
    return [f"{node.routine}({', '.join(node.arguments.values())})" for node in tree.nodes if node.routine]


@pytest.mark.parametrize(
    ("words", "goals"),
    [
        ("Find the keys", [goal(do="Search(keys)")]),
        ("Find the keys with the tele-robot", [goal(do="Search(keys)", by=["tele_robot"])]),
        (
            "Find the keys, then bring them to Anna",
            [goal(do="SearchTree(keys)", name="find"), goal(do="ReachAndTransport(keys, Anna)", after=["find"])],
        ),
        (
            "Follow the dog until you have found the keys",
            [goal(do="Follow(dog)", until="found"), goal(do="Search(keys)", name="found")],
        ),
        ("Reunite mom with her child", [goal(method="reunite", slots={"lost": "mom", "keeper": "child"})]),
        (
            "Rescue cat trapped in a building on fire",
            [goal(method="rescue", slots={"victim": "cat", "site": "building on fire"})],
        ),
        ("Help the woman carry the luggage", [goal(method="help_with", slots={"person": "woman", "load": "luggage"})]),
        ("Evacuate the school", [goal(method="evacuate_place", slots={"place": "school"})]),
        (
            "Save the city from the monster",
            [goal(method="save_from_threat", slots={"place": "city", "threat": "monster"})],
        ),
    ],
)
def test_the_tree_is_the_one_that_the_same_mission_in_words_gives(fleet: Fleet, words: str, goals: list[Goal]) -> None:
    in_text = author_offline(MissionBrief(text=words, fleet=fleet, routines=built_in()))
    formal = author_formal(brief(fleet, *goals))
    assert formal.status == in_text.status == "complete", (formal.reasons, in_text.reasons)
    assert shape(formal) == shape(in_text)


def test_the_reading_has_a_line_for_each_goal(fleet: Fleet) -> None:
    task = goal(
        task="Tidy up", gate="xor", goals=[goal(do="Reach(box)", not_by=["social_robot"]), goal(do="Search(box)")]
    )
    made = author_formal(brief(fleet, goal(method="rescue", slots={"victim": ["Anna", "Tom"]}), task))
    assert made.status == "complete", made.reasons
    assert made.reading == (
        "goal 1: method rescue; victim = Anna and Tom",
        "goal 2: task 'Tidy up', xor",
        "goal 2.1: routine Reach; agent = Box; not by social_robot",
        "goal 2.2: routine Search; agent = Box",
    )
    assert made.tree is not None
    assert [node.label for node in made.tree.nodes if node.routine is None][1:] == ["Rescue Anna and Tom", "Tidy Up"]
    assert made.tree.nodes[-2].resources == ("mobile_scooter", "tele_robot", "transportation_robot")
    assert made.tree.nodes[-1].resources is None


def test_entities_are_of_the_scene_by_id_label_or_alias_and_who_is_lost_is_searched_for(fleet: Fleet) -> None:
    made = author_formal(brief(fleet, goal(do="ReachAndTransport(The Boy, Great Hall)"), scene=SCENE))
    # Leo has no position, so a search for him goes before; "The Boy" is an alias, compared letter case aside.
    assert calls(made.tree) == ["Search(leo)", "ReachAndTransport(leo, hall)"]
    assert {"search_added", "order_added"} <= {notice.rule for notice in made.notices}


def test_without_a_scene_kinds_follow_the_nouns_and_are_assumptions_unless_declared(fleet: Fleet) -> None:
    goals = (goal(do="Reach(dog)"), goal(do="Reach(Rex)"), goal(do="Reach(thingamajig)"))
    made = author_formal(brief(fleet, *goals, text="A title that names none of them"))
    assert made.tree is not None
    assert [(e.label, e.kind) for e in made.tree.entities] == [
        ("Rex", "person"),
        ("Dog", "animal"),
        ("Thingamajig", "object"),
    ]
    assert [reason.rule for reason in made.assumptions] == ["entity_introduced"] * 3
    declared = (Entity(id="rex", kind="animal", label="Rex", position=Position(1, 1)),)
    made = author_formal(brief(fleet, goal(do="Reach(Rex)"), entities=declared))
    assert (calls(made.tree), made.assumptions) == (["Reach(rex)"], ())


def test_links_reach_across_tasks_and_into_methods(fleet: Fleet) -> None:
    inner = goal(do="Search(keys)", name="keys")
    made = author_formal(
        brief(
            fleet,
            goal(task="Look about", goals=[inner, goal(do="Search(dog)")]),
            goal(method="rescue", slots={"victim": "Anna"}, after=["keys"]),
        )
    )
    assert made.tree is not None
    rescue = next(node for node in made.tree.nodes if node.label == "Rescue Anna")
    assert ("search-keys", rescue.id) in {(link.first, link.second) for link in made.tree.links}


def test_what_two_goals_search_for_is_searched_for_once_and_no_order_is_lost(fleet: Fleet) -> None:
    look = goal(task="Look about", name="look", goals=[goal(do="Search(keys)"), goal(do="Search(dog)")])
    made = author_formal(
        brief(
            fleet,
            goal(do="Search(keys)"),
            goal(do="Search(dog)"),
            look,
            goal(do="Reach(Anna)", after=["look"]),
        )
    )
    # The task has nothing left of its own, so what waits for it waits for the two searches that stand for it.
    assert made.status == "complete", made.reasons
    assert calls(made.tree) == ["Search(keys)", "Search(dog)", "Reach(anna)"]
    assert made.tree is not None
    assert {(link.first, link.second) for link in made.tree.links} == {
        ("search-keys", "reach-anna"),
        ("search-dog", "reach-anna"),
    }


def test_tasks_of_one_name_are_told_apart(fleet: Fleet) -> None:
    same = [goal(task="Look", goals=[goal(do=f"Search({who})")]) for who in ("keys", "dog")]
    made = author_formal(brief(fleet, goal(task="All", goals=same), goal(do="Reach(Anna)")))
    assert made.tree is not None
    assert [node.label for node in made.tree.nodes if node.routine is None][2:] == ["Look", "Look (2)"]


@pytest.mark.parametrize(
    ("asked", "rule", "words", "hint"),
    [
        (goal(do="Sreach(keys)"), "unknown_routine", "no routine 'Sreach'", "'Search'"),
        (goal(do="Search(keys, Anna)"), "wrong_arguments", "takes 1 (agent), and 2 are named", "Write Search(agent)."),
        (
            goal(method="resque", slots={"victim": "Anna"}),
            "unknown_method",
            "no method 'resque'",
            "Did you mean 'rescue'?",
        ),
        (goal(method="rescue", slots={"vctim": "Anna"}), "unknown_slot", "no slot 'vctim'", "Did you mean 'victim'?"),
        (
            goal(method="rescue", slots={"site": "barn"}),
            "missing_slot",
            "needs victim, or victim and site; filled is site",
            "",
        ),
        (goal(method="rescue"), "missing_slot", "filled is nothing", ""),
        (
            goal(method="save_from_threat", slots={"place": "Anna", "threat": "monster"}),
            "condition_not_met",
            "slot place takes what is place; Anna is person",
            "declare the kind",
        ),
        (
            goal(method="save_from_threat", slots={"place": "school", "threat": "gas leak"}),
            "condition_not_met",
            "Gas Leak is hazard",
            "",
        ),
        (
            goal(task="All", by=["tele_robot"], goals=[goal(do="Search(keys)", not_by=["tele_robot"])]),
            "nobody_allowed",
            "tele_robot on the other",
            "",
        ),
        (
            goal(do="Search(x)", not_by=["mobile_scooter", "tele_robot", "transportation_robot", "social_robot"]),
            "nobody_allowed",
            "no robot type is left",
            "",
        ),
    ],
)
def test_a_goal_that_cannot_be_built_says_what_there_is(
    fleet: Fleet, asked: Goal, rule: str, words: str, hint: str
) -> None:
    made = author_formal(brief(fleet, asked))
    assert (made.status, [reason.rule for reason in made.reasons]) == ("incomplete", [rule])
    assert words in made.reasons[0].message
    assert hint in made.reasons[0].hint
    assert made.tree is None


def test_every_goal_that_cannot_be_built_is_told(fleet: Fleet) -> None:
    made = author_formal(brief(fleet, goal(do="A(x)"), goal(do="Search(x)"), goal(task="T", goals=[goal(do="B(x)")])))
    assert [reason.message.split(",")[0] for reason in made.reasons] == ["Goal 1", "Goal 3.1"]


@pytest.mark.parametrize(
    ("name", "rule", "words"),
    [("Crate", "ambiguous_name", "crate_1, crate_2"), ("Ana", "unknown_entity", "Did you mean 'Anna'?")],
)
def test_whom_the_scene_does_not_have_is_refused(fleet: Fleet, name: str, rule: str, words: str) -> None:
    made = author_formal(brief(fleet, goal(do=f"Reach({name})"), scene=SCENE))
    assert [reason.rule for reason in made.reasons] == [rule]
    assert words in f"{made.reasons[0].message} {made.reasons[0].hint}"


def test_an_id_is_one_even_where_another_differs_in_the_case_of_its_letters_alone(fleet: Fleet) -> None:
    twins = (
        Entity(id="b", kind="object", position=Position(1, 1)),
        Entity(id="B", kind="place", position=Position(2, 2)),
    )
    for name in ("b", "B"):
        made = author_formal(brief(fleet, goal(do=f"Reach({name})"), scene=Scene(entities=twins[:1], places=twins[1:])))
        assert calls(made.tree) == [f"Reach({name})"]


@pytest.mark.parametrize(
    ("name", "words"),
    [
        ("it", "'it' is a pronoun"),
        ("everyone", "'everyone' is a pronoun"),
        ("happiness", "is nothing that a robot can find, reach or carry"),
        ("the dog and the cat", "holds 'and'"),
        ("dog or cat", "holds 'or'"),
        ("everyone but Anna", "holds 'but'"),
        ("her dog", "begins with 'her'"),
        ("two dogs", "begins with 'two'"),
        ("the old grey barn by the river", "has 6 words; a name has at most 5"),
    ],
)
def test_without_a_scene_only_a_plain_name_introduces_somebody(fleet: Fleet, name: str, words: str) -> None:
    made = author_formal(brief(fleet, goal(do=f"Reach({name})")))
    assert (made.status, [reason.rule for reason in made.reasons]) == ("incomplete", ["no_plain_name"])
    assert words in made.reasons[0].message
    assert "declare it under entities" in made.reasons[0].hint
    declared = (Entity(id="somebody", kind="person", label=name),)
    assert author_formal(brief(fleet, goal(do=f"Reach({name})"), entities=declared)).status == "complete"


def test_a_comma_in_a_slot_is_no_plain_name_and_an_article_is_none_of_it(fleet: Fleet) -> None:
    made = author_formal(brief(fleet, goal(method="rescue", slots={"victim": "Anna, Tom"})))
    assert [reason.rule for reason in made.reasons] == ["no_plain_name"]
    made = author_formal(brief(fleet, goal(do="Reach(the dog)"), goal(do="Search(a cat)")))
    assert calls(made.tree) == ["Reach(dog)", "Search(cat)"]


@pytest.mark.parametrize("name", ["tele_robot", "Tele-Robot", "the mobile scooters", "robot"])
@pytest.mark.parametrize("scene", [None, SCENE])
def test_a_robot_is_nobody_to_whom_something_is_done(fleet: Fleet, name: str, scene: Scene | None) -> None:
    made = author_formal(brief(fleet, goal(do=f"Search({name})"), scene=scene))
    assert [reason.rule for reason in made.reasons] == ["names_a_robot"]
    assert "by: [type]" in made.reasons[0].hint


def test_a_single_robot_is_refused_as_one_of_its_type(fleet: Fleet) -> None:
    spot = RobotType(id="walker", label="Walker", capabilities=fleet.types[0].capabilities, robots=(Robot(id="spot"),))
    made = author_formal(brief(Fleet(types=(*fleet.types, spot)), goal(do="Search(spot)")))
    assert "'spot' is one robot of the type Walker" in made.reasons[0].message


@pytest.mark.parametrize(
    "asked",
    [
        goal(do="ReachAndTransport(box, The Box)"),
        goal(method="reunite", slots={"lost": "Anna", "keeper": "anna"}),
        goal(method="evacuate_to", slots={"victim": ["Anna", "depot"], "place": "depot"}),
    ],
)
def test_nothing_is_brought_to_itself(fleet: Fleet, asked: Goal) -> None:
    made = author_formal(brief(fleet, asked))
    assert [reason.rule for reason in made.reasons] == ["same_entity_twice"]
    assert "twice" in made.reasons[0].message


def choice(**second: Any) -> Goal:
    return goal(
        task="Look", gate="xor", name="look", goals=[goal(do="Search(keys)", name="a"), goal(do="Reach(cow)", **second)]
    )


@pytest.mark.parametrize(
    ("goals", "rule", "words"),
    [
        ([choice(), goal(do="Reach(dog)", after=["a"])], "link_may_not_bind", "starts after 'Search(keys)' only if"),
        ([choice(), goal(do="Follow(dog)", until="a")], "link_may_not_bind", "lasts until 'Search(keys)' only if"),
        ([choice(after=["a"])], "link_never_binds", "starts after 'Search(keys)', and they are options of one choice"),
        ([choice(same_robot=["a"])], "link_never_binds", "has the robot of 'Search(keys)', and they are options"),
        (
            [choice(), goal(do="Reach(dog)", different_robot=["a"])],
            "link_may_not_bind",
            "has another robot than 'Search(keys)' only if",
        ),
        ([choice(), goal(do="Reach(dog)", after=["look"])], "", ""),
        ([choice(after=["b"]), goal(do="Search(dog)", name="b")], "", ""),
    ],
)
def test_a_link_to_an_option_is_told(fleet: Fleet, goals: list[Goal], rule: str, words: str) -> None:
    made = author_formal(brief(fleet, *goals))
    assert made.status == "complete", made.reasons
    told = [notice for notice in made.notices if notice.rule.startswith("link_")]
    assert [notice.rule for notice in told] == ([rule] if rule else [])
    assert all(words in notice.message for notice in told)


@pytest.mark.parametrize(
    ("bonds", "links"),
    [
        ({"same_robot": ["a"]}, {("a", "b", "same_robot")}),
        ({"different_robot": ["a", "c"]}, {("a", "b", "different_robot"), ("b", "c", "different_robot")}),
        ({"takes_over_from": "a"}, {("a", "b", "hand_over")}),
        (
            {"after": ["a"], "same_robot": ["a"], "different_robot": ["c"]},
            {("a", "b", "precedence"), ("a", "b", "same_robot"), ("b", "c", "different_robot")},
        ),
    ],
)
def test_goals_say_which_robots_do_them(fleet: Fleet, bonds: dict[str, Any], links: set[tuple[str, str, str]]) -> None:
    """Each field makes one link between the goals; what holds both ways may be said by both, and makes one link as well."""
    mutual = {bond: ["b"] for bond in bonds if bond in {"same_robot", "different_robot"} and "a" in bonds[bond]}
    for said in ({}, mutual):
        goals = [
            goal(name="a", do="Search(keys)", **said),
            goal(name="b", do="Reach(dog)", **bonds),
            goal(name="c", do="Search(ball)"),
        ]
        made = author_formal(brief(fleet, *goals))
        assert made.tree is not None, made.reasons
        named = {node.id: "abc"[number] for number, node in enumerate(n for n in made.tree.nodes if n.routine)}
        found = [(named[link.first], named[link.second], link.kind) for link in made.tree.links]
        assert {(*sorted(ends), kind) if kind in MUTUAL else (*ends, kind) for *ends, kind in found} == links
        assert len(found) == len(links)


@pytest.mark.parametrize(
    ("first", "second", "words"),
    [
        ({}, {"same_robot": ["nobody"]}, "refers to goal 'nobody'; named goals are: a, b"),
        ({}, {"different_robot": ["b"]}, "cannot name, by different_robot, 'b'; that is the same goal"),
        ({}, {"takes_over_from": "b"}, "cannot wait for 'b'; that is the same goal"),
        (
            {},
            {"same_robot": ["a"], "takes_over_from": "a"},
            "names 'a' by takes_over_from, and one robot is to do both",
        ),
        (
            {"same_robot": ["b"]},
            {"different_robot": ["a"]},
            "names 'a' by different_robot, and one robot is to do both",
        ),
        ({"after": ["b"]}, {"takes_over_from": "a"}, "the order of the goals is a circle"),
    ],
)
def test_what_goals_say_of_robots_in_vain_is_refused(first: dict[str, Any], second: dict[str, Any], words: str) -> None:
    goals = (goal(name="a", do="Search(keys)", **first), goal(name="b", do="Reach(dog)", **second))
    with pytest.raises(ValueError, match=re.escape(words)):
        check_goals(goals)


def test_what_the_builder_refuses_is_told_in_its_words(fleet: Fleet) -> None:
    nothing_lasts = [goal(do="Search(dog)", until="a"), goal(do="Search(keys)", name="a")]
    assert author_formal(brief(fleet, *nothing_lasts)).reasons[0].rule == "not_open_ended"
    assert author_formal(brief(fleet, goal(do="Transport(hall, anna)"), scene=SCENE)).reasons[0].rule == "wrong_kind"
    made = author_formal(brief(fleet, goal(do="Search(dog)", by=["social_robot"])))
    assert (made.status, made.reasons[0].rule) == ("cannot_be_done", "no_robot_able")


def test_a_method_of_the_users_own_is_used_and_one_that_does_not_fit_is_refused(fleet: Fleet) -> None:
    text = """format: methods/1
methods:
  - id: show
    purpose: Somebody is shown something.
    says: ["show {thing} to {person}"]
    steps: [{do: "Reach(person)", capability: %s}, {do: "%s(thing)"}]
"""

    def made(capability: str, routine: str) -> Authored:
        own = read_methods(text % (capability, routine), "own.yaml").methods
        show = goal(method="show", slots={"thing": "map", "person": "Anna"})
        return author_formal(brief(fleet, show), MethodLibrary(methods=(*own, *built_in_methods().methods)))

    done = made("message_display", "Search")
    assert calls(done.tree) == ["Reach(anna)", "Search(map)"]
    assert done.tree is not None
    assert done.tree.nodes[1].resources == ("social_robot",)
    assert made("message_display", "Juggle").reasons[0].rule == "method_unfit"
    nobody = made("teleport", "Search")
    assert (nobody.status, nobody.reasons[0].needed) == ("cannot_be_done", "teleport")


def test_who_is_called_and_what_is_implied_may_be_named(fleet: Fleet) -> None:
    slots = {"victim": "Anna", "responder": "medic", "safety": "school"}
    made = author_formal(brief(fleet, goal(method="rescue", slots=slots)))
    assert calls(made.tree) == ["Search(medic)", "Search(anna)", "ReachAndTransport(anna, school)"]


def test_the_transcript_replays_to_the_same_tree(fleet: Fleet) -> None:
    mission = brief(fleet, goal(method="rescue", slots={"victim": "Anna"}), goal(do="Search(keys)", by=["tele_robot"]))
    made = author_formal(mission)
    again = replay(made.transcript, mission)
    assert (again.status, again.tree, again.reading) == ("complete", made.tree, made.reading)
    assert all(notice.rule != "other_inputs" for notice in again.notices)


def test_what_is_only_spoken_of_need_not_be_in_the_scene(fleet: Fleet) -> None:
    made = author_formal(brief(fleet, goal(method="warn", slots={"target": "leo", "danger": "wasps"}), scene=SCENE))
    assert made.status == "complete", made.reasons
    assert "Reach(leo)" in calls(made.tree)


def times(made: Authored) -> dict[str, tuple[float, float | None]]:
    """Release time and deadline by label, of nodes that have any."""
    assert made.tree is not None, made.reasons
    return {
        node.label: (node.release_s, node.deadline_s)
        for node in made.tree.nodes
        if node.release_s or node.deadline_s is not None
    }


def test_times_of_goals_stand_on_what_is_built_for_them_and_replay(fleet: Fleet) -> None:
    inner = [goal(do="Search(keys)", deadline_s=20.0), goal(do="Search(bag)")]
    mission = brief(
        fleet, goal(task="Look", goals=inner, release_s=5.0), goal(do="Reach(door)", release_s=9, deadline_s=60)
    )
    made = author_formal(mission)
    assert times(made) == {"Look": (5, None), "Search(Keys)": (0, 20), "Reach(Door)": (9, 60)}
    assert replay(made.transcript, mission).tree == made.tree
    assert made.reading[1].endswith("; by 20 s")
    assert made.reading[3].endswith("; from 9 s; by 60 s")


def look(**times: float) -> Goal:
    """A task that looks for the keys, too, and for the dog."""
    return goal(task="Look", goals=[goal(do="Search(keys)"), goal(do="Search(dog)")], **times)


def test_what_is_searched_for_once_keeps_the_times_of_every_goal(fleet: Fleet) -> None:
    """The keys by 50 s, and within a task that goes from 10 s until 90 s: once, from 10 s until 50 s."""
    goals = goal(do="Search(keys)", deadline_s=50.0), look(release_s=10.0, deadline_s=90.0)
    assert times(author_formal(brief(fleet, *goals))) == {"Search(Keys)": (10, 50), "Look": (10, 90)}


def test_times_that_exclude_each_other_are_told(fleet: Fleet) -> None:
    made = author_formal(brief(fleet, goal(do="Search(keys)", deadline_s=5.0), look(release_s=10.0)))
    assert (made.status, [reason.rule for reason in made.reasons]) == ("incomplete", ["times_conflict"])
    assert "from 10 s and by 5 s" in made.reasons[0].message
    with pytest.raises(ValueError, match=r"has the deadline 5 s, before its release time 10 s"):
        goal(do="Search(keys)", release_s=10.0, deadline_s=5.0)
