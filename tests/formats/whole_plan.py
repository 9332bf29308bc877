"""A plan with every part a plan can have, put together by hand; its numbers need not make sense, only survive."""

from __future__ import annotations

from missiontree.mission.alternative import Alternative, Assignment, Choice, Ranking, RoleType
from missiontree.mission.area import Zone
from missiontree.mission.brief import MissionBrief
from missiontree.mission.certificate import Certificate
from missiontree.mission.entity import Entity
from missiontree.mission.estimate import Estimate, Weights
from missiontree.mission.estimator_source import Estimated, EstimatorSource
from missiontree.mission.fleet import Capability, CostModel, Fleet, Robot, RobotType
from missiontree.mission.grounded import Action, GroundedLink, GroundedNode, GroundedTree, Grounding, Role
from missiontree.mission.limit_use import LimitUse
from missiontree.mission.plan import Plan, Provenance
from missiontree.mission.position import Position
from missiontree.mission.reason import Reason
from missiontree.mission.routine import ActionStep, Argument, Branch, Need, RoleSpec, Routine, RoutineLibrary
from missiontree.mission.scene import Scene
from missiontree.mission.schedule import Schedule, ScheduledAction, TravelLeg
from missiontree.mission.search_limit import SearchLimit
from missiontree.mission.tree import Link, MissionNode, MissionTree
from missiontree.mission.ways import Lift, Road, RoadGraph, RoadNode


def _fleet() -> Fleet:
    scout = RobotType(
        id="scout",
        capabilities={"search": 1, "carry": Capability(0.25, cost=CostModel(per_m=2.5))},
        limits={"max_speed_mps": 1.5, "energy_j": 5000},
        robots=(Robot(id="ada", place="hall", remaining={"energy_j": 40}), Robot(id="bob", zone="west")),
    )
    return Fleet((scout, RobotType(id="cart", label="Cart 🛒", count=2, position=Position(0, 1.25))), label="Team")


def _scene() -> Scene:
    nodes = (RoadNode(id="a", position=Position(0, 0)), RoadNode(id="b", position=Position(0, 0, floor="first")))
    return Scene(
        kinds={"cat": "animal"},
        zones=(Zone(id="west"),),
        places=(Entity(id="hall", position=Position(3, 4)), Entity(id="yard", kind="place", zone="west")),
        entities=(Entity(id="tom", kind="cat", mass_kg=4, traits=("red",), last_seen=Position(1, 1)),),
        roads=RoadGraph(
            nodes=nodes, roads=(Road(ends=("a", "hall")),), lifts=(Lift(id="lift", stops=("a", "b"), ride_s=20),)
        ),
    )


def _routines() -> RoutineLibrary:
    step = ActionStep(name="look", text="Look for {agent}", uses={"energy_j": 1}, finds="agent")
    need = Need(limit="payload_kg", at_least="agent.mass_kg", share=0.5)
    role = RoleSpec(name="searcher", rating="search", actions=(step,), needs=(need,))
    search = Routine(
        id="Search",
        purpose="Find {agent}",
        arguments=(Argument(name="agent", kinds=("animal",)),),
        branches=(Branch(name="look", roles=(role,), accepts={"agent": ("cat",)}),),
    )
    return RoutineLibrary(routines=(search,))


def _reason(severity: str) -> Reason:
    return Reason(rule="made_up", message="It's so.", severity=severity, node="x", found="4", needed="12")  # type: ignore[arg-type]


def _tree() -> MissionTree:
    nodes = (
        MissionNode(id="root", label='Find "Tom"', gate="and", children=("one", "two")),
        MissionNode(id="one", label="One", routine="Search", arguments={"agent": "tom"}, resources=("scout",)),
        MissionNode(id="two", label="Two", routine="Search", arguments={"agent": "rex"}),
    )
    return MissionTree(
        objective='Find "Tom"', nodes=nodes, links=(Link("one", "two"),), entities=(Entity(id="rex", kind="animal"),)
    )


def _grounded() -> GroundedTree:
    action = Action(
        name="look",
        text="Look for Tom",
        role=0,
        robot_type="scout",
        capability="search",
        estimate=Estimate(1, 2.5),
        uses={"energy_j": 1},
    )
    nodes = (
        GroundedNode(parent=-1, kind="and", label="root", source="root"),
        GroundedNode(parent=0, kind="xor", label="One", source="one"),
        GroundedNode(parent=1, kind="action", label="look", action=action),
        GroundedNode(parent=0, kind="xor", label="Two"),
    )
    return GroundedTree(
        objective="Find",
        nodes=nodes,
        roles=(Role(label="searcher", team=0),),
        links=(GroundedLink(1, 3, "same_robot"),),
    )


def whole_plan() -> Plan:
    """The plan."""
    proven = Certificate(claim="proven", method="lazy_k_best", bound=1.0)
    best = Alternative(
        rank=1,
        utility=1.0,
        choices=(Choice(1, 2),),
        roles=(RoleType(0, "scout"),),
        witness=(Assignment(0, "ada"),),
        uses=(LimitUse("robot", "ada", "energy_j", 3.0, 4.5),),
        certificate=proven,
    )
    leg = TravelLeg(
        robot="ada",
        leaf=2,
        start_s=0,
        end_s=2.001,
        origin=Position(0, 0),
        destination=Position(3, 4),
        distance_m=5,
        via=("a",),
    )
    schedule = Schedule(
        rank=1,
        status="feasible",
        certificate=Certificate(
            claim="bounded", method="critical_path", bound=2.0, limit=SearchLimit("time_s", 2.5), seed=3
        ),
        assignments=(Assignment(0, "ada"),),
        actions=(ScheduledAction(leaf=2, robot="ada", start_s=2.001, end_s=4.501),),
        legs=(leg,),
        makespan_s=4.501,
        assumptions=(_reason("assumption"),),
    )
    return Plan(
        outcome="delivered",
        brief=MissionBrief(
            text="Find\n“Tom”",
            fleet=_fleet(),
            routines=_routines(),
            scene=_scene(),
            weights=Weights(1, 0.125),
            check_kinds=False,
            estimator=EstimatorSource(name="mine.py", digest="0" * 64),
        ),
        tree=_tree(),
        grounding=Grounding(
            tree=_grounded(),
            not_offered=(_reason("error"),),
            notices=(_reason("notice"),),
            estimates=(
                Estimated(robot_type="scout", action="look", rating="search", estimate=Estimate(1, 2.5)),
                Estimated(
                    robot_type="scout",
                    action="go",
                    rating="search",
                    at="hall",
                    nominal_s=0.0,
                    nominal_cost=0.1,
                    travel_m=3.25,
                    travel_s=1e-3,
                    estimate=Estimate(0.1, 0.2, 0.3),
                ),
            ),
        ),
        ranking=Ranking(alternatives=(best,), status="exact", certificate=proven, examined=3),
        schedules=(schedule,),
        findings=(_reason("warning"),),
        digests={"fleet": "0" * 64},
        provenance=Provenance(
            author="offline", transcript=('{"a":"\\u001b"}',), versions={"missiontree": "0.1.0"}, seed=7
        ),
    )
