"""Random missions of what is rare: chargers that are needed, ways home, hand-overs, lifts with room for one, joint work, times."""

from __future__ import annotations

import random
from dataclasses import dataclass, field, replace

from missiontree.mission.brief import MissionBrief
from missiontree.mission.charger import Charger
from missiontree.mission.entity import Entity
from missiontree.mission.fleet import Fleet, Robot, RobotType
from missiontree.mission.position import Position
from missiontree.mission.routine import ActionStep, Argument, Branch, RoleSpec, Routine, RoutineLibrary
from missiontree.mission.scene import Scene
from missiontree.mission.shared_resource import SharedResource
from missiontree.mission.tree import Link, MissionNode, MissionTree
from missiontree.mission.ways import Lift, Road, RoadGraph, RoadNode
from tests.builders import brief_of, routine_node
from tests.checking.plans import THINGS, yard_routines

PLACES = ("hall", "dock", "loft", "attic")
SPOTS = ("pump", "valve", "tank", "crate", "beam")
ABILITIES = ("reach", "carry", "search", "follow", "look", "spray", "open")
LACKING = 0.3
"""How likely the second type is to lack an ability; the first has them all."""


def driven_routines() -> RoutineLibrary:
    """Those of the yard; a look that takes much energy, a spray that takes water, and a door whose opener holds the key."""
    look = ActionStep(name="look", text="Look at {agent}", duration_s=20.0, at="agent", uses={"energy_j": 55.0})
    spray = ActionStep(name="spray", text="Spray {agent}", duration_s=8.0, at="agent", uses={"water_l": 6.0})
    unlock = tuple(
        ActionStep(name=name, text=f"{name} {{agent}}", duration_s=12.0, at="agent", holds=("key",))
        for name in ("unlock", "pull")
    )
    own = (_routine(name, steps) for name, steps in (("Look", (look,)), ("Spray", (spray,)), ("Open", unlock)))
    return RoutineLibrary(routines=(*yard_routines().routines, *own))


def _routine(name: str, steps: tuple[ActionStep, ...]) -> Routine:
    doer = RoleSpec(name="doer", rating=name.lower(), actions=steps)
    return Routine(
        id=name,
        purpose=f"{name} {{agent}}",
        arguments=(Argument(name="agent", kinds=THINGS),),
        branches=(Branch(name="one", roles=(doer,)),),
    )


def point(rng: random.Random, floor: str = "ground") -> Position:
    """A point of a room of 20 m by 20 m."""
    return Position(rng.randrange(41) / 2, rng.randrange(41) / 2, floor)


def driven_scene(rng: random.Random, on_roads: float = 0.6) -> Scene:
    """Open ground, or roads on two floors between which a lift goes that has room for one; with up to two chargers, and a tap."""
    roads = rng.random() < on_roads
    upper = "upper" if roads else "ground"
    floors = {"loft": upper, "attic": upper}
    places = tuple(Entity(id=name, kind="place", position=point(rng, floors.get(name, "ground"))) for name in PLACES)
    entities = tuple(
        Entity(id=name, mass_kg=rng.choice((5.0, 40.0)), position=point(rng, rng.choice(("ground", "ground", upper))))
        for name in SPOTS
    )
    chargers = tuple(driven_charger(rng, f"plug{number}") for number in range(rng.choice((0, 1, 1, 2))))
    scene = Scene(
        places=places,
        entities=entities,
        chargers=(*chargers, Charger(id="tap", place="dock", rate_per_s=rng.choice((0.5, 4.0)), stock="water_l")),
        resources=tuple(SharedResource(id=name, capacity=1) for name in ("key", "cabin", "gate")),
    )
    return replace(scene, roads=two_floors(rng)) if roads else scene


def driven_charger(rng: random.Random, name: str) -> Charger:
    """At a place or a point; for one or two robots, of some types or of all."""
    where: dict[str, object] = (
        {"place": rng.choice(("hall", "dock", "loft"))} if rng.random() < 0.5 else {"position": point(rng)}
    )
    return Charger(
        id=name,
        rate_per_s=rng.choice((1.0, 3.0, 10.0)),
        types=rng.choice((None, None, ("t0", "t1"), ("t0",))),
        capacity=rng.choice((1, 1, 1, 2)),
        **where,  # type: ignore[arg-type]
    )


def two_floors(rng: random.Random) -> RoadGraph:
    """A square of roads on each floor, one of them a gate for one at a time, a lift, and a long ramp at times."""
    corners = ((2, 2), (18, 2), (18, 18), (2, 18))
    nodes = [
        RoadNode(id=f"{floor[0]}{number}", position=Position(x_m, y_m, floor))
        for floor in ("ground", "upper")
        for number, (x_m, y_m) in enumerate(corners)
    ]
    roads = [
        Road(
            ends=(f"{floor}{number}", f"{floor}{(number + 1) % 4}"),
            resource="gate" if (floor, number) == ("g", 1) else None,
            length_m=rng.choice((None, None, 20.0)),
        )
        for floor in "gu"
        for number in range(4)
    ]
    ramp = (Road(ends=("g3", "u3"), length_m=80.0),) if rng.random() < 0.3 else ()
    lift = Lift(id="lift", stops=("g0", "u0"), ride_s=rng.choice((4.0, 15.0)), resource="cabin")
    return RoadGraph(nodes=tuple(nodes), roads=(*roads, *ramp), lifts=(lift,))


def driven_type(rng: random.Random, name: str) -> RobotType:
    """Robots that hold little and use much, some of which come later or leave early."""
    least = 100.0
    common = {
        "id": name,
        "capabilities": {
            one: rng.choice((0.5, 0.8, 1.0)) for one in ABILITIES if rng.random() > LACKING or name == "t0"
        },
        "limits": {
            "max_speed_mps": rng.choice((1.0, 1.5, 3.0)),
            "payload_kg": 50.0,
            "energy_j": rng.choice((least, 130.0, 160.0, 400.0)),
            "water_l": rng.choice((8.0, 14.0)),
        },
        "uses_per_m": {"energy_j": rng.choice((0.25, 0.5, 1.0))},
        "available_from_s": rng.choice((None, None, 5.0)),
        "available_until_s": rng.choice((None, None, 2000.0)),
    }
    if rng.random() < 0.5:
        return RobotType(count=rng.choice((2, 3)), position=point(rng), **common)  # type: ignore[arg-type]
    robots = tuple(
        Robot(
            id=f"{name}_{number}",
            position=point(rng),
            remaining=rng.choice(({}, {}, {"energy_j": 0.9 * least})),
            available_from_s=rng.choice((None, None, 12.5)),
        )
        for number in range(rng.choice((2, 3)))
    )
    return RobotType(robots=robots, **common)  # type: ignore[arg-type]


@dataclass
class Calls:
    """Calls of routines and the links between them, so far."""

    rng: random.Random
    leaves: list[MissionNode] = field(default_factory=list)
    links: list[Link] = field(default_factory=list)

    def call(self, routine: str, **arguments: str) -> str:
        """Add a call, at times with a release or a deadline that is kept easily; its name."""
        name = f"call{len(self.leaves)}"
        node = routine_node(name, routine, None, **arguments)
        times = self.rng.choice(({}, {}, {"release_s": 15.0}, {"deadline_s": 1500.0}))
        self.leaves.append(replace(node, **times))  # type: ignore[arg-type]
        return name

    def link(self, first: str, second: str, kind: str = "precedence") -> None:
        """Add a link."""
        self.links.append(Link(first, second, kind))  # type: ignore[arg-type]

    def looks(self) -> None:
        """Two or three looks, the ends of which are linked at times."""
        spots = self.rng.sample(SPOTS[:3], self.rng.choice((2, 3)))
        names = [self.call("Look", agent=spot) for spot in spots]
        kind = self.rng.choice(("none", "same_robot", "different_robot", "precedence"))
        if kind != "none":
            self.link(names[0], names[1], kind)

    def handed_over(self) -> None:
        """A crate is brought by one robot and taken on by another."""
        middle, end = self.rng.sample(PLACES, 2)
        first = self.call("Transport", agent="crate", location=middle)
        self.link(first, self.call("Transport", agent="crate", location=end), "hand_over")

    def opened(self) -> None:
        """Two doors, one key, and at times two robots."""
        first, second = (self.call("Open", agent=spot) for spot in self.rng.sample(SPOTS[:3], 2))
        if self.rng.random() < 0.7:
            self.link(first, second, "different_robot")

    def hauled(self) -> None:
        """A beam that two carry."""
        self.call("CarryTogether", agent="beam", location=self.rng.choice(PLACES))

    def watched(self) -> None:
        """Somebody follows until somebody else has looked."""
        first = self.call("Follow", agent=self.rng.choice(SPOTS[:3]))
        self.link(first, self.call("Look", agent=self.rng.choice(SPOTS[:3])), "until")

    def sprayed(self) -> None:
        """Two or three sprays, more water than a robot holds."""
        for spot in self.rng.sample(SPOTS[:3], self.rng.choice((2, 3))):
            self.call("Spray", agent=spot)

    def tree(self) -> MissionTree:
        """All of them below the root; the last two as a choice at times, if no link keeps them."""
        leaves = self.leaves
        linked = {end for link in self.links for end in (link.first, link.second)}
        inner = leaves[-2:]
        if len(leaves) > 2 and not linked & {one.id for one in inner} and self.rng.random() < 0.7:
            task = MissionNode(id="either", label="Either", gate="xor", children=tuple(one.id for one in inner))
            nodes, children = [*leaves[:-2], task, *inner], (*(one.id for one in leaves[:-2]), "either")
        else:
            nodes, children = leaves, tuple(one.id for one in leaves)
        root = MissionNode(id="root", label="Mission", gate="and", children=children)
        return MissionTree(objective="Mission", nodes=(root, *nodes), links=tuple(self.links))


def driven_mission(seed: int) -> tuple[MissionTree, MissionBrief]:
    """A tree and its brief; the same for the same seed."""
    rng = random.Random(f"driven:{seed}")  # noqa: S311 - variation, not secrecy
    calls = Calls(rng)
    kinds = (calls.handed_over, calls.hauled, calls.watched, calls.opened, calls.looks, calls.sprayed)
    for kind in rng.sample(kinds, 2):
        kind()
    return calls.tree(), driven_brief(rng)


def driven_brief(rng: random.Random, on_roads: float = 0.6) -> MissionBrief:
    """A fleet of two types and one that does nothing, whom most of these missions send home, by a deadline at times."""
    fleet = Fleet((driven_type(rng, "t0"), driven_type(rng, "t1"), RobotType(id="idle", count=1, position=point(rng))))
    home = rng.random() < 0.75
    return brief_of(
        "Mission",
        fleet,
        driven_routines(),
        scene=driven_scene(rng, on_roads),
        return_home=home,
        deadline_s=rng.choice((None, 2500.0)),
    )


def crowded_mission(seed: int) -> tuple[MissionTree, MissionBrief]:
    """Looks at four or more, between any two of which a robot must refill, at one charger with room for one."""
    rng = random.Random(f"crowded:{seed}")  # noqa: S311 - variation, not secrecy
    calls = Calls(rng)
    for _ in range(rng.choice((4, 5, 6))):
        calls.call("Look", agent=rng.choice(SPOTS[:3]))
    if rng.random() < 0.25:
        calls.link("call0", "call1", "same_robot")
    brief = driven_brief(rng, on_roads=0.85)
    kind = RobotType(
        id="t0",
        count=2,
        capabilities={"look": 1.0},
        limits={"max_speed_mps": 2.0, "energy_j": rng.choice((100.0, 110.0))},
        uses_per_m={"energy_j": rng.choice((0.25, 0.5))},
        position=point(rng),
    )
    types = (kind, replace(kind, id="t1", count=1, position=point(rng)), *brief.fleet.types[2:])
    assert brief.scene is not None
    plug = Charger(
        id="plug",
        rate_per_s=rng.choice((1.0, 2.0)),
        place=rng.choice(("hall", "dock", "loft")),
        types=rng.choice((None, ("t0", "t1"))),
    )
    return calls.tree(), replace(brief, fleet=Fleet(types), scene=replace(brief.scene, chargers=(plug,)))


def part_mission(seed: int) -> tuple[MissionTree, MissionBrief]:
    """A mission one part of which nobody can do, as it should be over before it can be."""
    rng = random.Random(f"part:{seed}")  # noqa: S311 - variation, not secrecy
    calls = Calls(rng)
    for spot in rng.sample(SPOTS[:3], rng.choice((2, 3))):
        calls.call(rng.choice(("Look", "Spray", "Reach")), agent=spot)
    kept = [one.id for one in calls.leaves]
    lost = calls.call("Inspect", agent="beam")
    calls.leaves[-1] = replace(calls.leaves[-1], release_s=0.0, deadline_s=rng.choice((1.0, 20.0)))
    calls.link(kept[0], rng.choice((kept[1], lost)))
    root = MissionNode(id="root", label="Mission", gate="and", children=tuple(one.id for one in calls.leaves))
    tree = MissionTree(objective="Mission", nodes=(root, *calls.leaves), links=tuple(calls.links))
    brief = driven_brief(rng)
    weights = {rng.choice(kept): rng.choice((1.5, 2.0)), lost: rng.choice((0.5, 1.0))}
    return tree, replace(brief, parts=weights)
