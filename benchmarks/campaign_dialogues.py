"""
Sound dialogues, written as scripted turns: the paper's five missions, three with a scene, and one that is not clear.

Between them they call every function. They are what the campaigns damage. Nothing here comes from a model.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cache
from pathlib import Path
from typing import Any

from missiontree.briefing import request_from
from missiontree.mission.brief import MissionBrief
from missiontree.mission.entity import Entity
from missiontree.mission.position import Position
from missiontree.mission.scene import Scene
from missiontree.samples.catalogue import FOLDER

Arguments = Mapping[str, Any]
Call = tuple[str, Arguments]


@dataclass(frozen=True, slots=True)
class Dialogue:
    """
    A dialogue that ends well.

    Parameters
    ----------
    name
        What it is called.
    brief
        The mission.
    calls
        The model's calls, in order.
    """

    name: str
    brief: MissionBrief
    calls: tuple[Call, ...]


def begin(objective: str) -> Call:
    """The first call."""
    return "HierarchicalTree_init", {"objective": objective}


def task(parent: str, name: str, gate: str = "AND") -> Call:
    """One task."""
    return "CreateAndAddSubtask", {
        "parentString": parent,
        "isPrimitive": False,
        "taskName": name,
        "LogicalConstraint": gate,
    }


def tasks(parent: str, names: Sequence[str], pairs: Sequence[Any] = (), gate: str = "AND") -> Call:
    """Several tasks with links among them."""
    return "addMultiSubtasks", {
        "parentString": parent,
        "isPrimitiveList": [False] * len(names),
        "taskNameList": list(names),
        "LogicalConstraint": gate,
        "constraintPairs": list(pairs),
    }


def trees(parent: str, calls: Sequence[tuple[str, Any]], pairs: Sequence[Any] = (), gate: str = "AND") -> Call:
    """Routines, each with its arguments."""
    return "attachMultiSubTrees", {
        "parentString": parent,
        "treeNames": [name for name, _ in calls],
        "treeArguments": [given for _, given in calls],
        "LogicalConstraint": gate,
        "constraintPairs": list(pairs),
    }


@cache
def dialogues() -> tuple[Dialogue, ...]:
    """All of them."""
    return (*_of_the_paper(), _in_the_yard(), _in_many_scripts(), _on_the_building_site(), _not_clear())


def _sample(name: str) -> MissionBrief:
    return request_from(FOLDER / f"{name}.yaml").brief


def _of_the_paper() -> tuple[Dialogue, ...]:
    reunite, rescue, luggage, monster, food = (
        _sample(name) for name in ("reunite", "rescue", "luggage", "monster", "restaurants")
    )
    return (
        Dialogue(
            "reunite",
            reunite,
            (
                begin(reunite.text),
                task(reunite.text, "Locate the Lost Child"),
                tasks(
                    reunite.text,
                    ["Reunite the Child with Mom"],
                    [["Locate the Lost Child", "Reunite the Child with Mom"]],
                ),
                trees("Locate the Lost Child", [("SearchTree", ["Child"])]),
                trees("Reunite the Child with Mom", [("ReachAndTransportTree", ["Child", "Mom"])]),
                ("printTree", {}),
            ),
        ),
        Dialogue(
            "rescue",
            rescue,
            (
                begin(rescue.text),
                ("introduceEntity", {"name": "firefighter", "kind": "person"}),
                ("introduceEntity", {"name": "safe area", "kind": "place"}),
                trees(
                    rescue.text,
                    [
                        ("SearchTree", ["firefighter"]),
                        ("SearchTree", ["cat"]),
                        ("ReachAndTransportTree", {"agent": "cat", "location": "safe area"}),
                    ],
                    [["SearchTree(cat)", 2]],
                ),
                ("checkTree", {}),
            ),
        ),
        Dialogue(
            "luggage",
            luggage,
            (
                ("listRoutines", {}),
                begin(luggage.text),
                ("introduceEntity", {"name": "destination", "kind": "place"}),
                tasks(luggage.text, ["Find the woman", "Carry her luggage"], [[0, 1, "Precedence"]]),
                trees("Find the woman", [("SearchAndFollowTree", ["woman", ["tele_robot", "Transportation Robot"]])]),
                trees("Carry her luggage", [("TransportTree", ["luggage", "destination"])]),
            ),
        ),
        Dialogue(
            "monster",
            monster,
            (
                begin(monster.text),
                trees(
                    monster.text,
                    [("SearchTree", ["monster"]), ("FollowTree", ["monster"]), ("ReachTree", ["city"])],
                    [[0, 1], [0, 2], [0, 1, "SameRobot"], [1, 2, "DifferentRobot"], [1, 2, "Until"]],
                ),
                ("plotTree", {}),
            ),
        ),
        Dialogue(
            "restaurants",
            food,
            (
                ("listRoutines", {}),
                (
                    "declareImpossible",
                    {"missing": "recommending", "reason": "No robot can recommend restaurants, best or other."},
                ),
            ),
        ),
    )


def _in_the_yard() -> Dialogue:
    """Every function that mends a tree, in a scene with kinds of its own."""
    text = "Fetch the red crate, and see that the dog is not in the way"
    places = (
        Entity(id="gate", label="North Gate", position=Position(0, 0)),
        Entity(id="dock", label="Dock 7", position=Position(30, 0)),
    )
    entities = (
        Entity(id="crate_1", kind="crate", label="red crate", position=Position(10, 5), mass_kg=12),
        Entity(id="crate_2", kind="crate", label="blue crate", position=Position(12, 5)),
        Entity(id="rex", kind="dog", aliases=("the dog",), last_seen=Position(20, 20)),
    )
    scene = Scene(places=places, entities=entities, kinds={"crate": "object", "dog": "animal"})
    return Dialogue(
        "yard",
        replace(_sample("reunite"), text=text, scene=scene),
        (
            begin(text),
            tasks(text, ["Watch the dog", "Fetch the crate", "Tidy up"], [["Tidy up", "Fetch the crate"]]),
            ("dropLink", {"first": "tidy-up", "second": "fetch-the-crate", "kind": "Precedence"}),
            ("removeSubtask", {"subtask": "Tidy up"}),
            trees("watch-the-dog", [("SearchTree", ["the dog"]), ("FollowTree", ["rex"])], [[0, 1]]),
            trees("Fetch the crate", [("ReachAndTransportTree", ["red crate", "dock"]), ("Transport", ["crate_1", "gate"])], gate="XOR"),
            ("setLink", {"first": "Search(rex)", "second": "fetch-the-crate", "kind": "Precedence"}),
            ("setLink", {"first": "Follow(rex)", "second": "Fetch the crate", "kind": "Until"}),
            ("setTimes", {"subtask": "Fetch the crate", "release_s": 10, "deadline_s": 3600}),
            ("checkTree", {}),
        ),
    )  # fmt: skip


def _in_many_scripts() -> Dialogue:
    """Letters of two, three and four bytes, so that a cut may fall within a letter."""
    text = "Bring the tea 🍵 to Jürgen in the Café, then look for 小林"
    scene = Scene(
        places=(Entity(id="cafe", label="Café Münster"),),
        entities=(
            Entity(id="tea", label="tea 🍵"),
            Entity(id="juergen", kind="person", label="Jürgen"),
            Entity(id="kobayashi", kind="person", label="小林"),
        ),
    )
    return Dialogue(
        "many scripts",
        replace(_sample("reunite"), text=text, scene=scene),
        (
            begin(text),
            tasks(text, ["Tee für Jürgen ☕", "小林を探す"], [["Tee für Jürgen ☕", "小林を探す"]]),
            trees("Tee für Jürgen ☕", [("ReachAndTransportTree", {"agent": "tea 🍵", "location": "Jürgen"})]),
            trees("小林を探す", [("SearchTree", ["小林", ["tele_robot"]])]),
        ),
    )


def _not_clear() -> Dialogue:
    """A condition, which no tree holds: the model says so, and ends the dialogue."""
    text = "Bring the box to mom unless it rains"
    words = {"words": "unless it rains", "question": "Shall the box be brought, or shall it not?"}
    return Dialogue("not clear", replace(_sample("reunite"), text=text), (begin(text), ("declareUnclear", words)))


def _on_the_building_site() -> Dialogue:
    """The sample project: roads, masses, budgets, a routine of the user's own."""
    project = Path(FOLDER) / "project"
    brief = request_from(
        "Inspect the tower crane or the tool shed, and bring the toolbox to the office",
        fleet=project / "fleet.yaml",
        scene=project / "scene.yaml",
        routines=[project / "routines" / "inspect.yaml"],
    ).brief
    return Dialogue(
        "building site",
        brief,
        (
            begin(brief.text),
            task(brief.text, "Inspect", "AND"),
            trees("Inspect", [("InspectTree", ["tower_crane"]), ("InspectTree", {"target": "tool shed"})], gate="XOR"),
            trees(brief.text, [("ReachAndTransportTree", ["toolbox", "office", ["courier", "hauler"]])]),
            ("setLink", {"first": "inspect", "second": "ReachAndTransport(toolbox, office)"}),
            ("dropLink", {"first": "inspect", "second": "ReachAndTransport(toolbox, office)"}),
            ("listRoutines", {}),
        ),
    )
