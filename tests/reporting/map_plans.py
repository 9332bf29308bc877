"""Plans with a place on the map: small ones by hand, and whole families of scenes."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from hypothesis import strategies as st

from missiontree.mission.alternative import Alternative, Assignment, Ranking, RoleType
from missiontree.mission.area import Area, KeepOut, Zone
from missiontree.mission.brief import MissionBrief
from missiontree.mission.certificate import Certificate
from missiontree.mission.entity import Entity
from missiontree.mission.estimate import Estimate
from missiontree.mission.fleet import Fleet, Robot, RobotType
from missiontree.mission.grounded import Action, GroundedNode, GroundedTree, Grounding, Role
from missiontree.mission.plan import Plan, Provenance
from missiontree.mission.position import Position
from missiontree.mission.scene import Scene
from missiontree.mission.schedule import Schedule, ScheduledAction, TravelLeg
from missiontree.mission.ways import Lift, OccupancyGrid, Road, RoadGraph, RoadNode
from missiontree.routines.library import built_in

SURE = Certificate(claim="proven", method="by_hand")
FLOORS = ("ground", "first", "roof")
NAMES = ("", "a", "the very long name of a place that nobody ever remembers", "母を見つける", "<b>&\"'", "dock 7")


def place(name: str, x_m: float, y_m: float, floor: str = "ground", label: str = "") -> Entity:
    return Entity(id=name, kind="place", position=Position(x_m, y_m, floor=floor), label=label)


def walker(count: int = 1, speed_mps: float | None = 1.0, **others: Any) -> RobotType:
    """A robot that can do everything the built-in routines ask for."""
    able = dict.fromkeys(("search", "reach", "carry", "follow", "message_display"), 1.0)
    limits = {} if speed_mps is None else {"max_speed_mps": speed_mps}
    return RobotType(id="walker", label="Walker", count=count, capabilities=able, limits=limits, **others)


def unplanned(scene: Scene, fleet: Fleet | None = None) -> Plan:
    """A plan of which there is nothing but its inputs."""
    brief = MissionBrief(text="Look around", fleet=fleet or Fleet((walker(),)), routines=built_in(), scene=scene)
    return Plan(outcome="incomplete", brief=brief, provenance=Provenance(author="given"))


class Doing:
    """One action of a robot, with its leg, put into a plan by :func:`by_hand`."""

    def __init__(
        self,
        robot: str,
        start_s: float,
        end_s: float,
        at: str | None = None,
        *,
        moves: bool = False,
        brings: tuple[str, ...] = (),
        finds: str | None = None,
        leg: tuple[float, float, Position, Position, float] | None = None,
        via: tuple[str, ...] = (),
        sync: int | None = None,
    ) -> None:
        self.robot, self.start_s, self.end_s, self.at = robot, start_s, end_s, at
        self.moves, self.brings, self.finds, self.leg, self.via, self.sync = moves, brings, finds, leg, via, sync


def by_hand(scene: Scene, fleet: Fleet, doings: Sequence[Doing]) -> Plan:
    """A delivered plan with one alternative, in which robots do these things; nobody checks that they can."""
    robots = list(dict.fromkeys(doing.robot for doing in doings))
    kinds = {robot: fleet.type_of[robot].id for robot in robots}
    actions = [
        Action(
            name=f"step_{number}",
            text=f"{'Go to' if doing.moves else 'Work at'} {doing.at or 'hand'}",
            role=robots.index(doing.robot),
            robot_type=kinds[doing.robot],
            capability="reach",
            estimate=Estimate(quality=1.0),
            at=doing.at,
            moves=doing.moves,
            brings=doing.brings,
            finds=doing.finds,
            sync=doing.sync,
        )
        for number, doing in enumerate(doings)
    ]
    nodes = [GroundedNode(parent=-1, kind="and", label="All")]
    nodes += [GroundedNode(parent=0, kind="action", label=action.text, action=action) for action in actions]
    tree = GroundedTree(objective="All", nodes=tuple(nodes), roles=tuple(Role(label=robot) for robot in robots))
    legs = [
        TravelLeg(
            robot=doing.robot,
            leaf=number,
            start_s=doing.leg[0],
            end_s=doing.leg[1],
            origin=doing.leg[2],
            destination=doing.leg[3],
            distance_m=doing.leg[4],
            via=doing.via,
        )
        for number, doing in enumerate(doings, start=1)
        if doing.leg is not None
    ]
    scheduled = [
        ScheduledAction(leaf=number, robot=doing.robot, start_s=doing.start_s, end_s=doing.end_s)
        for number, doing in enumerate(doings, start=1)
    ]
    schedule = Schedule(
        rank=1,
        status="feasible",
        certificate=SURE,
        assignments=tuple(Assignment(role, robot) for role, robot in enumerate(robots)),
        actions=tuple(sorted(scheduled, key=lambda one: (one.start_s, one.leaf))),
        legs=tuple(sorted(legs, key=lambda leg: (leg.start_s, leg.leaf))),
        makespan_s=max((doing.end_s for doing in doings), default=0.0),
    )
    alternative = Alternative(
        rank=1,
        utility=1.0,
        choices=(),
        roles=tuple(RoleType(role, kinds[robot]) for role, robot in enumerate(robots)),
        certificate=SURE,
    )
    return Plan(
        outcome="delivered",
        brief=MissionBrief(text="All", fleet=fleet, routines=built_in(), scene=scene),
        grounding=Grounding(tree=tree),
        ranking=Ranking(alternatives=(alternative,), status="exact", certificate=SURE),
        schedules=(schedule,),
        provenance=Provenance(author="given"),
    )


def metres(most: float = 60.0) -> st.SearchStrategy[float]:
    """Coordinates; often equal, so that things stand at one point or in one line."""
    return st.one_of(st.sampled_from((0.0, most / 2, most)), st.floats(0.0, most).map(lambda x: round(x, 2)))


@st.composite
def scenes(draw: st.DrawFn, most: int = 14) -> Scene:
    """Scenes with places, people and things, some of them missing; areas; roads with lifts, or a grid, or neither."""
    scale = draw(st.sampled_from((0.05, 1.0, 300.0)))
    floors = draw(st.sampled_from((FLOORS[:1], FLOORS[:2], FLOORS)))

    def spot(floor: str) -> Position:
        return Position(draw(metres()) * scale, draw(metres()) * scale, floor=floor)

    def area(floor: str) -> Area:
        x, y = draw(metres()) * scale, draw(metres()) * scale
        width, height = draw(st.floats(1.0, 40.0)) * scale, draw(st.floats(1.0, 40.0)) * scale
        return Area(corners=((x, y), (x + width, y), (x + width, y + height), (x, y + height)), floor=floor)

    places = [
        Entity(
            id=f"p{number}",
            kind="place",
            position=spot(floors[number % len(floors)]),
            label=draw(st.sampled_from(NAMES)),
        )
        for number in range(draw(st.integers(0, most)))
    ]
    entities = []
    for number in range(draw(st.integers(0, 6))):
        kind, known = draw(st.sampled_from(("person", "animal", "object"))), draw(st.integers(0, 4))
        where: dict[str, Any] = {}
        if known == 1:
            where["position"] = spot(floors[0])
        elif known == 2 and places:
            where["place"] = draw(st.sampled_from(places)).id
        elif known == 3:
            where["last_seen"] = spot(floors[-1])
        elif known == 4:
            where["search_area"] = area(floors[0])
        entities.append(Entity(id=f"e{number}", kind=kind, label=draw(st.sampled_from(NAMES)), **where))
    form = draw(st.sampled_from(("plain", "roads", "grid")))
    roads = _roads(draw, places, spot(floors[0])) if form == "roads" else None
    grid = None
    if form == "grid":
        rows = draw(st.lists(st.text(".#", min_size=6, max_size=6), min_size=2, max_size=6))
        grid = OccupancyGrid(rows=tuple(rows), cell_m=8.0 * scale, floor=floors[0])
    return Scene(
        label=draw(st.sampled_from(NAMES)),
        places=tuple(places),
        entities=tuple(entities),
        zones=tuple(Zone(id=f"z{number}", area=area(floors[0])) for number in range(draw(st.integers(0, 2)))),
        keep_outs=tuple(KeepOut(id=f"k{number}", area=area(floors[0])) for number in range(draw(st.integers(0, 2)))),
        roads=roads,
        grid=grid,
    )


def _roads(draw: st.DrawFn, places: Sequence[Entity], middle: Position) -> RoadGraph:
    roads: list[Road] = []
    lifts: list[Lift] = []
    names = [entity.id for entity in places]
    floor_of = {entity.id: entity.position.floor for entity in places if entity.position is not None}
    for _ in range(draw(st.integers(0, 8)) if names else 0):
        ends = (draw(st.sampled_from(names)), draw(st.sampled_from(names)))
        if floor_of[ends[0]] == floor_of[ends[1]]:
            roads.append(Road(ends=ends, one_way=draw(st.booleans()), blocked=draw(st.booleans())))
        elif not lifts:
            lifts.append(Lift(id="lift", stops=ends, ride_s=5.0))
    return RoadGraph(nodes=(RoadNode(id="node", position=middle),), roads=tuple(roads), lifts=tuple(lifts))


@st.composite
def moving_plans(draw: st.DrawFn) -> Plan:
    """Plans in which up to four robots go from place to place, straight."""
    scene = draw(scenes())
    spots = [entity.position for entity in scene.places if entity.position is not None]
    robots = tuple(
        Robot(id=f"r{number}", position=draw(st.sampled_from([None, *spots])))
        for number in range(draw(st.integers(1, 4)))
    )
    able = {"reach": 1.0}
    fleet = Fleet((RobotType(id="rover", capabilities=able, limits={"max_speed_mps": 1.0}, robots=robots),))
    doings = []
    for robot in robots:
        here, time_s = robot.position, 0.0
        for _ in range(draw(st.integers(0, 4)) if scene.places else 0):
            goal = draw(st.sampled_from(scene.places))
            assert goal.position is not None
            apart = draw(st.floats(0.0, 30.0))
            leg = None if here is None else (time_s, time_s + apart, here, goal.position, apart)
            doings.append(Doing(robot.id, time_s, time_s + apart, goal.id, moves=True, leg=leg))
            here, time_s = goal.position, time_s + apart
    return by_hand(scene, fleet, doings) if doings else unplanned(scene, fleet)
