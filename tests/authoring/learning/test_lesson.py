"""Trees become methods: whom the words name become slots, what is done stays, and the method gives the tree again with others in it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import pytest

from missiontree.authoring.author import author_tree
from missiontree.authoring.learning.likeness import difference
from missiontree.authoring.learning.teaching import method_from
from missiontree.authoring.learning.writing import added, methods_text
from missiontree.authoring.methods.method import Method, MethodLibrary, Step, built_in_methods, read_methods
from missiontree.authoring.offline import author_offline
from missiontree.authoring.outcome import Authored
from missiontree.errors import InputError
from missiontree.llm.scripted import ScriptedModel
from missiontree.mission.brief import MissionBrief
from missiontree.mission.entity import Entity
from missiontree.mission.fleet import Fleet
from missiontree.mission.position import Position
from missiontree.mission.routine import Routine, RoutineLibrary
from missiontree.mission.scene import Scene
from missiontree.mission.tree import Link, MissionNode, MissionTree
from missiontree.routines.library import built_in

MISSIONS = [
    # the paper's
    ("Reunite mom with her lost child", "Reunite dad with his lost daughter"),
    ("Rescue cat trapped in a building on fire", "Rescue dog trapped in a barn on fire"),
    ("Help the woman walking with heavy luggage", "Help the man walking with heavy boxes"),
    ("Save the city from the monster destroying it", "Save the village from the dragon destroying it"),
    # others
    ("Find the keys", "Find the wallet"),
    ("Follow the dog", "Follow the horse"),
    ("Go to the kitchen", "Go to the garage"),
    ("Bring the parcel to the lobby", "Bring the ladder to the garage"),
    ("Search for the missing hiker", "Search for the missing nurse"),
    ("Rescue the child from the barn", "Rescue the nurse from the hospital"),
    ("Rescue Tom from the fire", "Rescue Anna from the fire"),
    ("Evacuate the school", "Evacuate the hospital"),
    ("Evacuate the patients to the garden", "Evacuate the guests to the park"),
    ("Guide the visitor to the exit", "Guide the doctor to the kitchen"),
    ("Reunite the boy with his dog", "Reunite the girl with her horse"),
    ("Fetch the umbrella for Anna", "Fetch the ladder for Tom"),
    ("Carry the crate to the warehouse", "Carry the table to the garage"),
    ("Help the old man carry his bags to the station", "Help the young woman carry her books to the library"),
    ("Help the child to the exit", "Help the nurse to the garden"),
    ("Save the village from the flood", "Save the town from the flood"),
    ("Look for the red ball", "Look for the blue cup"),
    ("Please find the wallet quickly", "Please find the phone quickly"),
    ("Check where the nurse is", "Check where the doctor is"),
    ("Search the garden for the wallet", "Search the kitchen for the phone"),
    ("Follow the thief with the tele-robot", "Follow the child with the tele-robot"),
]


def brief(fleet: Fleet, text: str, **more: Any) -> MissionBrief:
    return MissionBrief(text=text, fleet=fleet, routines=built_in(), **more)


def learn(mission: MissionBrief, **more: str) -> tuple[MissionTree, Method]:
    tree = author_offline(mission).tree
    assert tree is not None
    return tree, method_from(tree, mission, built_in_methods(), **more)


def planned(mission: MissionBrief, method: Method) -> Authored:
    return author_offline(mission, MethodLibrary(methods=(method, *built_in_methods().methods)))


def same(one: MissionTree, made: Authored, method: Method, scene: Scene | None = None) -> bool:
    assert made.status == "complete", made.reasons
    assert made.tree is not None
    assert f"method {method.id}," in made.reading[0]
    assert difference(one, made.tree, scene or Scene()) == ""
    return True


@pytest.mark.parametrize(("words", "others"), MISSIONS)
def test_the_same_words_with_other_nouns_give_the_same_tree_about_others(fleet: Fleet, words: str, others: str) -> None:
    tree, method = learn(brief(fleet, words))
    assert same(tree, planned(brief(fleet, others), method), method)


@pytest.mark.parametrize(("words", "_"), MISSIONS)
def test_what_is_written_is_what_was_learned_and_names_nobody(fleet: Fleet, words: str, _: str) -> None:
    _tree, method = learn(brief(fleet, words))
    text = methods_text(method)
    assert read_methods(text, "learned.yaml").methods == (method,)
    named = {
        "mom",
        "child",
        "cat",
        "woman",
        "luggage",
        "city",
        "monster",
        "nurse",
        "anna",
        "wallet",
        "school",
        "village",
    }
    body = text.partition("says:")[2].lower().replace("'", " ").replace("}", " ").split()
    assert not named & set(body)


def test_a_method_is_written_as_a_person_would_write_it(fleet: Fleet) -> None:
    _, method = learn(brief(fleet, "Save the city from the monster destroying it"), method_id="save_them")
    # City is only in the name of the people whom nobody mentions, and is a slot all the same.
    assert methods_text(method) == (
        """format: methods/1
methods:
  - id: save_them
    purpose: Learned from 'Save the city from the monster destroying it'.
    says: ['save {place} from {animal}']
    where:
      place: [place]
      animal: [animal]
    implies:
      people_of_place: {name: 'People of {place}', kind: person}
      safe_area: {name: Safe Area, kind: place}
    steps:
    - {do: Search(responder)}
    - task: Keep {the animal} in Sight
      until: bring_people_of_place_to_safety
      steps:
      - {do: SearchAndFollow(animal)}
    - task: Bring {people_of_place} to Safety
      name: bring_people_of_place_to_safety
      steps:
      - {do: 'ReachAndTransport(people_of_place, safe_area)'}
"""
    )


def test_a_verb_of_one_sense_stands_for_all_like_it_and_another_for_itself(fleet: Fleet) -> None:
    tree, method = learn(brief(fleet, "Reunite the boy with his dog"))
    assert method.says == ("<reunite> {person} with {animal}",)
    assert same(tree, planned(brief(fleet, "Bring together the girl with her horse"), method), method)
    assert learn(brief(fleet, "Save the city from the monster"))[1].says == ("save {place} from {animal}",)


def test_who_is_called_for_a_hazard_is_called_for_another(fleet: Fleet) -> None:
    """Firefighter is not in the method: a flood calls somebody else, and a well nobody."""
    _, method = learn(brief(fleet, "Rescue Tom from the fire"))
    assert method.steps[0] == Step(do="Search(responder)")
    assert "firefighter" not in str(method).lower().partition("says")[2]
    made = planned(brief(fleet, "Rescue Anna from the flood"), method)
    assert made.tree is not None
    assert next(node.label for node in made.tree.nodes if node.routine) == "Search(Lifeguard)"


def test_a_search_is_spared_where_a_scene_knows_more(fleet: Fleet) -> None:
    _, method = learn(brief(fleet, "Rescue Tom from the barn"))
    scene = Scene(
        entities=(Entity(id="anna", kind="person", label="Anna", position=Position(1, 1)),),
        places=(Entity(id="barn", kind="place", label="Barn", position=Position(2, 2)),),
    )
    made = planned(brief(fleet, "Rescue Anna from the barn", scene=scene), method)
    assert made.tree is not None
    assert [node.routine for node in made.tree.nodes if node.routine] == ["ReachAndTransport"]
    # With nothing else to be done, the search is all there is and stays.
    assert not learn(brief(fleet, "Find Tom"))[1].steps[0].unless_known


def own(routine: str, verb: str, like: str) -> Routine:
    return replace(built_in().by_id[like], id=routine, verbs=(verb,))


OWN = RoutineLibrary(
    routines=(
        *built_in().routines,
        own("SwitchOn", "switch on", "Reach"),
        own("Load", "load", "Transport"),
        own("Push", "push", "Reach"),
        own("Weigh", "weigh", "Reach"),
    )
)


def calls(made: Authored) -> list[str]:
    assert made.tree is not None, made.reasons
    return [node.label for node in made.tree.nodes if node.routine is not None]


@pytest.mark.parametrize(
    ("words", "says", "opposite"),
    [
        ("Switch on the lamp", "switch on {object}", "Switch off the lamp"),
        ("Load the hay onto the truck", "load {object} onto {object_2}", "Unload the hay onto the truck"),
        ("Push the cart", "push {object}", "Pull the cart"),
    ],
)
def test_a_verb_that_only_a_routine_of_the_users_own_serves_stays_a_word(
    fleet: Fleet, words: str, says: str, opposite: str
) -> None:
    """The lexicon groups a verb with its opposite where nothing built in tells them apart."""
    mission = replace(brief(fleet, words), routines=OWN)
    _, method = learn(mission)
    assert method.says == (says,)
    assert planned(replace(mission, text=opposite), method).status != "complete"


@pytest.mark.parametrize("words", ["Weigh the lost calf", "The calf is lost. Weigh it."])
def test_whoever_is_called_lost_is_lost_in_the_method(fleet: Fleet, words: str) -> None:
    mission = replace(brief(fleet, words), routines=OWN)
    says = "" if words.startswith("Weigh") else "weigh {animal}"
    _, method = learn(mission, says=says)
    assert method.where == {"animal": ("lost",)}
    assert calls(planned(replace(mission, text="Weigh the lost cow"), method)) == ["Search(Cow)", "Weigh(Cow)"]
    assert calls(planned(replace(mission, text="Weigh the cow"), method)) == ["Weigh(Cow)"]


def test_a_lost_one_is_still_lost_in_words_made_for_a_pattern(fleet: Fleet) -> None:
    _, method = learn(
        brief(fleet, "Find the lost keys, then bring them to Anna"), says="make sure that {anna} has {keys}"
    )
    assert method.where["keys"] == ("lost",)
    assert calls(planned(brief(fleet, "Make sure that Tom has the lost wallet"), method))[0] == "Search(Wallet)"
    assert calls(planned(brief(fleet, "Make sure that Tom has the wallet"), method)) == [
        "ReachAndTransport(Wallet, Tom)"
    ]


def test_a_choice_stays_one_choice_if_a_slot_holds_several(fleet: Fleet) -> None:
    """Two ways, each with both things in it; not one of four errands."""
    _, method = learn(brief(fleet, "Bring the parcel to Anna or Bob"))
    made = planned(brief(fleet, "Bring the crate and the box to Anna or Bob"), method)
    assert made.tree is not None
    assert f"method {method.id}," in made.reading[0]
    choice = next(node for node in made.tree.nodes if node.gate == "xor")
    assert [len(made.tree.by_id[option].children) for option in choice.children] == [2, 2]
    assert {made.tree.by_id[option].gate for option in choice.children} == {"and"}


@pytest.mark.parametrize(
    ("words", "says", "others", "count"),
    [
        (
            "Bring the crate, the box and the bag to the depot",
            "<bring> {object} to {place}",
            "Bring the jar to the hall",
            1,
        ),
        ("Find the keys and the dog", "<search> {object}", "Find the ring, the cat and the cup", 3),
        ("Rescue Anna and Tom from the barn", "<rescue> {person} from {place}", "Rescue Bob from the mill", 2),
        ("Evacuate the school and the hotel", "<evacuate> {place}", "Evacuate the mill", 1),
        ("Bring both Anna and Tom to the hall", "<bring> {person} to {place}", "Bring Bob to the hall", 1),
    ],
)
def test_a_list_with_each_of_which_the_same_is_done_is_one_slot(
    fleet: Fleet, words: str, says: str, others: str, count: int
) -> None:
    _, method = learn(brief(fleet, words))
    assert method.says == (says,)
    made = planned(brief(fleet, others), method)
    assert f"method {method.id}," in made.reading[0]
    assert len(calls(made)) == count


def test_two_with_whom_different_things_are_done_stay_two_and_a_list_of_such_is_refused(fleet: Fleet) -> None:
    _, method = learn(brief(fleet, "Reunite mom and her child"))
    assert method.says == ("<reunite> {person} and {person_2}",)
    words = "Follow the cat, the dog and the hen"
    hen = Entity(id="hen", kind="animal", label="Hen")
    tree = tree_of(
        words, leaf("a", "Follow", agent="cat"), leaf("b", "Reach", agent="dog"), leaf("c", "Reach", agent="hen")
    )
    tree = replace(tree, entities=(*tree.entities, hen))
    with pytest.raises(InputError, match="'the cat, the dog and the hen' is a list"):
        method_from(tree, brief(fleet, words), built_in_methods())


@pytest.mark.parametrize(("parts", "alike"), [(["Reach"], True), (["Search", "Reach"], False)])
def test_tasks_that_do_the_same_with_each_of_a_list_are_one_task(fleet: Fleet, parts: list[str], alike: bool) -> None:
    """As one step they come again as one task; two tasks of two would be one of four, another structure, which is said."""
    words = "Check the cat and the dog"
    nodes = [MissionNode(id="all", label=words, gate="and", children=("see-cat", "see-dog"))]
    for who in ("cat", "dog"):
        below = [leaf(f"{part}-{who}", part, agent=who) for part in parts]
        ids = tuple(node.id for node in below)
        nodes += [MissionNode(id=f"see-{who}", label=f"See the {who.title()}", gate="and", children=ids), *below]
    tree = replace(tree_of(words), nodes=tuple(nodes))
    if alike:
        (step,) = method_from(tree, brief(fleet, words), built_in_methods()).steps
        assert (step.task, step.steps) == ("See {the animal}", (Step(do="Reach(animal)"),))
    else:
        with pytest.raises(InputError, match="does not give the tree again"):
            method_from(tree, brief(fleet, words), built_in_methods())


def test_what_is_numbered_is_refused_with_a_way_out(fleet: Fleet) -> None:
    with pytest.raises(InputError, match="'the three crates' names several at once") as caught:
        learn(brief(fleet, "Bring the three crates to the depot"))
    assert "its slot may then hold several" in str(caught.value)
    _, method = learn(brief(fleet, "Bring the crate to the depot"))
    made = planned(brief(fleet, "Bring the three boxes to the depot"), method)
    assert calls(made) == [f"ReachAndTransport(Box {number}, Depot)" for number in (1, 2, 3)]


def test_somebody_is_called_for_a_hazard_that_only_a_later_mission_names(fleet: Fleet) -> None:
    _, method = learn(brief(fleet, "Evacuate the school"))
    assert method.steps[0] == Step(do="Search(responder)")
    assert calls(planned(brief(fleet, "Evacuate the burning mill"), method))[0] == "Search(Firefighter)"
    assert len(calls(planned(brief(fleet, "Evacuate the mill"), method))) == 1
    assert learn(brief(fleet, "Bring the parcel to the hall"))[1].steps[0] != Step(do="Search(responder)")


def test_where_it_goes_is_a_word_if_the_tree_goes_elsewhere(fleet: Fleet) -> None:
    """The tree goes to a safe area, which is nobody's name for the barn."""
    _, method = learn(brief(fleet, "Bring Anna to safety"))
    assert method.says == ("<bring> {person} to safety",)
    made = planned(brief(fleet, "Bring Anna to the barn"), method)
    assert calls(made) == ["ReachAndTransport(Anna, Barn)"]


@pytest.mark.parametrize("words", ["Warn Anna", "Warn Anna with the social robot"])
def test_robots_that_a_method_chooses_by_what_they_can_do_are_chosen_so_again(fleet: Fleet, words: str) -> None:
    _, method = learn(brief(fleet, words))
    assert method.steps == (Step(do="Reach(person)", capability="message_display"),)
    made = planned(brief(fleet, "Warn Bob"), method)
    assert made.tree is not None
    assert made.tree.nodes[-1].resources == ("social_robot",)


def test_the_id_of_a_built_in_method_is_refused(fleet: Fleet) -> None:
    with pytest.raises(InputError, match="'rescue' is the id of a built-in method"):
        learn(brief(fleet, "Find the keys"), method_id="rescue")


GUARD = "Guard the museum against the thief"
CALLS: Sequence[tuple[str, dict[str, Any]]] = (
    ("HierarchicalTree_init", {"objective": GUARD}),
    ("introduceEntity", {"name": "Night Watchman", "kind": "person"}),
    (
        "addMultiSubtasks",
        {
            "parentString": GUARD,
            "isPrimitiveList": [False, False],
            "taskNameList": ["Watch the Thief", "Bring the Night Watchman to the Museum"],
            "LogicalConstraint": "AND",
            "constraintPairs": [[0, 1, "Until"]],
        },
    ),
    (
        "attachMultiSubTrees",
        {
            "parentString": "Watch the Thief",
            "treeNames": ["SearchAndFollowTree"],
            "treeArguments": [["thief", ["tele_robot"]]],
            "LogicalConstraint": "AND",
        },
    ),
    (
        "attachMultiSubTrees",
        {
            "parentString": "Bring the Night Watchman to the Museum",
            "treeNames": ["ReachAndTransportTree", "ReachTree"],
            "treeArguments": [["Night Watchman", "museum"], ["museum"]],
            "LogicalConstraint": "XOR",
        },
    ),
)


def test_a_tree_that_a_model_built_is_learned_with_its_choice_its_until_and_its_robots(fleet: Fleet) -> None:
    mission = brief(fleet, GUARD)
    made = author_tree(mission, ScriptedModel([list(CALLS)]))
    assert made.status == "complete", made.reasons
    assert made.tree is not None
    method = method_from(made.tree, mission, built_in_methods())
    watch, fetch = method.steps
    assert [option.task for option in fetch.steps] == [
        "Reach and transport {the night_watchman}, {the place}",
        "Reach {the place}",
    ]
    assert (watch.task, watch.until, watch.steps[0].by) == ("Watch {the person}", fetch.name, ("tele_robot",))
    assert (fetch.task, fetch.gate) == ("Bring {the night_watchman} to {the place}", "xor")
    again = planned(replace(mission, text="Guard the castle against the intruder"), method)
    assert same(made.tree, again, method)
    assert again.tree is not None
    assert [node.label for node in again.tree.nodes if node.routine is None][1:] == [
        "Watch the Intruder",
        "Bring Night Watchman to the Castle",
        "Reach and Transport Night Watchman, the Castle",
        "Reach the Castle",
    ]


def test_robots_that_the_words_name_are_no_part_of_the_method(fleet: Fleet) -> None:
    _, method = learn(brief(fleet, "Follow the thief with the tele-robot"))
    assert method.steps == (Step(do="Follow(person)"),)
    made = planned(brief(fleet, "Follow the child with the social robot"), method)
    assert made.tree is not None
    assert made.tree.nodes[-1].resources == ("social_robot",)


def test_a_choice_at_the_top_is_kept_below_a_task(fleet: Fleet) -> None:
    tree = MissionTree(
        objective="Alert the nurse",
        nodes=(
            MissionNode(id="alert", label="Alert the nurse", gate="xor", children=("reach", "follow")),
            MissionNode(id="reach", label="Reach(Nurse)", routine="Reach", arguments={"agent": "nurse"}),
            MissionNode(id="follow", label="Follow(Nurse)", routine="Follow", arguments={"agent": "nurse"}),
        ),
        entities=(Entity(id="nurse", kind="person", label="Nurse"),),
    )
    method = method_from(tree, brief(fleet, tree.objective), built_in_methods())
    (choice,) = method.steps
    assert (choice.task, choice.gate, len(choice.steps)) == ("Alert {the person}", "xor", 2)


def test_entities_of_a_scene_are_named_by_label_alias_and_kind(fleet: Fleet) -> None:
    scene = Scene(
        entities=(
            Entity(id="rex", kind="dog", label="Rex", position=Position(1, 1)),
            Entity(id="anna", kind="person", label="Anna", aliases=("the boss",), position=Position(2, 2)),
        ),
        kinds={"dog": "animal"},
    )
    mission = brief(fleet, "Bring the dog to the boss", scene=scene)
    tree, method = learn(mission)
    assert method.says == ("<bring> {animal} to {person}",)
    assert same(tree, planned(mission, method), method, scene)


def test_a_pattern_by_hand_names_its_slots_after_the_entities(fleet: Fleet) -> None:
    mission = brief(fleet, "Find the keys, then bring them to Anna")
    tree, method = learn(mission, says="make sure that {anna} has {keys}", method_id="hand_over")
    assert method.where == {"anna": ("person",), "keys": ("object",)}
    made = planned(brief(fleet, "Make sure that Tom has the wallet"), method)
    assert same(tree, made, method)


@pytest.mark.parametrize(
    ("words", "says", "message"),
    [
        (
            "Find the keys, then bring them to Anna",
            "",
            "the mission has 2 parts ('Find the keys'; 'bring them to Anna')",
        ),
        ("Find the keys. Follow the dog.", "", "the mission has 2 parts"),
        ("Bring Anna the keys", "", "nothing stands between Anna and Keys"),
        ("Find the keys", "get {thing}", "has a slot {thing} that stands for nobody"),
        ("Find the keys", "get it", "has no slot"),
        ("Find the keys", "{keys} be found", "does not begin with a verb"),
        ("Find the keys", "get {keys} {keys}", "a slot twice"),
        ("Bring the keys to Anna", "give {anna} {keys}", "two slots with no word between them"),
        ("Bring the keys to Anna", "give {anna} [her {keys}]", "is no slot of all its patterns"),
        ("Find the keys", "get {keys", "is not closed"),
    ],
)
def test_what_cannot_be_a_pattern_is_refused_with_the_way_out(
    fleet: Fleet, words: str, says: str, message: str
) -> None:
    with pytest.raises(InputError) as caught:
        learn(brief(fleet, words), says=says)
    assert message in str(caught.value)
    assert caught.value.hint or caught.value.accepted


def leaf(name: str, routine: str, **arguments: str) -> MissionNode:
    return MissionNode(id=name, label=f"{routine}({name})", routine=routine, arguments=arguments)


def tree_of(words: str, *nodes: MissionNode, links: tuple[Link, ...] = ()) -> MissionTree:
    root = MissionNode(id="all", label=words, gate="and" if nodes else None, children=tuple(node.id for node in nodes))
    cat = Entity(id="cat", kind="animal", label="Cat")
    dog = Entity(id="dog", kind="animal", label="Dog")
    return MissionTree(objective=words, nodes=(root, *nodes), links=links, entities=(cat, dog))


@pytest.mark.parametrize(
    ("tree", "message"),
    [
        (tree_of("Find the cat"), "the tree has no routine"),
        (tree_of("Find the cat", leaf("a", "Juggle", agent="cat")), "the tree is not finished"),
        (
            tree_of("Find the hamster", leaf("a", "Search", agent="cat")),
            "names nobody and nothing that the tree is about (Cat)",
        ),
        (
            tree_of(
                "Follow the cat",
                leaf("a", "Follow", agent="cat"),
                leaf("b", "Reach", agent="dog"),
                links=(Link("a", "b", "same_robot"),),
            ),
            "a same-robot link",
        ),
        (
            tree_of(
                "Follow the cat",
                leaf("a", "Follow", agent="cat"),
                leaf("b", "Reach", agent="dog"),
                leaf("c", "Search", agent="dog"),
                links=(Link("a", "b", "until"), Link("a", "c", "until")),
            ),
            "lasts until two others end",
        ),
        (
            # Whoever is lost is searched for by the offline author, so the tree without a search does not come again.
            tree_of("Follow the lost cat", leaf("a", "Follow", agent="cat")),
            "does not give the tree again",
        ),
    ],
)
def test_a_tree_of_which_no_method_can_be_made_is_refused(fleet: Fleet, tree: MissionTree, message: str) -> None:
    with pytest.raises(InputError) as caught:
        method_from(tree, brief(fleet, tree.objective), built_in_methods())
    assert message in str(caught.value)


def test_one_name_for_several_of_a_scene_is_refused(fleet: Fleet) -> None:
    crates = tuple(
        Entity(id=f"crate_{number}", kind="object", label=f"Crate {number}", position=Position(number, 0))
        for number in (1, 2)
    )
    mission = brief(fleet, "Find the crates", scene=Scene(entities=crates))
    with pytest.raises(InputError, match="'the crates' names several at once"):
        learn(mission)


def test_a_method_is_added_behind_those_of_a_file_and_the_rest_stays(fleet: Fleet) -> None:
    _, one = learn(brief(fleet, "Find the keys"), method_id="one")
    _, two = learn(brief(fleet, "Follow the dog"), method_id="two")
    text = "# Mine.\n" + methods_text(one)
    both = added(text, two, "m.yaml")
    assert both.startswith(text)
    assert "  - id: two\n" in both
    flush = "format: methods/1\nmethods:\n- {id: x, purpose: p, says: ['go to {a}'], steps: [{do: Reach(a)}]}\n"
    assert added(flush, two, "m.yaml").startswith(f"{flush}- id: two\n")
    assert added(added("", one, "m.json"), two, "m.json").count('"id"') == 2
    with pytest.raises(InputError, match="is in the file already"):
        added(both, two, "m.yaml")
    with pytest.raises(InputError, match="nothing can be added behind"):
        added("{methods: [{id: x, purpose: p, says: ['go to {a}'], steps: [{do: Reach(a)}]}]}", two, "m.yaml")
    with pytest.raises(InputError, match="looks like a mission file"):
        added("mission: Find the keys", two, "m.yaml")
