"""
Missions and the trees expected of them, written by hand from what the words mean.

``a; b`` are siblings in order, ``Task[a; b]`` is a task, ``a < b`` says that a ends before b starts, ``a ~ b`` that a lasts until b ends.
"""

from __future__ import annotations

import re
from dataclasses import replace
from pathlib import Path

import pytest

from missiontree.authoring.methods.method import built_in_methods, load_methods
from missiontree.authoring.offline import author_offline
from missiontree.authoring.transcript import replay
from missiontree.formats.document import read_file
from missiontree.mission.brief import MissionBrief
from missiontree.mission.fleet import Fleet
from missiontree.mission.tree import MissionTree
from missiontree.routines.library import built_in
from missiontree.samples.catalogue import FOLDER

PAPER = {
    "Reunite mom with her lost child": "Locate the Lost Child[Search(Child)]; Reunite the Child with Mom[ReachAndTransport(Child, Mom)]"
    " | Locate the Lost Child < Reunite the Child with Mom",
    "Rescue cat trapped in a building on fire": "Search(Firefighter); Search(Cat); ReachAndTransport(Cat, Safe Area)"
    " | Search(Cat) < ReachAndTransport(Cat, Safe Area)",
    "Help the woman walking with heavy luggage": "Reach the Woman[Reach(Woman)];"
    " Carry Luggage for the Woman[ReachAndTransport(Luggage, Destination of Woman)] | Reach the Woman < Carry Luggage for the Woman",
    "Save the city from the monster destroying it": "Keep the Monster in Sight[SearchAndFollow(Monster)];"
    " Bring People of City to Safety[ReachAndTransport(People of City, Safe Area)]"
    " | Keep the Monster in Sight ~ Bring People of City to Safety",
}

REUNITE_BOY = (
    "Locate the Boy[Search(Boy)]; Reunite the Boy with the Father[ReachAndTransport(Boy, Father)]"
    " | Locate the Boy < Reunite the Boy with the Father"
)
PARAPHRASED = {
    "Reunite the boy with his father": REUNITE_BOY,
    "reunite the boy with his father.": REUNITE_BOY,
    "Please reunite the boy and his father!": REUNITE_BOY,
    "Reunite grandma and her missing purse": "Locate the Missing Purse[Search(Purse)];"
    " Reunite the Purse with Grandma[ReachAndTransport(Purse, Grandma)] | Locate the Missing Purse < Reunite the Purse with Grandma",
    "Reunite the lost puppy with the girl": "Locate the Lost Puppy[Search(Puppy)];"
    " Reunite the Puppy with the Girl[ReachAndTransport(Puppy, Girl)] | Locate the Lost Puppy < Reunite the Puppy with the Girl",
    "Find the lost dog and bring it back to its owner": "Search(Dog); ReachAndTransport(Dog, Owner)"
    " | Search(Dog) < ReachAndTransport(Dog, Owner)",
    "Rescue the worker trapped in a flooded mine": "Search(Lifeguard); Search(Worker); ReachAndTransport(Worker, Safe Area)"
    " | Search(Worker) < ReachAndTransport(Worker, Safe Area)",
    "Rescue the hiker stuck on a cliff": "Search(Mountain Rescuer); Search(Hiker); ReachAndTransport(Hiker, Safe Area)"
    " | Search(Hiker) < ReachAndTransport(Hiker, Safe Area)",
    "Save the old man from the burning house": "Search(Firefighter); Search(Man); ReachAndTransport(Man, Safe Area)"
    " | Search(Man) < ReachAndTransport(Man, Safe Area)",
    "Free the horse stuck in the barn": "Search(Horse); ReachAndTransport(Horse, Safe Area)"
    " | Search(Horse) < ReachAndTransport(Horse, Safe Area)",
    "Rescue the miner from the gas leak": "Search(Gas Engineer); Search(Miner); ReachAndTransport(Miner, Safe Area)"
    " | Search(Miner) < ReachAndTransport(Miner, Safe Area)",
    "Help the man carrying a heavy box": "Reach the Man[Reach(Man)]; Carry the Box for the Man[ReachAndTransport(Box, Destination of Man)]"
    " | Reach the Man < Carry the Box for the Man",
    "Assist the visitor with her suitcases": "Reach the Visitor[Reach(Visitor)];"
    " Carry the Suitcases for the Visitor[ReachAndTransport(Suitcases, Destination of Visitor)]"
    " | Reach the Visitor < Carry the Suitcases for the Visitor",
    "Help grandma carry her bags to the kitchen": "Reach Grandma[Reach(Grandma)];"
    " Carry the Bags for Grandma[ReachAndTransport(Bags, Kitchen)]"
    " | Reach Grandma < Carry the Bags for Grandma",
    "Protect the village from the wolf": "Keep the Wolf in Sight[SearchAndFollow(Wolf)];"
    " Bring People of Village to Safety[ReachAndTransport(People of Village, Safe Area)]"
    " | Keep the Wolf in Sight ~ Bring People of Village to Safety",
    "Save the town from the flood": "Search(Lifeguard); Bring People of Town to Safety[ReachAndTransport(People of Town, Safe Area)]",
    "Evacuate the patients to the assembly point": "ReachAndTransport(Patients, Assembly Point)",
    "Evacuate all the patients": "ReachAndTransport(Patients, Safe Area)",
    "Evacuate the school": "ReachAndTransport(People of School, Safe Area)",
}

PLAIN = {
    "Follow the suspect": "Follow(Suspect)",
    "follow the suspect": "Follow(Suspect)",
    "Track down the thief": "Search(Thief)",
    "Find and follow the suspect": "SearchAndFollow(Suspect)",
    "Find the red ball": "Search(Red Ball)",
    "Look for Anna's keys": "Search(Anna's Keys)",
    "Search the warehouse for the forklift": "Search(Forklift)",
    "Go to the lobby": "Reach(Lobby)",
    "Visit grandma": "Reach(Grandma)",
    "Guide the visitor to room 12": "Transport(Visitor, Room 12)",
    "Carry the crate to the loading dock": "Transport(Crate, Loading Dock)",
    "Deliver the parcel to the lobby": "ReachAndTransport(Parcel, Lobby)",
    "Take the medicine from the pharmacy to the ward": "ReachAndTransport(Medicine, Ward)",
    "Could you bring the blanket to the patient, please?": "ReachAndTransport(Blanket, Patient)",
    "The robots should find the forklift": "Search(Forklift)",
    "I want you to quickly find the forklift": "Search(Forklift)",
    "Bring the lost dog to its owner": "Search(Dog); ReachAndTransport(Dog, Owner)"
    " | Search(Dog) < ReachAndTransport(Dog, Owner)",
}

JOINED = {
    "Locate the keys then bring them to Anna": "Search(Keys); ReachAndTransport(Keys, Anna) | Search(Keys) < ReachAndTransport(Keys, Anna)",
    "Search for the forklift, then go to it": "Search(Forklift); Reach(Forklift) | Search(Forklift) < Reach(Forklift)",
    "Find the dog and the cat": "Search(Dog); Search(Cat)",
    "Find the dog, the cat and the parrot": "Search(Dog); Search(Cat); Search(Parrot)",
    "Find the suspect and guide the visitor to the lobby": "Search(Suspect); Transport(Visitor, Lobby)",
    "Find the nurse. Then find the doctor.": "Search(Nurse); Search(Doctor) | Search(Nurse) < Search(Doctor)",
    "The robots must find the boy, then they must bring him to the school": "Search(Boy); ReachAndTransport(Boy, School)"
    " | Search(Boy) < ReachAndTransport(Boy, School)",
    "Pick up the parcel and deliver it to Anna": "ReachAndTransport(Parcel, Anna)",
    "Find the nurse, then get the medicine from the pharmacy and take it to her": "Search(Nurse); ReachAndTransport(Medicine, Nurse)"
    " | Search(Nurse) < ReachAndTransport(Medicine, Nurse)",
    "Before following the thief, pick up the parcel and deliver it to Anna": "Follow(Thief); ReachAndTransport(Parcel, Anna)"
    " | ReachAndTransport(Parcel, Anna) < Follow(Thief)",
    "Collect the keys, bring them to the lobby, then follow the thief": "ReachAndTransport(Keys, Lobby); Follow(Thief)"
    " | ReachAndTransport(Keys, Lobby) < Follow(Thief)",
    "Find the nurse. Find the doctor.": "Search(Nurse); Search(Doctor)",
    "Find the nurse before going to the lobby": "Search(Nurse); Reach(Lobby) | Search(Nurse) < Reach(Lobby)",
    "Before going to the lobby, find the nurse": "Reach(Lobby); Search(Nurse) | Search(Nurse) < Reach(Lobby)",
    "Go to the lobby after finding the nurse": "Reach(Lobby); Search(Nurse) | Search(Nurse) < Reach(Lobby)",
    "Once the nurse is found, go to the lobby": "Search(Nurse); Reach(Lobby) | Search(Nurse) < Reach(Lobby)",
    "First find the nurse, then go to the lobby, and finally follow the thief": "Search(Nurse); Reach(Lobby); Follow(Thief)"
    " | Search(Nurse) < Reach(Lobby), Reach(Lobby) < Follow(Thief)",
    "Keep an eye on the toddler while you bring the toy to the kitchen": "Follow(Toddler); ReachAndTransport(Toy, Kitchen)"
    " | Follow(Toddler) ~ ReachAndTransport(Toy, Kitchen)",
    "While following the thief, find the police officer": "Follow(Thief); Search(Police Officer) | Follow(Thief) ~ Search(Police Officer)",
    "Follow the thief until you find the police officer": "Follow(Thief); Search(Police Officer) | Follow(Thief) ~ Search(Police Officer)",
    "Go to the lobby, then find and visit the nurse": "Reach(Lobby); Search(Nurse); Reach(Nurse)"
    " | Reach(Lobby) < Search(Nurse), Search(Nurse) < Reach(Nurse)",
    "Go to the lobby and bring the parcel there": "Reach(Lobby); ReachAndTransport(Parcel, Lobby)",
    "Find the child and reunite her with Anna": "Search(Child); Reunite the Child with Anna[ReachAndTransport(Child, Anna)]"
    " | Search(Child) < Reunite the Child with Anna",
    "Find the dog and the cat and bring them to the kitchen": "Find the Dog and the Cat[Search(Dog); Search(Cat)];"
    " Bring Them to the Kitchen[ReachAndTransport(Dog, Kitchen); ReachAndTransport(Cat, Kitchen)]"
    " | Search(Dog) < ReachAndTransport(Dog, Kitchen), Search(Cat) < ReachAndTransport(Cat, Kitchen)",
}

IMPOSSIBLE = {
    "Recommend best Italian restaurants in the area": "recommend",
    "Suggest a good book": "recommend",
    "Repair the broken pump": "repair",
    "Cook dinner for the guests": "cook",
    "Paint the fence": "paint",
    "Weld the pipe": "weld",
    "Clean the kitchen": "clean",
    "Find the pump and then repair it": "repair",
    "Water the plants": "water",
    "Take a picture of the bridge": "photograph",
    "Put out the fire": "extinguish",
    "Tell Anna that dinner is ready": "tell",
}

NOT_UNDERSTOOD = [
    "",
    "   \n ",
    "the cat",
    "Cat",
    "asdf qwer zxcv",
    "Finde die Katze und bring sie zu Anna",
    "找到那只猫",
    "🚒🔥",
    "Do not find the cat",
    "Don't follow the suspect",
    "Never recommend restaurants",
    "Find the cat unless the dog is there",
    "If the alarm rings, evacuate the school",
    "Find everyone except the guard",
    "Bring the parcel to the lobby at noon",
    "Find the dog tomorrow",
    "Follow the suspect for 10 minutes",
    "Bring it to Anna",
    "Deliver the parcel",
    "Deliver the parcel to Anna and Bob",
    "Guide the visitor to room 12 without using the lift",
    "Find",
    "Find the quickly",
    "Find the dog's",
    "Pick up the parcel",
    "Find the dog, but do not wake the baby",
    "When the visitor arrives, guide her to the lobby",
    "Carry the box upstairs",
    "Follow me",
    "Colourless green ideas sleep furiously",
    "What is the weather like?",
    "Find the dog bring the cat",
    "Find the man wearing a red hat and bring the man with the dog to Anna",
    "Bring the boy to his father and follow him",
]

COMPLETE = PAPER | PARAPHRASED | PLAIN | JOINED


@pytest.fixture(scope="module")
def fleet() -> Fleet:
    read: Fleet = read_file(FOLDER / "fleet.yaml", "fleet")
    return read


def brief(text: str, fleet: Fleet) -> MissionBrief:
    return MissionBrief(text=text, fleet=fleet, routines=built_in())


def shown(tree: MissionTree) -> str:
    """The tree in the notation above."""

    def of(node_id: str) -> str:
        node = tree.by_id[node_id]
        return node.label if node.routine else f"{node.label}[{'; '.join(map(of, node.children))}]"

    signs = {"precedence": "<", "until": "~"}
    links = [f"{tree.by_id[a.first].label} {signs[a.kind]} {tree.by_id[a.second].label}" for a in tree.links]
    return "; ".join(map(of, tree.root.children)) + (f" | {', '.join(links)}" if links else "")


@pytest.mark.parametrize(("text", "expected"), COMPLETE.items(), ids=list(COMPLETE))
def test_understood_mission_gives_the_expected_tree(text: str, expected: str, fleet: Fleet) -> None:
    made = author_offline(brief(text, fleet), built_in_methods())
    assert made.status == "complete", (made.reasons, made.reading)
    assert made.tree is not None
    assert made.tree.root.gate == "and"
    assert shown(made.tree) == expected
    assert made.reading


@pytest.mark.parametrize(("text", "capability"), IMPOSSIBLE.items(), ids=list(IMPOSSIBLE))
def test_goal_that_no_routine_serves_cannot_be_done_and_names_the_capability(
    text: str, capability: str, fleet: Fleet
) -> None:
    made = author_offline(brief(text, fleet), built_in_methods())
    assert made.status == "cannot_be_done", (made.reasons, made.reading)
    assert capability in {reason.needed for reason in made.reasons}


@pytest.mark.parametrize("text", NOT_UNDERSTOOD)
def test_what_is_not_understood_is_incomplete_and_says_what_to_do(text: str, fleet: Fleet) -> None:
    made = author_offline(brief(text, fleet), built_in_methods())
    assert made.status == "incomplete", made.reading
    assert made.reasons
    assert all(reason.message and reason.hint for reason in made.reasons)


@pytest.mark.parametrize("text", [*PAPER, *PARAPHRASED, *IMPOSSIBLE, *NOT_UNDERSTOOD[:6]])
def test_transcript_is_marked_offline_and_replays_to_the_same_tree(text: str, fleet: Fleet) -> None:
    stated = brief(text, fleet)
    made = author_offline(stated, built_in_methods())
    assert '"offline"' in made.transcript[0]
    again = replay(made.transcript, stated)
    assert replace(again, author="offline") == made


def test_sixty_missions_and_more_are_expected_by_hand() -> None:
    assert len(COMPLETE) + len(IMPOSSIBLE) + len(NOT_UNDERSTOOD) >= 100


# "area" is not among them: a safe area is what the method itself implies.
NOUNS_OF_SAMPLES = frozenset(
    re.findall(
        "[a-z]+",
        """
    mom mum mother child children cat building fire woman luggage city monster restaurant restaurants italian firefighter heavy
    dog boy father owner worker mine keys suspect forklift visitor parcel lobby patient toddler
    """,
    )
)


def test_no_method_file_names_a_noun_of_a_mission() -> None:
    """A method that knows the cat would be an answer learnt by heart."""
    import missiontree.authoring.methods.method as module

    folder = Path(module.__file__).with_name("library")
    files = sorted(folder.glob("*.yaml"))
    assert len(files) >= 3
    for file in files:
        words = set(re.findall("[a-z]+", file.read_text(encoding="utf-8").lower()))
        assert not words & NOUNS_OF_SAMPLES, file.name


def test_every_method_file_of_the_folder_is_loaded() -> None:
    assert load_methods() == built_in_methods()
    assert {method.id for method in built_in_methods().methods} >= {
        "rescue",
        "reunite",
        "help_with",
        "save_from_threat",
    }
