"""Small missions drawn by luck: a team, a world or none, routines. They are what a hostile model is let loose on."""

from __future__ import annotations

from functools import cache
from random import Random
from typing import Any

from missiontree.mission.area import Area, KeepOut, Zone
from missiontree.mission.brief import MissionBrief
from missiontree.mission.entity import Entity
from missiontree.mission.fleet import Fleet, Robot, RobotType
from missiontree.mission.position import Position
from missiontree.mission.routine import ActionStep, Argument, Branch, Need, RoleSpec, Routine, RoutineLibrary
from missiontree.mission.scene import Scene
from missiontree.mission.ways import Road, RoadGraph, RoadNode
from missiontree.routines.library import built_in

CAPABILITIES = ("search", "follow", "reach", "carry", "message_display", "scan")
PLACES = ("alpha", "beta")
KIND_OF = {"ann": "person", "box": "object", "crate": "object", "cat": "animal", "alpha": "place", "beta": "place"}
TEXTS = (
    "Find Ann and bring the box to alpha",
    "Follow the cat until the crate is at beta",
    "Scan the box, then carry it to Ann or to the cat",
    "Do something",
)
_THINGS = ("person", "animal", "object")


def random_mission(rng: Random) -> MissionBrief:
    """Draw a mission."""
    scene = random_scene(rng)
    return MissionBrief(
        text=rng.choice(TEXTS),
        fleet=random_fleet(rng, scene),
        routines=rng.choice(libraries()),
        scene=scene,
        check_kinds=rng.random() < 0.9,
    )


def random_fleet(rng: Random, scene: Scene | None) -> Fleet:
    """One to three types of one or two robots, with few capabilities and with limits that bind."""
    return Fleet(tuple(_type(rng, f"t{number}", scene) for number in range(rng.choice((1, 2, 2, 3)))))


def _type(rng: Random, name: str, scene: Scene | None) -> RobotType:
    common: dict[str, Any] = {
        "id": name,
        "label": rng.choice(("", "", "Carrier", "Ann")) or name,
        "capabilities": {known: rng.choice((0.3, 0.5, 1.0)) for known in CAPABILITIES if rng.random() < 0.6},
        "limits": {
            limit: rng.choice(values)
            for limit, values in (
                ("payload_kg", (0.0, 10.0, 50.0)),
                ("energy_j", (60.0, 200.0, 900.0)),
                ("max_speed_mps", (0.7, 2.0)),
                ("range_m", (3.0, 9.0)),
            )
            if rng.random() < 0.5
        },
        "total_limits": {"energy_j": 300.0} if rng.random() < 0.2 else {},
        "uses_per_m": {"energy_j": 2.0} if rng.random() < 0.3 else {},
        "zones": rng.choice((None, None, ("yard",))) if scene is not None else None,
    }
    starts = [_start(rng, scene) for _ in range(rng.choice((1, 2)))]
    if rng.random() < 0.7:
        return RobotType(count=len(starts), **common, **starts[0])
    robots = tuple(Robot(id=f"{name}_{number}", **start) for number, start in enumerate(starts))
    return RobotType(robots=robots, **common)


def _start(rng: Random, scene: Scene | None) -> dict[str, Any]:
    where = rng.choice(("somewhere", "place", "unknown")) if scene is not None else "unknown"
    if where == "somewhere":
        return {"position": _point(rng)}
    return {"place": rng.choice(PLACES)} if where == "place" else {}


def _point(rng: Random) -> Position:
    return Position(rng.randrange(11), rng.randrange(11))


def random_scene(rng: Random) -> Scene | None:
    """No scene; or places and four others, on open ground with a keep-out or on roads, some of them lost, some heavy."""
    kind = rng.choice(("none", "none", "ground", "ground", "roads"))
    if kind == "none":
        return None
    places = tuple(Entity(id=name, kind="place", position=_point(rng)) for name in PLACES)
    entities = tuple(
        _entity(rng, *known) for known in (("ann", "person"), ("box", "object"), ("crate", "crate"), ("cat", "animal"))
    )
    shut = KeepOut(id="shut", area=Area(corners=((4, 4), (6, 4), (6, 6), (4, 6))))
    return Scene(
        kinds={"crate": "object"},
        places=places,
        entities=entities,
        zones=(Zone(id="yard"), Zone(id="hall")),
        keep_outs=(shut,) if kind == "ground" and rng.random() < 0.4 else (),
        roads=_roads(rng) if kind == "roads" else None,
    )


def _entity(rng: Random, name: str, kind: str) -> Entity:
    where = rng.choice(({"position": _point(rng)}, {"place": rng.choice(PLACES)}, {"last_seen": _point(rng)}, {}))
    return Entity(
        id=name,
        kind=kind,
        label=rng.choice((name, name.title(), f"the {name}")),
        mass_kg=rng.choice((None, 5.0, 80.0)),
        zone=rng.choice((None, None, None, "yard", "hall")),
        **where,
    )


def _roads(rng: Random) -> RoadGraph:
    roads = (
        Road(ends=("alpha", "n"), one_way=rng.random() < 0.2),
        Road(ends=("n", "beta"), types=rng.choice((None, ("t0",)))),
        Road(ends=("alpha", "beta"), length_m=25, blocked=rng.random() < 0.3),
    )
    return RoadGraph(nodes=(RoadNode(id="n", position=_point(rng)),), roads=roads)


@cache
def libraries() -> tuple[RoutineLibrary, ...]:
    """Few routines mostly, so that a run takes little: some of the built-in ones, some of our own, and now and then all."""
    known, own = built_in().by_id, (_scan(), _haul(), _meet())
    few = [
        RoutineLibrary(routines=(*(known[name] for name in names), *more))
        for names, more in (
            (("Search", "Reach", "Transport", "ReachAndTransport"), ()),
            (("Search", "Follow", "SearchAndFollow"), ()),
            (("Search", "Transport"), own[:1]),
            (("Follow",), own),
        )
    ]
    return (*few, *few, RoutineLibrary(routines=(*built_in().routines, *own)))


def _scan() -> Routine:
    """Needs a range and energy, and takes no person."""
    needs = (Need(limit="range_m", at_least=5.0), Need(capability="reach"))
    look = ActionStep(name="scan", text="Scan {target}", duration_s=20, at="target", uses={"energy_j": 50})
    role = RoleSpec(name="scanner", rating="scan", needs=needs, actions=(look,))
    return Routine(
        id="Scan",
        purpose="Scan {target}.",
        arguments=(Argument(name="target", kinds=("object", "place")),),
        branches=(Branch(name="scan", roles=(role,)),),
    )


def _haul() -> Routine:
    """Two robots carry together, each half of the mass."""
    grip = ActionStep(name="grip", text="Grip {agent}", duration_s=10, at="agent", sync="grip")
    haul = ActionStep(
        name="haul", text="Haul {agent} to {to}", duration_s=60, goes_to="to", brings=("agent",), sync="haul"
    )
    needs = (Need(limit="payload_kg", at_least="agent.mass_kg", share=0.5),)
    pair = RoleSpec(name="carrier", rating="carry", robots=2, needs=needs, actions=(grip, haul))
    return Routine(
        id="Haul",
        purpose="Carry {agent} to {to} with two robots.",
        arguments=(Argument(name="agent", kinds=_THINGS), Argument(name="to", kinds=("place",))),
        branches=(Branch(name="pair", roles=(pair,)),),
    )


def _meet() -> Routine:
    """Two roles of different kinds, or one robot that does it worse; the first way takes persons alone."""
    go = ActionStep(name="go", text="Go to {agent}", duration_s=30, goes_to="agent")
    wave = ActionStep(name="wave", text="Wave at {agent}", duration_s=5, at="agent")
    guide = RoleSpec(name="guide", rating="message_display", actions=(go, wave))
    guard = RoleSpec(name="guard", rating="follow", actions=(go,))
    alone = RoleSpec(name="loner", rating="reach", actions=(go, wave))
    return Routine(
        id="Meet",
        purpose="Meet {agent}.",
        arguments=(Argument(name="agent", kinds=_THINGS),),
        branches=(
            Branch(name="both", roles=(guide, guard), accepts={"agent": ("person",)}),
            Branch(name="alone", roles=(alone,)),
        ),
    )
