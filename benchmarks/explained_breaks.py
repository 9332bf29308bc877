"""Ways to make a mission impossible by one change, each with the change that undoes it."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from random import Random

from missiontree.mission.area import Area, KeepOut
from missiontree.mission.brief import MissionBrief
from missiontree.mission.change import Change
from missiontree.mission.fleet import Fleet, RobotType
from missiontree.mission.plan import Plan
from missiontree.mission.scene import Scene
from missiontree.mission.tree import Link, MissionNode, MissionTree

Mission = tuple[MissionBrief, MissionTree]
Broken = tuple[Mission, Change]
Break = Callable[[Random, MissionBrief, MissionTree, Plan], Broken | None]


def _with_kind(brief: MissionBrief, old: RobotType, new: RobotType) -> MissionBrief:
    types = tuple(new if kind is old else kind for kind in brief.fleet.types)
    return replace(brief, fleet=replace(brief.fleet, types=types))


def _scene(brief: MissionBrief) -> Scene:
    assert brief.scene is not None, "every mission drawn here has a scene"
    return brief.scene


def capability(rng: Random, brief: MissionBrief, tree: MissionTree, plan: Plan) -> Broken | None:
    """A type loses a capability."""
    kind = rng.choice(brief.fleet.types)
    name = rng.choice(tuple(kind.capabilities))
    left = {other: has for other, has in kind.capabilities.items() if other != name}
    broken = _with_kind(brief, kind, replace(kind, capabilities=left))
    return (broken, tree), Change(kind="add_capability", target=kind.id, name=name)


def limit(rng: Random, brief: MissionBrief, tree: MissionTree, plan: Plan) -> Broken | None:
    """A payload or a budget of a type shrinks."""
    kind = rng.choice(brief.fleet.types)
    name = rng.choice(("payload_kg", "energy_j"))
    has = kind.limits.get(name, 9000.0)
    broken = _with_kind(brief, kind, replace(kind, limits={**kind.limits, name: round(has * rng.random() * 0.5, 1)}))
    return (broken, tree), Change(kind="raise_limit", target=kind.id, name=name, to=has)


def total(rng: Random, brief: MissionBrief, tree: MissionTree, plan: Plan) -> Broken | None:
    """Robots of a type, or all, may use little together."""
    most = float(rng.randint(0, 300))
    if rng.random() < 0.5:
        broken = replace(brief, fleet=replace(brief.fleet, total_limits={"energy_j": most}))
        return (broken, tree), Change(kind="raise_total", name="energy_j")
    kind = rng.choice(brief.fleet.types)
    broken = _with_kind(brief, kind, replace(kind, total_limits={"energy_j": most}))
    return (broken, tree), Change(kind="raise_total", target=kind.id, name="energy_j")


def stock(rng: Random, brief: MissionBrief, tree: MissionTree, plan: Plan) -> Broken | None:
    """The scene holds too little."""
    broken = replace(brief, scene=replace(_scene(brief), stock={"medkits": 0}))
    return (broken, tree), Change(kind="raise_stock", name="medkits")


def road(rng: Random, brief: MissionBrief, tree: MissionTree, plan: Plan) -> Broken | None:
    """A road is blocked, closed to a type, or one-way."""
    scene = _scene(brief)
    if scene.roads is None or not scene.roads.roads:
        return None
    chosen = rng.choice(scene.roads.roads)
    way = f"{chosen.ends[0]} - {chosen.ends[1]}"
    kind = rng.choice(brief.fleet.types)
    others = tuple(other.id for other in brief.fleet.types if other is not kind)
    closed, known = rng.choice(
        (
            (replace(chosen, blocked=True), Change(kind="open_way", target=way)),
            (replace(chosen, types=others), Change(kind="open_way", target=way, name=kind.id)),
            (replace(chosen, one_way=True), Change(kind="open_way", target=way, name="both ways")),
        )
    )
    roads = tuple(closed if one is chosen else one for one in scene.roads.roads)
    return (replace(brief, scene=replace(scene, roads=replace(scene.roads, roads=roads))), tree), known


def keep_out(rng: Random, brief: MissionBrief, tree: MissionTree, plan: Plan) -> Broken | None:
    """A place lies within an area that robots do not enter."""
    scene = _scene(brief)
    spot = rng.choice(scene.places).position
    assert spot is not None, "every place drawn here has a position"
    x, y = spot.x_m, spot.y_m
    area = KeepOut(id="closed", area=Area(corners=((x - 2, y - 2), (x + 2, y - 2), (x + 2, y + 2), (x - 2, y + 2))))
    return (replace(brief, scene=replace(scene, keep_outs=(area,))), tree), Change(
        kind="lift_keep_out", target="closed"
    )


def zone(rng: Random, brief: MissionBrief, tree: MissionTree, plan: Plan) -> Broken | None:
    """A type may enter no zone."""
    if not _scene(brief).zones:
        return None
    kind = rng.choice(brief.fleet.types)
    return (_with_kind(brief, kind, replace(kind, zones=())), tree), Change(
        kind="allow_zone", target=kind.id, name="ward"
    )


def deadline(rng: Random, brief: MissionBrief, tree: MissionTree, plan: Plan) -> Broken | None:
    """The mission, or a part of it, has to end too soon."""
    due = round(plan.schedules[0].makespan_s * rng.uniform(0.2, 0.95), 1)
    if rng.random() < 0.5:
        return (replace(brief, deadline_s=due), tree), Change(kind="extend_deadline")
    node = rng.choice([node for node in tree.nodes if node.routine is not None])
    return (brief, _with_node(tree, replace(node, deadline_s=due))), Change(kind="extend_deadline", target=node.id)


def stay(rng: Random, brief: MissionBrief, tree: MissionTree, plan: Plan) -> Broken | None:
    """A type leaves too soon."""
    kind = rng.choice(brief.fleet.types)
    until = round(plan.schedules[0].makespan_s * rng.uniform(0.1, 0.8), 1)
    return (_with_kind(brief, kind, replace(kind, available_until_s=until)), tree), Change(
        kind="extend_stay", target=kind.id
    )


def robot(rng: Random, brief: MissionBrief, tree: MissionTree, plan: Plan) -> Broken | None:
    """There is a robot less of a type."""
    kind = rng.choice(brief.fleet.types)
    if len(kind.members) < 2:
        return None
    return (_with_kind(brief, kind, replace(kind, count=1)), tree), Change(kind="add_robot", target=kind.id)


def in_use(rng: Random, brief: MissionBrief, tree: MissionTree, plan: Plan) -> Broken | None:
    """Fewer robots of a type may take part."""
    kind = rng.choice(brief.fleet.types)
    if len(kind.members) < 2:
        return None
    return (_with_kind(brief, kind, replace(kind, max_in_use=1)), tree), Change(kind="raise_in_use", target=kind.id)


def left_out(rng: Random, brief: MissionBrief, tree: MissionTree, plan: Plan) -> Broken | None:
    """A type takes no part."""
    kind = rng.choice(brief.fleet.types)
    return (replace(brief, without=(kind.id,)), tree), Change(kind="take_off_without", target=kind.id)


def required(rng: Random, brief: MissionBrief, tree: MissionTree, plan: Plan) -> Broken | None:
    """A type must take part."""
    kind = rng.choice(brief.fleet.types)
    return (replace(brief, require=(kind.id,)), tree), Change(kind="take_off_require", target=kind.id)


def quality(rng: Random, brief: MissionBrief, tree: MissionTree, plan: Plan) -> Broken | None:
    """Actions must be better."""
    return (replace(brief, min_quality=rng.choice((0.6, 0.9, 1.5))), tree), Change(kind="lower_min_quality")


def allowed(rng: Random, brief: MissionBrief, tree: MissionTree, plan: Plan) -> Broken | None:
    """A routine is for one type alone, and that is not the one that can do it."""
    node = rng.choice([node for node in tree.nodes if node.routine is not None])
    kind, other = rng.choice(brief.fleet.types), rng.choice(brief.fleet.types)
    broken = brief, _with_node(tree, replace(node, resources=(kind.id,)))
    return None if kind is other else (broken, Change(kind="allow_type", target=node.id))


def link(rng: Random, brief: MissionBrief, tree: MissionTree, plan: Plan) -> Broken | None:
    """Two parts are to have one robot, or different ones."""
    if tree.links or len(tree.root.children) < 2:
        return None
    first, second = rng.sample(tree.root.children, 2)
    bound = Link(first, second, rng.choice(("same_robot", "different_robot")))
    return (brief, replace(tree, links=(bound,))), Change(kind="drop_link", target=first, name=second)


def kinds(rng: Random, brief: MissionBrief, tree: MissionTree, plan: Plan) -> Broken | None:
    """Somebody is of a kind that the only way of doing it does not take."""
    node = next((node for node in tree.nodes if node.routine == "Transport"), None)
    if node is None:
        return None
    scene = _scene(brief)
    able = {"message_display": 1.0, "reach": 1.0, "search": 1.0, "inspect": 1.0, "treat": 1.0, "lift": 1.0}
    fleet = Fleet(tuple(replace(kind, capabilities=able, zones=None) for kind in brief.fleet.types))
    return (replace(brief, fleet=fleet, scene=scene), tree), Change(kind="ignore_kinds")


def _with_node(tree: MissionTree, new: MissionNode) -> MissionTree:
    return replace(tree, nodes=tuple(new if node.id == new.id else node for node in tree.nodes))


BREAKS: Sequence[Break] = (
    capability, limit, total, stock, road, keep_out, zone, deadline, stay, robot, in_use, left_out, required, quality, allowed, link, kinds,
)  # fmt: skip
"""Every way, by the name of its function."""
