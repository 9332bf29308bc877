"""Families of fleets, scenes, routines, trees and grounded trees, drawn by hypothesis."""

from __future__ import annotations

from itertools import pairwise
from typing import Any

from hypothesis import strategies as st

from missiontree.formats.routine_file import RoutineFile
from missiontree.mission.area import Area, KeepOut, Zone
from missiontree.mission.entity import Entity
from missiontree.mission.estimate import Estimate
from missiontree.mission.fleet import Capability, CostModel, DurationModel, Fleet, Robot, RobotType
from missiontree.mission.grounded import Action, GroundedLink, GroundedNode, GroundedTree, Role
from missiontree.mission.position import Position
from missiontree.mission.routine import ActionStep, Argument, Branch, Need, Part, RoleSpec, Routine
from missiontree.mission.scene import Scene
from missiontree.mission.tree import LINK_KINDS, Gate, Link, MissionNode, MissionTree
from missiontree.mission.ways import OccupancyGrid, Road, RoadGraph, RoadNode

ids = st.from_regex(r"[A-Za-z][A-Za-z0-9_-]{0,8}", fullmatch=True)
texts = st.text(st.characters(exclude_categories=("Cs", "Cc")), max_size=12).filter(lambda text: "\uffff" not in text)
numbers = st.floats(0, 1e9, allow_nan=False) | st.integers(0, 10**9)
signed = st.floats(-1e6, 1e6, allow_nan=False)
positive = st.floats(1e-3, 1e6)
maybe_ids = st.none() | ids
tables = st.dictionaries(ids, numbers, max_size=3)
positions = st.builds(Position, signed, signed, floor=ids)
capabilities = st.builds(
    Capability,
    numbers,
    st.builds(DurationModel, positive, numbers) | st.just(DurationModel()),
    st.builds(CostModel, numbers, numbers, numbers) | st.just(CostModel()),
)


def _unique(items: st.SearchStrategy[str], low: int = 0, high: int = 4) -> st.SearchStrategy[list[str]]:
    return st.lists(items, min_size=low, max_size=high, unique=True)


@st.composite
def fleets(draw: st.DrawFn) -> Fleet:
    types = []
    for number, name in enumerate(draw(_unique(ids, 1))):
        named = draw(st.booleans())
        robots = [
            Robot(
                id=f"r{number}-{index}",
                position=draw(st.none() | positions),
                remaining=draw(tables),
                zone=draw(maybe_ids),
            )
            for index in range(draw(st.integers(1, 3)) if named else 0)
        ]
        types.append(
            RobotType(
                id=f"t{number}{name}",
                label=draw(texts),
                capabilities=draw(st.dictionaries(ids, capabilities | numbers, max_size=3)),
                limits=draw(tables),
                uses_per_m=draw(tables),
                zones=draw(st.none() | st.lists(ids, max_size=2).map(tuple)),
                count=None if named else draw(st.integers(1, 5)),
                place=None if named else draw(maybe_ids),
                robots=tuple(robots),
            )
        )
    return Fleet(tuple(types), label=draw(texts))


@st.composite
def entities(draw: st.DrawFn, name: str, kind: str) -> Entity:
    corners = draw(st.lists(st.tuples(signed, signed), min_size=3, max_size=5))
    return Entity(
        id=name,
        kind=kind,
        label=draw(texts),
        aliases=tuple(draw(st.lists(texts, max_size=2))),
        position=draw(st.none() | positions),
        last_seen=draw(st.none() | positions),
        search_area=draw(st.none() | st.just(Area(corners=tuple(corners)))),
        mass_kg=draw(st.none() | numbers),
        max_speed_mps=draw(st.none() | positive),
        attributes=draw(st.dictionaries(ids, signed, max_size=2)),
        traits=tuple(draw(st.lists(texts, max_size=2))),
        note=draw(texts),
    )


@st.composite
def scenes(draw: st.DrawFn) -> Scene:
    names = draw(_unique(ids, 0, 5))
    kinds = draw(st.dictionaries(ids.map(lambda name: f"k{name}"), st.sampled_from(["person", "object"]), max_size=2))
    kind = st.sampled_from(["person", "animal", "object", *kinds])
    places = tuple(draw(entities(f"p-{name}", "place")) for name in names[:2])
    others = tuple(draw(entities(f"e-{name}", draw(kind))) for name in names[2:])
    nodes = tuple(RoadNode(id=f"n-{name}", position=Position(draw(signed), draw(signed))) for name in names)
    roads = tuple(Road(ends=(a.id, b.id), one_way=draw(st.booleans())) for a, b in pairwise(nodes))
    area = Area(corners=((0, 0), (1, 0), (0, 1)))
    cells = draw(st.integers(1, 4))
    grid = OccupancyGrid(
        rows=tuple(draw(st.lists(st.text(".#", min_size=cells, max_size=cells), min_size=1))), cell_m=1
    )
    ways: dict[str, Any] = draw(st.sampled_from([{}, {"roads": RoadGraph(nodes=nodes, roads=roads)}, {"grid": grid}]))
    return Scene(
        label=draw(texts),
        kinds=kinds,
        zones=tuple(Zone(id=f"z-{name}", area=draw(st.none() | st.just(area))) for name in names[:1]),
        keep_outs=tuple(KeepOut(id=f"o-{name}", area=area) for name in names[:1]),
        places=places,
        entities=others,
        **ways,
    )


bounds = st.one_of(signed, st.just("agent.mass_kg"))
needs = st.one_of(
    st.builds(Need, capability=ids, at_least=st.none() | signed),
    st.builds(Need, limit=ids, at_least=bounds, share=positive),
    st.builds(Need, limit=ids, at_most=bounds),
)
steps = st.one_of(
    st.builds(
        ActionStep,
        name=ids,
        text=st.sampled_from(["Detect {agent}", "{robot} looks", "Wait"]),
        duration_s=numbers,
        uses=tables,
        at=st.sampled_from([None, "agent"]),
        open_ended=st.booleans(),
    ),
    st.builds(
        ActionStep, name=ids, text=st.just("Go"), goes_to=st.just("agent"), brings=st.just(("agent",)), sync=maybe_ids
    ),
)
roles = st.builds(
    RoleSpec,
    name=ids,
    rating=ids,
    actions=st.lists(steps, min_size=1, max_size=3).map(tuple),
    needs=st.lists(needs, max_size=2).map(tuple),
    robots=st.integers(1, 3),
)
arguments = (Argument(name="agent", kinds=("person", "animal")),)


@st.composite
def routine_files(draw: st.DrawFn) -> RoutineFile:
    routines = []
    for number, name in enumerate(draw(_unique(ids, 1, 3))):
        branches = tuple(
            Branch(name=f"b{index}", roles=(draw(roles),), accepts=draw(st.sampled_from([{}, {"agent": ("person",)}])))
            for index in range(draw(st.integers(0, 2)))
        )
        parts = () if branches else (Part(routine=draw(ids), arguments={"agent": "agent"}), Part(routine="Search"))
        same = draw(st.sampled_from([(), (0, 1)])) if parts else ()
        routines.append(
            Routine(
                id=f"R{number}{name}",
                purpose="Do it to {agent}",
                arguments=arguments,
                verbs=tuple(draw(st.lists(texts, max_size=2))),
                branches=branches,
                parts=parts,
                same_robot=same,
            )
        )
    return RoutineFile(routines=tuple(routines))


@st.composite
def mission_trees(draw: st.DrawFn) -> MissionTree:
    tasks = draw(st.integers(0, 4))
    nodes = []
    for index in range(tasks):
        routine = draw(st.booleans())
        nodes.append(
            MissionNode(
                id=f"n{index}",
                label=draw(texts),
                routine="Search" if routine else None,
                arguments={"agent": "cat"} if routine else {},
                resources=draw(st.sampled_from([None, (), ("scout",)])) if routine else None,
            )
        )
    children = tuple(node.id for node in nodes)
    gates: tuple[Gate, ...] = ("and", "xor")
    gate = draw(st.sampled_from(gates)) if children else None
    root = MissionNode(id="root", label="root", gate=gate, children=children)
    kind = st.sampled_from(LINK_KINDS)
    links = [Link(a, b, draw(kind)) for a, b in pairwise(children)]
    cat = draw(entities("cat", "animal"))
    return MissionTree(objective=draw(texts), nodes=(root, *nodes), links=tuple(links), entities=(cat,))


@st.composite
def grounded_trees(draw: st.DrawFn) -> GroundedTree:
    nodes = [GroundedNode(parent=-1, kind=draw(st.sampled_from(["and", "xor"])), label=draw(texts))]
    for index in range(draw(st.integers(0, 4))):
        action = Action(
            name=draw(ids),
            text=draw(texts),
            role=index,
            robot_type=draw(ids),
            capability=draw(ids),
            estimate=Estimate(draw(numbers), draw(numbers), draw(numbers)),
            duration_s=draw(numbers),
            uses=draw(tables),
            at=draw(maybe_ids),
            moves=draw(st.booleans()),
            sync=draw(st.none() | st.integers(0, 3)),
        )
        nodes.append(GroundedNode(parent=0, kind="action", label=draw(texts), action=action))
    links = tuple(GroundedLink(index, index + 1) for index in range(1, len(nodes) - 1))
    filled = tuple(Role(label=draw(texts), team=draw(st.none() | st.just(1))) for _ in nodes[1:])
    return GroundedTree(objective=draw(texts), nodes=tuple(nodes), roles=filled, links=links)
