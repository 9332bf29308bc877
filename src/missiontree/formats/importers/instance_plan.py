"""A schedule of an instance from elsewhere as a plan, so that whatever shows plans shows it, too: chart, timeline, critical chain."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from math import hypot

from missiontree.formats.importers.coalition_grounded import START, coalition_fleet, coalition_scene, coalition_tree
from missiontree.formats.importers.tree_grounded import DOES, grounded_of
from missiontree.mission.alternative import Alternative, Assignment, Choice, Ranking, RoleType
from missiontree.mission.brief import MissionBrief
from missiontree.mission.certificate import Certificate
from missiontree.mission.coalitions import TICKS_PER_S, CoalitionMission, CoalitionSchedule, Visit
from missiontree.mission.columns import TreeColumns
from missiontree.mission.fleet import Fleet, Robot, RobotType
from missiontree.mission.grounded import GroundedTree, Grounding
from missiontree.mission.plan import Plan, Provenance
from missiontree.mission.position import Position
from missiontree.mission.routine import RoutineLibrary
from missiontree.mission.scene import Scene
from missiontree.mission.schedule import Schedule, ScheduledAction, ScheduleStatus, TravelLeg
from missiontree.mission.tree_schedule import TreeSchedule

_UNRANKED = Certificate(claim="unproven", method="enumeration", detail="Instances are scheduled, not ranked.")


def plan_of_tree(columns: TreeColumns, schedule: TreeSchedule, title: str) -> Plan:
    """
    A schedule of a tree in columns as a plan; single robots keep their names, equal ones are numbered from 1.

    Parameters
    ----------
    columns, schedule
        The tree, and a schedule with actions.
    title
        What the mission is called.
    """
    tree = grounded_of(columns)
    actions = []
    for leaf, start in sorted(schedule.start_s.items(), key=lambda one: (one[1], one[0])):
        robot = columns.robot_id(columns.robot[leaf])
        name = robot if columns.count is None else f"{robot[:56]}-{schedule.robot[leaf] + 1}"
        end = start + columns.duration[leaf]
        actions.append(ScheduledAction(leaf=leaf, robot=name, start_s=float(start), end_s=float(end)))
    return _plan(title, _columns_fleet(columns), Scene(), tree, schedule.chosen, actions, [], schedule)


def _columns_fleet(columns: TreeColumns) -> Fleet:
    kinds = []
    for number in range(columns.robots):
        name = columns.robot_id(number)
        if columns.count is None:
            kinds.append(RobotType(id=name, capabilities={DOES: 1.0}, robots=(Robot(id=name),)))
        else:
            kinds.append(RobotType(id=name, capabilities={DOES: 1.0}, count=columns.count[number]))
    return Fleet(tuple(kinds))


def plan_of_coalitions(mission: CoalitionMission, schedule: CoalitionSchedule, title: str) -> Plan:
    """
    A schedule of coalitions as a plan. Everybody leaves for the next place at once, and waits there.

    Parameters
    ----------
    mission, schedule
        The mission, and a schedule with visits.
    title
        What it is called.
    """
    tree = coalition_tree(mission)
    chosen, actions, legs = dict[int, int](), list[ScheduledAction](), list[TravelLeg]()
    leaf_of: dict[tuple[int, int], int] = {}
    for visit in schedule.visits:
        xor = tree.children[0][visit.task]
        for coalition in tree.children[xor]:
            leaves = {_robot_of(tree, leaf): leaf for leaf in tree.children[coalition]}
            if leaves.keys() == set(visit.robots):
                chosen[xor] = coalition
                leaf_of |= {(visit.task, robot): leaf for robot, leaf in leaves.items()}
    for robot, arrival_s in enumerate(schedule.arrivals_s):
        own = sorted((one for one in schedule.visits if robot in one.robots), key=lambda one: (one.start_s, one.end_s))
        actions += [
            ScheduledAction(leaf=leaf_of[one.task, robot], robot=_name(robot), start_s=one.start_s, end_s=one.end_s)
            for one in own
        ]
        home = tree.children[0][len(mission.tasks) + robot]
        ways = list(_ways(mission, robot, own, leaf_of, home))
        legs += ways
        actions.append(ScheduledAction(leaf=home, robot=_name(robot), start_s=ways[-1].start_s, end_s=arrival_s))
    named = Fleet(
        tuple(
            replace(kind, count=None, place=None, robots=(Robot(id=kind.id, place=START),))
            for kind in coalition_fleet(mission).types
        )
    )
    order = sorted(actions, key=lambda one: (one.start_s, one.leaf))
    trips = sorted(legs, key=lambda leg: (leg.start_s, leg.leaf, leg.robot))
    return _plan(title, named, coalition_scene(mission), tree, chosen, order, trips, schedule)


def _robot_of(tree: GroundedTree, leaf: int) -> int:
    return int(tree.action(leaf).robot_type.removeprefix("robot-"))


def _name(robot: int) -> str:
    return f"robot-{robot}"


def _ways(
    mission: CoalitionMission, robot: int, own: list[Visit], leaf_of: dict[tuple[int, int], int], home: int
) -> Iterator[TravelLeg]:
    """The ways of a robot, the last one to the end."""
    spots = [(task.x_m, task.y_m) for task in mission.tasks] + [mission.start, mission.end]
    here, free_s = len(mission.tasks), 0.0
    stops = [(one.task, leaf_of[one.task, robot], one.end_s) for one in own]
    for there, leaf, until_s in [*stops, (len(mission.tasks) + 1, home, 0.0)]:
        lasts_s = mission.travel[here][there] / TICKS_PER_S
        length = hypot(spots[there][0] - spots[here][0], spots[there][1] - spots[here][1])
        if length or leaf == home:
            yield TravelLeg(
                robot=_name(robot),
                leaf=leaf,
                start_s=free_s,
                end_s=round(free_s + lasts_s, 3),
                origin=Position(*spots[here]),
                destination=Position(*spots[there]),
                distance_m=length,
            )
        here, free_s = there, until_s


def _plan(
    title: str,
    fleet: Fleet,
    scene: Scene,
    tree: GroundedTree,
    chosen: Mapping[int, int],
    actions: list[ScheduledAction],
    legs: list[TravelLeg],
    told: TreeSchedule | CoalitionSchedule,
) -> Plan:
    roles = {tree.action(one.leaf).role: one.robot for one in actions}
    types = {tree.action(one.leaf).role: tree.action(one.leaf).robot_type for one in actions}
    alternative = Alternative(
        rank=1,
        utility=0.0,
        choices=tuple(Choice(xor, child) for xor, child in sorted(chosen.items())),
        roles=tuple(RoleType(role, kind) for role, kind in sorted(types.items())),
        certificate=_UNRANKED,
    )
    status: ScheduleStatus = told.status
    schedule = Schedule(
        rank=1,
        status=status,
        certificate=told.certificate,
        assignments=tuple(Assignment(role, robot) for role, robot in sorted(roles.items())),
        actions=tuple(actions),
        legs=tuple(legs),
        makespan_s=float(told.makespan_s),
    )
    return Plan(
        outcome="delivered",
        brief=MissionBrief(text=title, fleet=fleet, routines=RoutineLibrary(routines=()), scene=scene),
        grounding=Grounding(tree=tree),
        ranking=Ranking(alternatives=(alternative,), status="partial", certificate=_UNRANKED),
        schedules=(schedule,),
        provenance=Provenance(author="given"),
    )
