"""
Worlds whose names are known for certain: what may be called what, written down beside the missions and not asked of the product.

They hold traps: labels that differ by a number or a letter, ids that are words, kinds of the scene's own, letters beyond ASCII.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cache
from pathlib import Path

from benchmarks.campaign_dialogues import Call, begin, tasks, trees
from missiontree.briefing import request_from
from missiontree.mission.brief import MissionBrief
from missiontree.mission.entity import Entity
from missiontree.mission.fleet import Fleet, RobotType
from missiontree.mission.scene import Scene
from missiontree.samples.catalogue import FOLDER

SPARE = "Spare task"


@dataclass(frozen=True, slots=True)
class World:
    """
    A mission under construction, and its names.

    Parameters
    ----------
    name
        What it is called.
    brief
        The mission.
    calls
        Calls that build a tree to speak of; the task ``Spare task`` is left open.
    base_kinds
        Base kind of each entity by id, as a person would say.
    takes
        Base kinds that each routine takes as each of its arguments, in order.
    """

    name: str
    brief: MissionBrief
    calls: tuple[Call, ...]
    base_kinds: Mapping[str, str]
    takes: Mapping[str, tuple[frozenset[str], ...]]

    @property
    def scenic(self) -> bool:
        """Whether a scene says who is there."""
        return self.brief.scene is not None


_ALL = frozenset({"person", "animal", "object", "place"})
_NO_PLACE = _ALL - {"place"}
PAPER = {
    "Search": (_ALL,),
    "Follow": (_NO_PLACE,),
    "Reach": (_ALL,),
    "SearchAndFollow": (_NO_PLACE,),
    "Transport": (_NO_PLACE, _ALL),
    "ReachAndTransport": (_NO_PLACE, _ALL),
}


@cache
def worlds() -> tuple[World, ...]:
    """All of them."""
    return _words_alone(), _ward(), _site(), _harbour()


def _words_alone() -> World:
    """The paper's fleet and no scene: who is there, the mission says."""
    text = "Find the lost child and the firefighter's kid, then bring the suitcase to mom at the station"
    brief = replace(request_from(FOLDER / "reunite.yaml").brief, text=text)
    rooms = ["Search room 1", "Search room 2", "Search room 12", "Inspect the roof", "Inspect the roofs", SPARE]
    calls = (begin(text), tasks(text, rooms), trees("Search room 1", [("SearchTree", ["child"])]))
    said = {"child": "person", "kid": "person", "firefighter": "person", "suitcase": "object", "mom": "person"}
    return World("words alone", brief, calls, said | {"station": "place"}, PAPER)


def _ward() -> World:
    """A hospital: couriers with names of people's own, labels beyond ASCII, two of everything."""
    fleet = Fleet(
        (
            RobotType(id="courier", label="Kurier-Karl", capabilities={"reach": 1.0, "carry": 1.0}, count=3),
            RobotType(id="courier_2", label="Kurier-Klaus", capabilities={"reach": 0.9, "carry": 0.5}, count=1),
            RobotType(id="nurse_bot", label="Pflegehilfe Ä", capabilities={"reach": 0.5, "search": 1.0, "follow": 1.0}, count=2),
        )
    )  # fmt: skip
    scene = Scene(
        kinds={"patient": "person", "specimen": "object", "room": "place", "isolation_room": "room"},
        places=(
            Entity(id="room_1", kind="room", label="Room 1"),
            Entity(id="room_11", kind="isolation_room", label="Room 11"),
            Entity(id="lab", label="Labor für Blut"),
        ),
        entities=(
            Entity(id="mueller", kind="patient", label="Frau Müller", aliases=("the patient in bed 3",)),
            Entity(id="miller", kind="patient", label="Frau Miller"),
            Entity(id="s1", kind="specimen", label="specimen A"),
            Entity(id="s2", kind="specimen", label="specimen B"),
            Entity(id="bello", kind="animal", label="Bello"),
        ),
    )
    text = "Bring specimen A to the lab and find Frau Müller"
    brief = MissionBrief(
        text=text, fleet=fleet, scene=scene, routines=request_from(FOLDER / "reunite.yaml").brief.routines
    )
    calls = (
        begin(text),
        tasks(text, ["Fetch specimen A", "Fetch specimen B", "Visit patients", "Visit patient", SPARE]),
        trees("Visit patients", [("SearchTree", ["Frau Müller"]), ("SearchTree", ["Frau Miller"])]),
    )
    kinds = {"room_1": "place", "room_11": "place", "lab": "place", "mueller": "person", "miller": "person"}
    return World("ward", brief, calls, kinds | {"s1": "object", "s2": "object", "bello": "animal"}, PAPER)  # fmt: skip


def _site() -> World:
    """The sample project: roads, a routine of the user's own."""
    project = Path(FOLDER) / "project"
    brief = request_from(
        "Inspect the tower crane, bring the toolbox to the office, and find the visitor",
        fleet=project / "fleet.yaml",
        scene=project / "scene.yaml",
        routines=[project / "routines" / "inspect.yaml"],
    ).brief
    calls = (
        begin(brief.text),
        tasks(brief.text, ["Inspect cranes", "Inspect crates", "Deliver the toolbox", SPARE], [[0, 1]]),
        trees("Inspect cranes", [("InspectTree", ["tower_crane"])]),
    )
    kinds = dict.fromkeys(("gate", "office", "shed", "workshop"), "place")
    kinds |= dict.fromkeys(("red_crate", "toolbox", "tower_crane"), "object") | {"visitor": "person"}
    return World("site", brief, calls, kinds, PAPER | {"Inspect": (frozenset({"object", "place"}),)})


def _harbour() -> World:
    """Short names, numbers, and ids that are labels of others."""
    fleet = Fleet(
        tuple(
            RobotType(id=name, label=label, capabilities={"reach": 1.0, "search": 1.0, "carry": 1.0}, count=1)
            for name, label in (("uav1", "Kestrel"), ("uav2", "Kite"), ("agv", "Kiki"), ("usv", "Finn"))
        )
    )
    scene = Scene(
        places=(Entity(id="quay", label="Quay 4"), Entity(id="quay_4", label="Quay 14")),
        entities=(
            Entity(id="box", label="Box K"),
            Entity(id="box_k", label="crate"),
            Entity(id="diver", kind="person", label="Kai"),
            Entity(id="seal", kind="animal", aliases=("the seals' pup",)),
        ),
    )
    text = "Find Kai, take Box K from Quay 4 to Quay 14"
    routines = request_from(FOLDER / "reunite.yaml").brief.routines
    brief = MissionBrief(text=text, fleet=fleet, scene=scene, routines=routines)
    calls = (
        begin(text),
        tasks(text, ["Task A", "Task B", "Find Kai", "Shift the box", "Shift the boxes", SPARE]),
        trees("Find Kai", [("SearchTree", ["Kai"])]),
    )
    kinds = {
        "quay": "place",
        "quay_4": "place",
        "box": "object",
        "box_k": "object",
        "diver": "person",
        "seal": "animal",
    }
    takes = {name: PAPER[name] for name in ("Search", "Reach", "Transport", "ReachAndTransport")}
    return World("harbour", brief, calls, kinds, takes)
