"""Small missions drawn at random, in scenes with roads or open ground, for explanations to be held against."""

from __future__ import annotations

import json
from functools import cache
from random import Random
from typing import Any

from missiontree.briefing import Request
from missiontree.formats.document import read_text
from missiontree.mission.brief import MissionBrief
from missiontree.mission.fleet import Fleet, RobotType
from missiontree.mission.routine import RoutineLibrary
from missiontree.mission.scene import Scene
from missiontree.mission.tree import Gate, Link, MissionNode, MissionTree
from missiontree.routines.library import built_in

ABILITIES = ("search", "reach", "carry", "inspect", "treat", "lift", "message_display")
OWN = """
routines:
  - id: Inspect
    purpose: Inspect {agent}
    arguments: [{name: agent, kinds: [object, place]}]
    branches:
      - name: inspect
        roles:
          - name: inspector
            rating: inspect
            actions: [{name: inspect, text: "Inspect {agent}", duration_s: 30, at: agent, uses: {energy_j: 100}}]
  - id: Treat
    purpose: Treat {agent}
    arguments: [{name: agent, kinds: [person]}]
    branches:
      - name: treat
        roles:
          - name: medic
            rating: treat
            actions: [{name: treat, text: "Treat {agent}", duration_s: 40, at: agent, uses: {medkits: 1, energy_j: 60}}]
  - id: LiftTogether
    purpose: Lift {agent}
    arguments: [{name: agent, kinds: [object]}]
    branches:
      - name: lift
        roles:
          - name: lifter
            rating: lift
            robots: 2
            needs: [{limit: payload_kg, at_least: agent.mass_kg, share: 0.5}]
            actions: [{name: lift, text: "Lift {agent}", duration_s: 20, at: agent, sync: up, uses: {energy_j: 80}}]
"""


@cache
def library() -> RoutineLibrary:
    """The built-in routines, and three that use stocks, energy and joint work."""
    return RoutineLibrary(routines=(*built_in().routines, *read_text(OWN, "routines").routines))


def drawn(rng: Random) -> Request:
    """A mission; whether it can be done is not known."""
    places = [f"p{number}" for number in range(rng.randint(3, 5))]
    scene = _scene(rng, places)
    fleet = Fleet(tuple(_kind(rng, number, places) for number in range(rng.randint(2, 4))))
    tree = _tree(rng, [entity["id"] for entity in scene["entities"]], places)
    brief = MissionBrief(
        text=tree.objective,
        fleet=fleet,
        scene=_read("scene", scene),
        routines=library(),
        deadline_s=rng.choice((None, None, None, 2000.0)),
    )
    return Request(brief=brief, tree=tree, k=1)


def _read(kind: str, value: dict[str, Any]) -> Scene:
    scene = read_text(json.dumps(value), kind)
    assert isinstance(scene, Scene)
    return scene


def _scene(rng: Random, places: list[str]) -> dict[str, Any]:
    spots = {
        name: {"x_m": rng.randint(0, 40), "y_m": rng.randint(0, 40) + 50 * number} for number, name in enumerate(places)
    }
    scene: dict[str, Any] = {"places": [{"id": name, "position": spot} for name, spot in spots.items()], "entities": []}
    for number in range(rng.randint(2, 4)):
        kind = rng.choice(("person", "object", "object"))
        entity: dict[str, Any] = {"id": f"{kind}{number}", "kind": kind, "place": rng.choice(places)}
        if kind == "object":
            entity["mass_kg"] = rng.randint(2, 20)
        scene["entities"].append(entity)
    if rng.random() < 0.7:
        ways = [(places[rng.randrange(number)], name) for number, name in enumerate(places) if number]
        ways += [tuple(rng.sample(places, 2)) for _ in range(rng.randint(0, 1))]  # type: ignore[misc]  # two of them
        scene["roads"] = {"roads": [{"ends": list(way)} for way in dict.fromkeys(ways)]}
    if rng.random() < 0.3:
        scene["zones"] = [{"id": "ward"}]
        scene["places"][-1]["zone"] = "ward"
    if rng.random() < 0.4:
        scene["stock"] = {"medkits": rng.randint(2, 4)}
    return scene


def _kind(rng: Random, number: int, places: list[str]) -> RobotType:
    able = rng.sample(ABILITIES, rng.randint(2, 4))
    limits: dict[str, float] = {"max_speed_mps": rng.choice((1.0, 2.0)), "payload_kg": rng.randint(15, 40)}
    if rng.random() < 0.6:
        limits["energy_j"] = rng.randint(10, 60) * 100
    return RobotType(
        id=f"t{number}",
        capabilities={name: rng.choice((0.5, 0.8, 1.0)) for name in able},
        limits=limits,
        uses_per_m={"energy_j": rng.choice((1, 2))} if rng.random() < 0.6 else {},
        count=rng.randint(1, 2),
        place=rng.choice(places),
    )


def _tree(rng: Random, entities: list[str], places: list[str]) -> MissionTree:
    count = rng.randint(1, 4)
    leaves: list[MissionNode] = []
    for number in range(count):
        routine, arguments = _call(rng, entities, places)
        label = f"{routine}({', '.join(arguments.values())})"
        due = rng.choice((None, None, None, 1500.0))
        leaves.append(MissionNode(id=f"n{number}", label=label, routine=routine, arguments=arguments, deadline_s=due))
    ids = tuple(leaf.id for leaf in leaves)
    nodes: list[MissionNode] = []
    if count > 2 and rng.random() < 0.4:
        gates: tuple[Gate, ...] = ("and", "xor")
        inner = MissionNode(id="inner", label="Inner task", gate=rng.choice(gates), children=ids[:2])
        nodes = [MissionNode(id="root", label="Mission", gate="and", children=("inner", *ids[2:])), inner]
        ids = ("inner", *ids[2:])
    else:
        nodes = [MissionNode(id="root", label="Mission", gate="and", children=ids)]
    links = [Link(ids[0], ids[-1])] if len(ids) > 1 and rng.random() < 0.3 else []
    if len(ids) > 1 and rng.random() < 0.15:
        links.append(Link(ids[0], ids[1], rng.choice(("same_robot", "different_robot"))))
    return MissionTree(objective="Mission", nodes=(*nodes, *leaves), links=tuple(links))


def _call(rng: Random, entities: list[str], places: list[str]) -> tuple[str, dict[str, str]]:
    people = [name for name in entities if name.startswith("person")]
    objects = [name for name in entities if name.startswith("object")]
    kinds = (
        ["Search", "Reach"]
        + ["Treat"] * bool(people)
        + ["Inspect", "LiftTogether", "Transport", "Transport"] * bool(objects)
    )
    routine = rng.choice(kinds)
    if routine == "Transport":
        return routine, {"agent": rng.choice(objects), "location": rng.choice(places)}
    whom = {"Treat": people, "Inspect": objects, "LiftTogether": objects}.get(routine, entities)
    return routine, {"agent": rng.choice(whom)}
