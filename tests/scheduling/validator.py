"""A plain validator of schedules on an open plane. It replays the schedule by the clock and shares nothing with the scheduler."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator

from missiontree.mission.alternative import selected_leaves, selected_nodes
from missiontree.mission.fleet import Fleet
from missiontree.mission.grounded import Action
from missiontree.mission.position import Position
from missiontree.mission.scene import Scene
from missiontree.mission.schedule import Schedule, ScheduledAction, TravelLeg
from tests.scheduling.instances import Instance

EPS = 1e-6
TICK = 0.001 + EPS


class Replay:
    """One schedule against its instance, fleet and scene; ``faults`` lists the rules that are broken."""

    def __init__(self, instance: Instance, fleet: Fleet, world: Scene, result: Schedule) -> None:
        self.tree, self.fleet, self.world, self.result = instance.tree, fleet, world, result
        self.leaves = selected_leaves(instance.tree, instance.alternative.choices)
        self.selected = set(selected_nodes(instance.tree, instance.alternative.choices))
        self.at = {one.leaf: one for one in result.actions}
        self.leg = {(leg.leaf, leg.robot): leg for leg in result.legs}
        self.robot = {one.role: one.robot for one in result.assignments}

    def action(self, leaf: int) -> Action:
        return self.tree.action(leaf)

    def faults(self) -> list[str]:
        if sorted(self.at) != sorted(self.leaves) or len(self.result.actions) != len(self.leaves):
            return ["the scheduled actions are not the selected ones"]
        found = [
            *self.staffing(),
            *self.holding(),
            *self.links(),
            *self.durations(),
            *self.travel(),
            *self.budgets(),
            *self.timely(),
        ]
        if [(o.start_s, o.leaf) for o in self.result.actions] != sorted(
            (o.start_s, o.leaf) for o in self.result.actions
        ):
            found.append("actions are not sorted")
        if [(g.start_s, g.leaf, g.robot) for g in self.result.legs] != sorted(
            (g.start_s, g.leaf, g.robot) for g in self.result.legs
        ):
            found.append("legs are not sorted")
        if abs(self.result.makespan_s - max(one.end_s for one in self.result.actions)) > EPS:
            found.append("the makespan is not the last end")
        return found

    def timely(self) -> Iterator[str]:
        """Release times and deadlines, node by node; and robots while they are there."""
        spans = [(one.robot, one.start_s, one.end_s) for one in self.result.actions]
        for robot, start_s, end_s in [*spans, *((leg.robot, leg.start_s, leg.end_s) for leg in self.result.legs)]:
            since_s, until_s = self.fleet.type_of[robot].availability(self.fleet.robots[robot])
            if start_s < since_s - EPS or (until_s is not None and end_s > until_s + EPS):
                yield f"{robot} is not there from {start_s} to {end_s}"
        for index, node in enumerate(self.tree.nodes):
            for leaf in self.below(index) if node.release_s or node.deadline_s is not None else ():
                if self.at[leaf].start_s < node.release_s - EPS:
                    yield f"{leaf} starts before the release time of {index}"
                if node.deadline_s is not None and self.at[leaf].end_s > node.deadline_s + EPS:
                    yield f"{leaf} ends after the deadline of {index}"

    def below(self, node: int) -> list[int]:
        found = []
        for leaf in self.leaves:
            above = leaf
            while above not in (node, -1):
                above = self.tree.nodes[above].parent
            if above == node:
                found.append(leaf)
        return found

    def staffing(self) -> Iterator[str]:
        teams: dict[tuple[int, str], int] = {}
        joint: set[tuple[int | None, str]] = set()
        for leaf in self.leaves:
            one, action = self.at[leaf], self.action(leaf)
            if action.sync is not None and (action.sync, one.robot) in joint:
                yield f"{one.robot} works jointly with itself"
            joint.add((action.sync, one.robot))
            if self.robot.get(action.role) != one.robot:
                yield f"{leaf} is not done by its role's robot"
            if self.fleet.type_of[one.robot].id != action.robot_type:
                yield f"{leaf} is done by another type"
        for role, robot in self.robot.items():
            team = self.tree.roles[role].team
            if team is not None and teams.setdefault((team, robot), role) != role:
                yield f"team {team} has {robot} twice"

    def holding(self) -> Iterator[str]:
        holds: dict[str, list[tuple[float, float, int]]] = {}
        for role, robot in self.robot.items():
            mine = [self.at[leaf] for leaf in self.leaves if self.action(leaf).role == role]
            for before, after in itertools.pairwise(mine):
                if before.end_s > after.start_s + EPS:
                    yield f"role {role} is not in order"
            holds.setdefault(robot, []).append((mine[0].start_s, mine[-1].end_s, role))
        for robot, intervals in holds.items():
            for index, first in enumerate(intervals):
                for second in intervals[index + 1 :]:
                    if first[1] > second[0] + EPS and second[1] > first[0] + EPS:
                        yield f"{robot} is in roles {first[2]} and {second[2]} at once"

    def links(self) -> Iterator[str]:
        joint: dict[int, set[tuple[float, float]]] = {}
        for leaf in self.leaves:
            sync = self.action(leaf).sync
            if sync is not None:
                joint.setdefault(sync, set()).add((self.at[leaf].start_s, self.at[leaf].end_s))
        yield from (f"joint work {sync} is apart" for sync, spans in joint.items() if len(spans) > 1)
        for link in self.tree.links:
            first, second = self.below(link.first), self.below(link.second)
            if link.first not in self.selected or link.second not in self.selected or not first or not second:
                continue
            who = [{self.at[leaf].robot for leaf in side} for side in (first, second)]
            if (
                link.kind == "precedence"
                and max(self.at[a].end_s for a in first) > min(self.at[b].start_s for b in second) + EPS
            ):
                yield f"{link.first} does not end before {link.second}"
            if link.kind == "same_robot" and len(who[0] | who[1]) > 1:
                yield f"{link.first} and {link.second} have several robots"
            if link.kind == "different_robot" and who[0] & who[1]:
                yield f"{link.first} and {link.second} share a robot"

    def until(self, leaf: int) -> float | None:
        """When an open-ended action ends because others do; None if it does not."""
        if not self.action(leaf).open_ended:
            return None
        ends = [
            max(self.at[other].end_s for other in self.below(link.second))
            for link in self.tree.links
            if link.kind == "until" and link.first in self.selected and link.second in self.selected
            if leaf in self.below(link.first)
        ]
        return max([self.at[leaf].start_s, *ends]) if ends else None

    def durations(self) -> Iterator[str]:
        longest: dict[object, float] = {}
        for leaf in self.leaves:
            action, one = self.action(leaf), self.at[leaf]
            key = ("alone", leaf) if action.sync is None else action.sync
            own = action.duration_s
            if action.moves:
                own = self.move_time(leaf)
            end = self.until(leaf)
            if end is not None and one.start_s > end - 0.001 + EPS:
                yield f"{leaf} is not under way when what it lasts for ends"
            if end is not None:
                own = end - one.start_s
            longest[key] = max(longest.get(key, 0.0), own)
        for leaf in self.leaves:
            action, one = self.action(leaf), self.at[leaf]
            wanted = longest[("alone", leaf) if action.sync is None else action.sync]
            if abs(one.end_s - one.start_s - wanted) > TICK:
                yield f"{leaf} takes {one.end_s - one.start_s}, not {wanted}"

    def move_time(self, leaf: int) -> float:
        action, one = self.action(leaf), self.at[leaf]
        speed = self.fleet.by_id[action.robot_type].limits.get("max_speed_mps")
        origin, goal = self.robot_spot(one), self.entity_spot(action.at, one)
        if speed is None or origin is None or goal is None:
            return action.duration_s
        caps = [self.world.by_id[name].max_speed_mps for name in action.brings]
        return distance(origin, goal) / min([speed, *(cap for cap in caps if cap is not None)])

    def timeline(self, robot: str) -> list[ScheduledAction]:
        """What a robot does, in order; roles one after the other."""
        first: dict[int, tuple[float, float, int]] = {}
        for leaf in self.leaves:
            one, role = self.at[leaf], self.action(leaf).role
            if one.robot == robot:
                known = first.get(role)
                first[role] = (one.start_s, one.end_s, leaf) if known is None else (known[0], one.end_s, known[2])
        roles = sorted(first, key=lambda role: first[role])
        return [self.at[leaf] for role in roles for leaf in self.leaves if self.action(leaf).role == role]

    def robot_spot(self, one: ScheduledAction) -> Position | None:
        """Where the robot is before an action."""
        robot = self.fleet.robots[one.robot]
        spot = robot.position
        for earlier in self.timeline(one.robot):
            if earlier.leaf == one.leaf:
                return spot
            action = self.action(earlier.leaf)
            if action.moves or action.at is not None:
                spot = self.entity_spot(action.at, earlier)
        raise AssertionError("an action is not in its robot's timeline")

    def entity_spot(self, name: str | None, one: ScheduledAction) -> Position | None:
        """Where an entity is when an action starts: where the last move that ended before took it."""
        if name is None:
            return None
        moves = [self.at[leaf] for leaf in self.leaves if name in self.action(leaf).brings and leaf != one.leaf]
        over = [move for move in moves if move.end_s <= one.start_s + EPS]
        if not over:
            return self.world.by_id[name].position
        last = max(over, key=lambda move: (move.end_s, move.start_s))
        return self.entity_spot(self.action(last.leaf).at, last)

    def travel(self) -> Iterator[str]:
        for robot in sorted(set(self.robot.values())):
            free = 0.0
            for one in self.timeline(robot):
                action = self.action(one.leaf)
                goal, origin = self.entity_spot(action.at, one), self.robot_spot(one)
                leg = self.leg.get((one.leaf, robot))
                speed = self.fleet.type_of[robot].limits.get("max_speed_mps")
                yield from self.moved_meanwhile(one, action)
                if goal is not None and origin is not None and distance(origin, goal) > EPS:
                    yield from leg_faults(leg, one, action, origin, goal, speed, free)
                elif leg is not None and leg.distance_m > EPS:
                    yield f"{one.leaf} has a leg it does not need"
                free = one.end_s

    def moved_meanwhile(self, one: ScheduledAction, action: Action) -> Iterator[str]:
        """Whoever brings an entity has it alone; only joint work brings it together."""
        for leaf in self.leaves:
            other = self.at[leaf]
            if leaf == one.leaf or (action.sync is not None and self.action(leaf).sync == action.sync):
                continue
            if set(self.action(leaf).brings) & {*action.brings, action.at}:
                overlap = other.start_s < one.end_s - EPS and one.start_s < other.end_s - EPS
                if overlap and not (action.open_ended and other.start_s >= one.start_s - EPS):
                    yield f"{leaf} moves what {one.leaf} uses meanwhile"

    def budgets(self) -> Iterator[str]:
        spent: dict[tuple[str, str], float] = {}
        for one in self.result.actions:
            kind = self.fleet.type_of[one.robot]
            leg = self.leg.get((one.leaf, one.robot))
            use = dict(self.action(one.leaf).uses)
            for name, amount in kind.uses_per_m.items():
                use[name] = use.get(name, 0.0) + amount * (leg.distance_m if leg is not None else 0.0)
            for name, amount in use.items():
                for whose in (one.robot, kind.id):
                    spent[whose, name] = spent.get((whose, name), 0.0) + amount
        for (whose, name), amount in spent.items():
            if whose in self.fleet.by_id:
                limit = self.fleet.by_id[whose].total_limits.get(name)
            else:
                limit = self.fleet.type_of[whose].budget(self.fleet.robots[whose], name)
            if limit is not None and amount > limit + EPS:
                yield f"{whose} uses {amount} of {name}, it has {limit}"


def leg_faults(
    leg: TravelLeg | None,
    one: ScheduledAction,
    action: Action,
    origin: Position,
    goal: Position,
    speed: float | None,
    free: float,
) -> Iterator[str]:
    if leg is None:
        yield f"{one.leaf} has no leg"
        return
    if leg.origin != origin or leg.destination != goal or abs(leg.distance_m - distance(origin, goal)) > EPS:
        yield f"{one.leaf} has a leg from or to elsewhere"
    if leg.start_s < free - EPS:
        yield f"{one.leaf} is travelled to before the robot is free"
    if action.moves and (leg.start_s, leg.end_s) != (one.start_s, one.end_s):
        yield f"{one.leaf} is a move, its leg has other times"
    if not action.moves and leg.end_s > one.start_s + EPS:
        yield f"{one.leaf} starts before its robot is there"
    if not action.moves and speed is not None and leg.end_s - leg.start_s < distance(origin, goal) / speed - EPS:
        yield f"{one.leaf} is travelled to too fast"


def distance(origin: Position, goal: Position) -> float:
    """Straight, on one floor."""
    return math.hypot(goal.x_m - origin.x_m, goal.y_m - origin.y_m)


def faults(instance: Instance, fleet: Fleet, world: Scene, result: Schedule) -> list[str]:
    """Every rule that a schedule breaks."""
    return Replay(instance, fleet, world, result).faults()
