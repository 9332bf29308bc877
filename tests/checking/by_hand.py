"""Plans written down by hand, for the checkers: robots that start at the origin, two places and a box at one of them."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from missiontree.checking import check
from missiontree.formats.inputs import input_digests
from missiontree.mission.alternative import Alternative, Assignment, Ranking, RoleType
from missiontree.mission.brief import MissionBrief
from missiontree.mission.certificate import Certificate
from missiontree.mission.entity import Entity
from missiontree.mission.fleet import Fleet, RobotType
from missiontree.mission.grounded import GroundedTree, Grounding
from missiontree.mission.limit_use import LimitUse
from missiontree.mission.plan import Plan, Provenance
from missiontree.mission.position import Position
from missiontree.mission.reason import Reason
from missiontree.mission.scene import Scene
from missiontree.mission.schedule import OwnLeg, Schedule, ScheduledAction, TravelLeg
from missiontree.routines.library import built_in

PROVEN = Certificate(claim="proven", method="enumeration")
BOUNDED = Certificate(claim="bounded", method="critical_path", bound=0.0)
HERE, THERE, FAR = Position(0, 0), Position(10, 0), Position(10, 20)
SCENE = Scene(
    places=(Entity(id="there", kind="place", position=THERE), Entity(id="far", kind="place", position=FAR)),
    entities=(Entity(id="box", position=THERE, max_speed_mps=1.0),),
)


def team(count: int = 2, **changes: Any) -> Fleet:
    """Robots r-1, r-2, ... at the origin, 2 m/s."""
    fields: dict[str, Any] = {
        "capabilities": {"any": 1.0},
        "limits": {"max_speed_mps": 2.0},
        "position": HERE,
        **changes,
    }
    return Fleet((RobotType(id="r", count=count, **fields),))


def times(*spans: tuple[int, str, float, float]) -> tuple[ScheduledAction, ...]:
    """Scheduled actions from (leaf, robot, start, end)."""
    made = (ScheduledAction(leaf=leaf, robot=robot, start_s=start, end_s=end) for leaf, robot, start, end in spans)
    return tuple(sorted(made, key=lambda done: (done.start_s, done.leaf)))


def leg(
    leaf: int, start_s: float, end_s: float, origin: Position, goal: Position, metres: float, robot: str = "r-1"
) -> TravelLeg:
    return TravelLeg(
        robot=robot, leaf=leaf, start_s=start_s, end_s=end_s, origin=origin, destination=goal, distance_m=metres
    )


def plan_of(
    tree: GroundedTree,
    actions: tuple[ScheduledAction, ...],
    *legs: TravelLeg,
    fleet: Fleet | None = None,
    scene: Scene | None = None,
    uses: tuple[LimitUse, ...] = (),
    returns: tuple[OwnLeg, ...] | None = None,
) -> Plan:
    """A plan of a tree without choices, whose roles go to the robots that the actions name. With ``returns``, robots are to go home."""
    brief = MissionBrief(
        text="By hand", fleet=fleet or team(), routines=built_in(), scene=scene, return_home=returns is not None
    )
    utility = sum(node.action.estimate.quality for node in tree.nodes if node.action is not None)
    robots = {tree.action(done.leaf).role: done.robot for done in actions}
    alternative = Alternative(
        rank=1,
        utility=utility,
        choices=(),
        roles=tuple(RoleType(role, "r") for role in sorted(robots)),
        uses=uses,
        certificate=PROVEN,
    )
    schedule = Schedule(
        rank=1,
        status="feasible",
        certificate=BOUNDED,
        assignments=tuple(Assignment(role, robots[role]) for role in sorted(robots)),
        actions=actions,
        legs=legs,
        returns=returns or (),
        makespan_s=max([*(done.end_s for done in actions), *(home.end_s for home in returns or ())]),
    )
    return Plan(
        outcome="delivered",
        brief=brief,
        grounding=Grounding(tree=tree),
        ranking=Ranking(alternatives=(alternative,), status="exact", certificate=PROVEN),
        schedules=(schedule,),
        digests=input_digests(brief, None),
        provenance=Provenance(author="given"),
    )


def guessing(plan: Plan, *names: str) -> Plan:
    """The plan with an assumption about each robot or type, in its schedule and in its own list."""
    said = tuple(
        Reason(rule="unknown", message=f"Something of {name} is not known.", severity="assumption", robot=name)
        for name in names
    )
    schedules = tuple(replace(schedule, assumptions=said) for schedule in plan.schedules)
    return replace(plan, schedules=schedules, assumptions=said)


def only(plan: Plan) -> Reason:
    """The one finding."""
    findings = check(plan)
    assert len(findings) == 1, [finding.rule for finding in findings]
    return findings[0]


def rules(plan: Plan) -> list[str]:
    return [finding.rule for finding in check(plan)]


def by_start(*legs: TravelLeg) -> list[TravelLeg]:
    return sorted(legs, key=lambda one: (one.start_s, one.leaf, one.robot))
