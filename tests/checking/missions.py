"""Random missions of every kind that the road knows: maps, fleets, moved entities, joint work, links, budgets."""

from __future__ import annotations

import random
from dataclasses import replace

from missiontree.errors import InputError
from missiontree.mission.area import Area, KeepOut, Zone
from missiontree.mission.brief import MissionBrief
from missiontree.mission.entity import Entity
from missiontree.mission.estimate import Weights
from missiontree.mission.fleet import Capability, CostModel, DurationModel, Fleet, Robot, RobotType
from missiontree.mission.position import Position
from missiontree.mission.scene import Scene
from missiontree.mission.shared_resource import SharedResource
from missiontree.mission.tree import Link, LinkKind, MissionNode, MissionTree
from missiontree.mission.ways import Lift, OccupancyGrid, Road, RoadGraph, RoadNode
from missiontree.routines.ground import ground
from tests.builders import brief_of, routine_node
from tests.checking.plans import yard_routines

PLACES = ("alpha", "beta", "gamma")
AGENTS = ("ann", "box", "cat")
CAPABILITIES = ("search", "follow", "reach", "carry", "message_display")
KINDS: tuple[LinkKind, ...] = ("precedence", "precedence", "same_robot", "different_robot", "until")


def point(rng: random.Random, floors: tuple[str, ...] = ("ground",)) -> Position:
    """A point of a room of 10 m by 10 m, on a grid of half metres so that ties and touching lines come up."""
    return Position(rng.randrange(21) / 2, rng.randrange(21) / 2, rng.choice(floors))


def random_scene(rng: random.Random) -> Scene | None:
    """No scene, open ground with keep-outs, a road graph on two floors, or a grid."""
    kind = rng.choice(("none", "ground", "ground", "roads", "roads", "grid"))
    if kind == "none":
        return None
    floors = ("ground", "upper") if kind == "roads" else ("ground",)
    places = tuple(Entity(id=name, kind="place", position=point(rng, floors)) for name in PLACES)
    keep_outs = tuple(
        KeepOut(id=f"shut{number}", area=box(rng), types=rng.choice((None, ("t0",))))
        for number in range(rng.randrange(3))
    )
    scene = Scene(
        places=places,
        entities=tuple(random_entity(rng, name, floors) for name in AGENTS),
        zones=(Zone(id="wing", area=box(rng)), Zone(id="rest")),
        keep_outs=keep_outs if kind != "roads" or rng.random() < 0.3 else (),
    )
    if kind == "roads":
        shared = tuple(SharedResource(id=name, capacity=rng.choice((1, 1, 2))) for name in ("cabin", "gate"))
        return replace(scene, roads=random_roads(rng, floors), resources=shared)
    if kind == "grid":
        rows = tuple("".join(rng.choice("....#") for _ in range(11)) for _ in range(11))
        return replace(scene, grid=OccupancyGrid(rows=rows, cell_m=1.0))
    return scene


def box(rng: random.Random) -> Area:
    """A triangle or a rectangle."""
    x_m, y_m, width_m, height_m = rng.randrange(9), rng.randrange(9), rng.randrange(1, 5), rng.randrange(1, 5)
    corners = [(x_m, y_m), (x_m + width_m, y_m), (x_m + width_m, y_m + height_m), (x_m, y_m + height_m)]
    return Area(corners=tuple(corners[: rng.choice((3, 4))]))


def random_entity(rng: random.Random, name: str, floors: tuple[str, ...]) -> Entity:
    """A person, thing or animal: at a point, at a place, seen last somewhere, within an area, or lost."""
    kind = {"ann": "person", "box": "object", "cat": "animal"}[name]
    where = rng.choice(("position", "position", "place", "last_seen", "search_area", "lost"))
    fields: dict[str, object] = {}
    if where in {"position", "last_seen"}:
        fields[where] = point(rng, floors)
    elif where == "place":
        fields[where] = rng.choice(PLACES)
    elif where == "search_area":
        fields[where] = box(rng)
    return Entity(
        id=name,
        kind=kind,
        mass_kg=rng.choice((None, 5.0, 80.0)),
        max_speed_mps=rng.choice((None, 0.3, 5.0)),
        zone=rng.choice((None, None, "rest")),
        **fields,  # type: ignore[arg-type]
    )


def random_roads(rng: random.Random, floors: tuple[str, ...]) -> RoadGraph:
    """Nodes on two floors, roads on each, some closed or one-way, and a lift."""
    nodes = [RoadNode(id=f"n{number}", position=replace(point(rng), floor=floors[number % 2])) for number in range(6)]
    roads = []
    for first, second in ((0, 2), (2, 4), (0, 4), (1, 3), (3, 5), (1, 5)):
        straight_m = (
            (nodes[first].position.x_m - nodes[second].position.x_m) ** 2
            + (nodes[first].position.y_m - nodes[second].position.y_m) ** 2
        ) ** 0.5
        roads.append(
            Road(
                ends=(f"n{first}", f"n{second}"),
                length_m=rng.choice((None, None, straight_m + 1, 0.5)),
                one_way=rng.random() < 0.2,
                blocked=rng.random() < 0.1,
                types=rng.choice((None, None, None, ("t0",))),
                zone=rng.choice((None, None, None, "wing")),
                resource=rng.choice((None, None, None, None, "gate")),
            )
        )
    ramp = Road(ends=("n4", "n5"), length_m=25)
    lift = Lift(
        id="lift",
        stops=("n0", "n1"),
        ride_s=rng.choice((0.0, 5.0, 60.0)),
        types=rng.choice((None, None, ("t1",))),
        resource=rng.choice((None, "cabin", "cabin")),
    )
    return RoadGraph(nodes=tuple(nodes), roads=(*roads, ramp), lifts=(lift,))


def random_fleet(rng: random.Random, scene: Scene | None) -> Fleet:
    """Two or three types, counted or named, with and without speed, position, budgets and zones."""
    return Fleet(tuple(random_type(rng, f"t{number}", scene) for number in range(rng.choice((2, 3)))))


def random_type(rng: random.Random, name: str, scene: Scene | None) -> RobotType:
    """A robot type."""
    capabilities = {
        capability: Capability(
            quality=rng.choice((0.3, 0.5, 1.0)),
            duration=rng.choice((DurationModel(), DurationModel(scale=1.37, plus_s=0.0005))),
            cost=rng.choice((CostModel(), CostModel(fixed=1, per_s=0.1, per_m=0.5))),
        )
        for capability in CAPABILITIES
        if rng.random() < 0.8
    }
    limits = {}
    if rng.random() < 0.8:
        limits["max_speed_mps"] = rng.choice((0.7, 1.0, 3.0))
    if rng.random() < 0.5:
        limits["payload_kg"] = rng.choice((10.0, 50.0))
    if rng.random() < 0.5:
        limits["energy_j"] = rng.choice((120.0, 400.0))
    common = {
        "id": name,
        "capabilities": capabilities,
        "limits": limits,
        "total_limits": rng.choice(({}, {}, {"energy_j": 500.0})),
        "uses_per_m": rng.choice(({}, {"energy_j": 2.0})),
        "zones": rng.choice((None, None, ("wing", "rest"), ("rest",))) if scene is not None else None,
    }
    starts = [start_of(rng, scene) for _ in range(rng.choice((1, 2, 3)))]
    if rng.random() < 0.5:
        return RobotType(count=len(starts), **common, **starts[0])  # type: ignore[arg-type]
    robots = tuple(
        Robot(id=f"{name}_{number}", remaining=rng.choice(({}, {"energy_j": 150.0})), **start)  # type: ignore[arg-type]
        for number, start in enumerate(starts)
    )
    return RobotType(robots=robots, **common)  # type: ignore[arg-type]


def start_of(rng: random.Random, scene: Scene | None) -> dict[str, object]:
    """Where a robot starts."""
    where = rng.choice(("position", "position", "place", "unknown")) if scene is not None else "unknown"
    if where == "position":
        return {"position": point(rng)}
    return {"place": rng.choice(PLACES)} if where == "place" else {}


def random_tree(rng: random.Random, brief: MissionBrief) -> MissionTree:
    """Two to five routine calls below tasks, with links that grounding accepts."""
    leaves = [random_call(rng, f"call{number}") for number in range(rng.choice((2, 3, 4, 5)))]
    inner = leaves[1:3]
    task = MissionNode(
        id="task", label="Task", gate=rng.choice(("and", "xor", "xor")), children=tuple(leaf.id for leaf in inner)
    )
    children = (leaves[0].id, "task", *(leaf.id for leaf in leaves[3:]))
    root = MissionNode(id="root", label="Mission", gate="and", children=children)
    entities = (
        ()
        if brief.scene is not None
        else tuple(
            Entity(id=name, kind=kind)
            for name, kind in (
                ("ann", "person"),
                ("box", "object"),
                ("cat", "animal"),
                *((place, "place") for place in PLACES),
            )
        )
    )
    tree = MissionTree(objective="Mission", nodes=(root, leaves[0], task, *inner, *leaves[3:]), entities=entities)
    ends = [node.id for node in tree.nodes[1:]]
    for _ in range(rng.randrange(5)):
        link = Link(rng.choice(ends), rng.choice(ends), rng.choice(KINDS))
        try:
            longer = replace(tree, links=(*tree.links, link))
            ground(longer, brief)
        except (ValueError, InputError):
            continue
        tree = longer
    return tree


def random_call(rng: random.Random, node_id: str) -> MissionNode:
    """A call of some routine."""
    routine = rng.choice(
        ("Search", "Follow", "Reach", "SearchAndFollow", "Transport", "ReachAndTransport", "Inspect", "CarryTogether")
    )
    arguments = {"agent": rng.choice(AGENTS)}
    if routine in {"Transport", "ReachAndTransport", "CarryTogether"}:
        arguments["location"] = rng.choice(PLACES)
    resources = rng.choice((None, None, None, ("t0", "t1")))
    return routine_node(node_id, routine, resources, **arguments)


def random_mission(seed: int) -> tuple[MissionTree, MissionBrief]:
    """A tree and its brief; the same for the same seed."""
    rng = random.Random(seed)  # noqa: S311 - variation, not secrecy
    scene = random_scene(rng)
    brief = brief_of(
        "Mission",
        random_fleet(rng, scene),
        yard_routines(),
        scene=scene,
        weights=rng.choice((Weights(), Weights(1, 0.001, 0.01))),
        check_kinds=rng.random() < 0.7,
    )
    return random_tree(rng, brief), brief


def ruled_mission(seed: int) -> tuple[MissionTree, MissionBrief]:
    """The mission of that seed, under rules for the whole of it: totals, a stock, robots in use, left out and required, and quality."""
    rng = random.Random(f"ruled:{seed}")  # noqa: S311 - variation, not secrecy
    tree, brief = random_mission(seed)
    types = tuple(replace(kind, max_in_use=rng.choice((None, 1, 2))) for kind in brief.fleet.types)
    fleet = replace(
        brief.fleet, types=types, total_limits=rng.choice(({}, {"energy_j": rng.choice((50.0, 300.0, 900.0))}))
    )
    scene = brief.scene
    if scene is not None and rng.random() < 0.3:
        scene = replace(scene, stock={"energy_j": rng.choice((100.0, 500.0))})
    kept = replace(brief, fleet=fleet, scene=scene)
    for rule in rng.sample(("without", "require", "min_quality"), rng.choice((1, 2, 3))):
        if rule == "min_quality":
            least = rng.choice((0.4, 1.0, {"Search": 0.5}, {"reach": 1.0, "ReachAndTransport": 0.4}))
            kept = replace(kept, min_quality=least)
            continue
        names = rng.sample((*fleet.by_id, *fleet.robots, *fleet.robots), rng.choice((1, 2)))
        try:
            kept = replace(kept, **{rule: tuple(names)})  # type: ignore[arg-type]
        except ValueError:
            continue  # nobody would be left, or somebody is both left out and required
    return tree, kept
