"""
The least makespan of small missions on a line, by trying everything: an oracle that shares no code with the schedulers.

Actions (joint ones together) are put down one after the other, each as early as it can be after what stands there already; every order
and every choice of robots is tried. Some best schedule comes about that way: put its actions down in order of their starts. Of a shared
resource every way is tried in which its places can be passed on from one holder to the next, so that it is no more than an order.
What robots can refill lasts for ever here, so that with
chargers the least makespan may be out of reach.
"""

from __future__ import annotations

import math
from collections.abc import Hashable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from graphlib import CycleError, TopologicalSorter
from itertools import combinations, pairwise, permutations, product

from benchmarks.schedule_cases import ScheduleCase
from missiontree.mission.shared_resource import SharedResource

SLACK = 1e-6
MOST_STEPS = 1_000


class TooMuchError(Exception):
    """More is to be tried than is worth it."""


@dataclass(slots=True)
class _World:
    """What stands there so far."""

    start: dict[int, int] = field(default_factory=dict)
    end: dict[int, int] = field(default_factory=dict)
    robot_of: dict[int, str] = field(default_factory=dict)  # by role
    spot: dict[str, float | None] = field(default_factory=dict)
    free: dict[str, int] = field(default_factory=dict)
    held: dict[str, int] = field(default_factory=dict)  # by robot: its role
    thing: dict[str, float | None] = field(default_factory=dict)
    since: dict[str, int] = field(default_factory=dict)
    needed: dict[str, int] = field(default_factory=dict)
    spent: dict[tuple[str, str], float] = field(default_factory=dict)
    lasts: dict[int, int] = field(default_factory=dict)  # of what is still to be handed over, by first leaf of its unit

    def copy(self) -> _World:
        """A world that may go another way."""
        return _World(
            dict(self.start),
            dict(self.end),
            dict(self.robot_of),
            dict(self.spot),
            dict(self.free),
            dict(self.held),
            dict(self.thing),
            dict(self.since),
            dict(self.needed),
            dict(self.spent),
            dict(self.lasts),
        )

    def known(self, leaves: Sequence[int], soonest: int) -> Hashable:
        """All that matters to what may follow, none of which starts sooner than that: worlds that agree in it are one."""
        times = *map(self.start.get, leaves), *map(self.end.get, leaves)
        where = *self.spot.values(), *self.free.values(), *self.thing.values()  # their keys stand from the beginning
        spent = (*sorted((what, round(amount, 6)) for what, amount in self.spent.items()),) if self.spent else ()
        changed = (self.robot_of, self.since, self.needed, self.lasts)
        return soonest, times, where, spent, *(frozenset(one.items()) for one in changed)


class Oracle:
    """
    One case.

    Parameters
    ----------
    case
        A mission whose tree has no XOR.
    """

    def __init__(self, case: ScheduleCase) -> None:
        self.case, self.tree, self.fleet = case, case.tree, case.fleet
        self.actions = {index: node.action for index, node in enumerate(case.tree.nodes) if node.action is not None}
        self.leaves = [*self.actions]
        self.type_of = {leaf: action.robot_type for leaf, action in self.actions.items()}
        self.robots_of = {kind.id: [robot.id for robot in kind.members] for kind in case.fleet.types}
        self.length = {leaf: _ms(action.duration_s) for leaf, action in self.actions.items()}
        self.roles: dict[int, list[int]] = {}
        for leaf in self.leaves:
            self.roles.setdefault(self.actions[leaf].role, []).append(leaf)
        self.units: list[list[int]] = []
        joint: dict[int, list[int]] = {}
        for leaf in self.leaves:
            sync = self.actions[leaf].sync
            if sync is None:
                self.units.append([leaf])
            elif sync in joint:
                joint[sync].append(leaf)
            else:
                joint[sync] = [leaf]
                self.units.append(joint[sync])
        self.before: dict[int, set[int]] = {leaf: set() for leaf in self.leaves}
        self.until: dict[int, set[int]] = {}
        self.team = {role: case.tree.roles[role].team for role in self.roles}
        self.few = [(kind, kind.max_in_use) for kind in case.fleet.types if kind.max_in_use is not None]
        self.refilled = {kind.id: case.terms.refilled(kind) for kind in case.fleet.types}
        self.limits = {robot: self._limits_of(robot) for robot in case.fleet.robots}
        self.same: list[set[int]] = []
        self.different: list[tuple[set[int], set[int]]] = []
        self.found: int | None = None
        self.best: int | None = None  # what is found must be less: the least so far, or what was asked for
        self.widest = max(map(len, self.units), default=1)
        self.steps = 0
        self.seen: set[Hashable] = set()  # worlds from which everything was tried, or is being tried
        self.taker: dict[int, int] = {}  # by unit that hands over: the unit that takes over
        self.follow: list[set[int]] = []  # by unit: what must come after it, whoever has what is shared
        self.over_first: dict[int, set[int]] = {}  # what must be over before each action, but for who hands over to it
        self.unfit = False
        self.disturbed = False  # something comes between a giver and a taker: whether that can be is not decided here
        self._read_links()
        self.disturbed |= any(self._comes_between(giver, taker) for giver, taker in self.taker.items())
        self.disturbed |= self._may_exchange()
        if self.taker:  # at the moment of a hand-over, orders do not tell who of several has what is shared
            actions = self.actions.values()
            self.disturbed |= any(one.holds and (one.moves or not one.duration_s) for one in actions)
        self.release = dict.fromkeys(self.leaves, 0)
        self.due: dict[int, int] = {}
        for index, node in enumerate(case.tree.nodes):
            for leaf in self._below(index):
                self.release[leaf] = max(self.release[leaf], _ms(node.release_s))
                if node.deadline_s is not None:
                    self.due[leaf] = min(self.due.get(leaf, 1 << 60), round(node.deadline_s * 1000))

    def _read_links(self) -> None:
        for link in self.case.tree.links:
            first, second = self._below(link.first), self._below(link.second)
            roles = [{self.actions[leaf].role for leaf in side} for side in (first, second)]
            if link.kind == "precedence":
                for leaf in second:
                    self.before[leaf] |= set(first)
            elif link.kind == "until":
                for leaf in first:
                    if self.actions[leaf].open_ended:
                        self.until.setdefault(leaf, set()).update(second)
            elif link.kind == "hand_over":
                self.different.append((roles[0], roles[1]))
                self._read_hand_over(first, second)
            elif link.kind == "same_robot":
                self.same.append(roles[0] | roles[1])
            else:
                self.different.append((roles[0], roles[1]))

    def _read_hand_over(self, first: list[int], second: list[int]) -> None:
        """Which unit ends when which unit starts; a hand-over that can never be leaves nothing to try."""
        if not first or not second:
            return
        ends = {self._unit(own[-1]) for own in self.roles.values() if {*own} & {*first}}
        starts = {self._unit(own[0]) for own in self.roles.values() if {*own} & {*second}}
        whole = all(
            {*own} & {*first} in (set(), {*own}) and {*own} & {*second} in (set(), {*own})
            for own in self.roles.values()
        )
        giver, taker = min(ends), min(starts)
        given = [self.actions[leaf] for leaf in self.units[giver]]
        taken = [self.actions[leaf] for leaf in self.units[taker]]
        there = [self._left_at(one.role) for one in given]
        meet = all(two.at is not None and two.at in places for places in there for two in taken)
        names = {two.at for two in taken}.union(*there)
        own_roles = {one.role for one in (*given, *taken)}
        others = [self.actions[leaf] for leaf in self.leaves if self.actions[leaf].role not in own_roles]
        self.disturbed |= any(names & {*other.brings} for other in others)
        sound = len(ends) == len(starts) == 1 and giver != taker and whole and self.taker.get(giver, taker) == taker
        self.unfit |= not (sound and meet) or any(one.open_ended for one in given) or any(two.moves for two in taken)
        self.taker[giver] = taker

    def _comes_between(self, giver: int, taker: int) -> bool:
        """Whether something of no length must follow a giver and be over before its taker begins, all at one moment."""
        after = self._after()
        follow = self._reached(self.units[giver], after) - {*self.units[giver], *self.units[taker]}
        return any(
            (self.actions[leaf].moves or not self.actions[leaf].duration_s)
            and self._reached([leaf], after) & {*self.units[taker]}
            for leaf in follow
        )

    def _may_exchange(self) -> bool:
        """Whether two robots may hand over to each other at one moment, of which no order tells."""
        types = [{self.actions[leaf].robot_type for leaf in unit} for unit in self.units]
        pairs = combinations(self.taker.items(), 2)
        return any(types[one[1]] & types[two[0]] and types[two[1]] & types[one[0]] for one, two in pairs)

    def _after(self) -> dict[int, set[int]]:
        """What comes right after each action, in its role and by order."""
        after: dict[int, set[int]] = {leaf: set() for leaf in self.leaves}
        for own in self.roles.values():
            for leaf, later in pairwise(own):
                after[leaf].add(later)
        for leaf, earlier in self.before.items():
            for one in earlier:
                after[one].add(leaf)
        return after

    def _reached(self, leaves: Iterable[int], after: Mapping[int, set[int]]) -> set[int]:
        seen, stack = set[int](), [*leaves]
        while stack:
            fresh = after[stack.pop()] - seen
            seen |= fresh
            stack += fresh
        return seen

    def _left_at(self, role: int) -> set[str | None]:
        """Where a role ends, and what it brought there."""
        here: set[str | None] = set()
        for action in (self.actions[leaf] for leaf in self.roles[role]):
            if action.moves or (action.at is not None and action.at not in here):
                here = {action.at, *action.brings}
        return here

    def _unit(self, leaf: int) -> int:
        return next(number for number, unit in enumerate(self.units) if leaf in unit)

    def least(self, below: int | None = None) -> int | None:
        """Least makespan in milliseconds; None if nothing works, or nothing sooner than ``below``."""
        self.best = below
        if self.unfit or {*self.taker} & {*self.taker.values()}:
            return None
        if self.disturbed:
            raise TooMuchError
        plain, after = self.before, self._after()
        self.follow = [self._reached(unit, after) for unit in self.units]
        for chains in product(*(self._passings(resource) for resource in self.case.scene.resources)):
            self.before = {leaf: set(earlier) for leaf, earlier in plain.items()}
            for earlier, later in (pair for pairs in chains for pair in pairs):
                for leaf in self.units[later]:
                    self.before[leaf] |= set(self.units[earlier])
            self._try()
        return self.found

    def _passings(self, resource: SharedResource) -> list[tuple[tuple[int, int], ...]]:
        """All ways in which units pass on the places of a resource: pairs of units that come one after the other."""
        asks = {
            number: sum(resource.id in self.actions[leaf].holds for leaf in unit)
            for number, unit in enumerate(self.units)
        }
        holders = [number for number, asked in asks.items() if asked]
        found: dict[tuple[tuple[int, int], ...], None] = {}
        if sum(asks.values()) <= resource.capacity:
            return [()]
        for order in permutations(holders):
            ways: list[tuple[tuple[int, ...], frozenset[tuple[int, int]]]] = [((-1,) * resource.capacity, frozenset())]
            for one in order:
                ways = [
                    (
                        tuple(sorted(one if place in taken else last for place, last in enumerate(places))),
                        pairs | passed,
                    )
                    for places, pairs in ways
                    for taken in combinations(range(resource.capacity), asks[one])
                    for passed in [frozenset((places[place], one) for place in taken if places[place] >= 0)]
                ]
            found |= dict.fromkeys(tuple(sorted(pairs)) for _, pairs in ways)
        return [pairs for pairs in found if not any(self.follow[later] & {*self.units[one]} for one, later in pairs)]

    def _try(self) -> None:
        self.over_first = {leaf: self._over_first(leaf) for leaf in self.leaves}
        try:
            order = [*TopologicalSorter(self.over_first).static_order()]
        except CycleError:
            return
        self.rest = self._rests(order)
        self.last_end = self._last_ends(order)
        own_ends = [sorted(self._own_ends(leaf)) for leaf in sorted(self.until)]
        for chosen in product(*own_ends):
            latest: dict[int, list[int]] = {}
            for open_ended, one in zip(sorted(self.until), chosen, strict=True):
                latest.setdefault(one, []).append(open_ended)
            self.seen = set()
            self._go_on(self._begin(), latest, 0)

    def _rests(self, order: Sequence[int]) -> dict[int, int]:
        """For each action, how long those after it take at least, one after the other; moves may take no time."""
        after = self._after()
        least = self.lasts = {
            leaf: 0 if leaf in self.until or self.actions[leaf].moves else self.length[leaf] for leaf in self.leaves
        }
        rest: dict[int, int] = {}
        for leaf in reversed(order):
            rest[leaf] = max((least[one] + rest.get(one, 0) for one in after[leaf]), default=0)
        return rest

    def _last_ends(self, order: Sequence[int]) -> dict[int, int]:
        """By when an action is to be over, so that what comes after it is in time, too; without those that may end at any time."""
        found = dict(self.due)
        for leaf in reversed(order):
            if leaf in found:
                for one in self.over_first[leaf]:
                    due = found[leaf] - self.lasts[leaf]
                    found[one] = min(found.get(one, due), due)
        return found

    def _own_ends(self, leaf: int) -> set[int]:
        """Actions with an end of their own that set the end of an open-ended one."""
        seen, stack = {leaf}, [leaf]
        while stack:
            fresh = self.until.get(stack.pop(), set()) - seen
            seen |= fresh
            stack += fresh
        return {one for one in seen if one not in self.until}

    def _below(self, node: int) -> list[int]:
        found = []
        for leaf in self.leaves:
            above = leaf
            while above not in (node, -1):
                above = self.tree.nodes[above].parent
            if above == node:
                found.append(leaf)
        return found

    def _begin(self) -> _World:
        world = _World()
        for kind in self.fleet.types:
            for robot in kind.members:
                world.spot[robot.id] = None if robot.position is None else robot.position.x_m
                world.free[robot.id] = _ms(kind.availability(robot)[0])
        for entity in self.case.scene.entities:
            world.thing[entity.id] = None if entity.position is None else entity.position.x_m
        return world

    def _go_on(self, world: _World, latest: dict[int, list[int]], sorted_from: int) -> None:
        self.steps += 1
        if self.steps > MOST_STEPS:
            raise TooMuchError
        if len(world.start) == len(self.leaves):
            world = world.copy()
            if len(world.end) == len(self.leaves) and self._home(world) and self._whole(world):
                makespan = max(*world.end.values(), *(world.free[robot] for robot in world.robot_of.values()))
                if self.best is None or makespan < self.best:
                    self.best = self.found = makespan
            return
        if self._too_late(world, sorted_from):
            return
        found: list[tuple[int, int, _World]] = []
        for unit in self.units:
            if unit[0] in world.start or not self._may_begin(world, unit, latest):
                continue
            for robots in self._staffings(world, unit):
                after = self._put(world, unit, robots, latest, sorted_from)
                if after is not None:
                    found.append((after.start[unit[0]], unit[0], after))
        # What begins soonest comes first: a good best rules out much.
        for start, first, after in sorted(found, key=lambda one: one[:2]):
            if not self._in_vain(after, first):
                soonest = 0 if self.until else start
                known = after.known(self.leaves, soonest)
                if known not in self.seen:
                    self.seen.add(known)
                    self._go_on(after, latest, soonest)

    def _may_begin(self, world: _World, unit: list[int], latest: dict[int, list[int]]) -> bool:
        for leaf in unit:
            if not (self.over_first[leaf] <= world.end.keys()):
                return False
            if leaf in latest and any(one not in world.start for one in latest[leaf]):
                return False
        return not self.taker or self._may_come_between(world, unit)

    def _may_come_between(self, world: _World, unit: list[int]) -> bool:
        """Whether a unit leaves alone what is being handed over."""
        moved = {name for leaf in unit for name in self.actions[leaf].brings}
        touched = moved | {self.actions[leaf].at for leaf in unit}
        for giver, taker in self.taker.items():
            begun = self.units[giver][0] in world.start
            brought = {name for leaf in self.units[giver] for name in self.actions[leaf].brings}
            if self.units[taker] == unit and not begun:
                return False
            waits = begun and self.units[taker][0] not in world.start
            there = {self.actions[leaf].at for leaf in self.units[giver]}
            if self.units[taker] != unit and waits and (brought & touched or there & moved):
                return False
        return True

    def _over_first(self, leaf: int) -> set[int]:
        givers = (self.units[giver] for giver, taker in self.taker.items() if leaf in self.units[taker])
        own = self.roles[self.actions[leaf].role]
        return self.before[leaf].difference(*givers) | {*own[: own.index(leaf)][-1:]}

    def _staffings(self, world: _World, unit: list[int]) -> Iterator[dict[int, str]]:
        """Robots by role, for all roles of a unit."""
        options = []
        for leaf in unit:
            action = self.actions[leaf]
            if action.role in world.robot_of:
                robots = [world.robot_of[action.role]]
                if world.held.get(robots[0]) not in (None, action.role):
                    return
            else:
                robots = self._free_robots(world, action.robot_type)
            options.append([(action.role, robot) for robot in robots])
        bound = all(self.actions[leaf].role in world.robot_of for leaf in unit)
        for chosen in product(*options):
            if bound:  # who they are was looked at before
                yield dict(chosen)
            elif len({robot for _, robot in chosen}) == len(chosen):
                binding = world.robot_of | dict(chosen)
                if self._staffed(binding):
                    yield dict(chosen)

    def _free_robots(self, world: _World, type_id: str) -> list[str]:
        """Robots of a type that nothing holds; of equal ones that have done nothing yet, as many as roles may still begin with."""
        kind, used, found = self.fleet.by_id[type_id], set(world.robot_of.values()), list[str]()
        fresh = 0
        for robot in kind.members:
            if robot.id in world.held:
                continue
            if not kind.robots and robot.id not in used and robot.id not in self.case.terms.require:
                fresh += 1
                if fresh > self.widest:
                    continue
            found.append(robot.id)
        return found

    def _staffed(self, binding: dict[int, str]) -> bool:
        for roles in self.same:
            if len({binding[role] for role in roles if role in binding}) > 1:
                return False
        for first, second in self.different:
            mine, its = ({binding[role] for role in side if role in binding} for side in (first, second))
            if mine & its:
                return False
        teams = [(self.team[role], robot) for role, robot in binding.items() if self.team[role] is not None]
        if len(set(teams)) < len(teams):
            return False
        return not self.few or all(
            len({robot for robot in binding.values() if self.fleet.type_of[robot] is kind}) <= most
            for kind, most in self.few
        )

    def _whole(self, world: _World) -> bool:
        busy = set(world.robot_of.values())
        if any(world.end[leaf] > due for leaf, due in self.due.items()):
            return False
        for robot in busy:
            until_s = self.fleet.type_of[robot].availability(self.fleet.robots[robot])[1]
            if until_s is not None and world.free[robot] > round(until_s * 1000):
                return False
        return all(name in busy or name in self.fleet.by_id for name in self.case.terms.require)

    def _put(
        self, world: _World, unit: list[int], robots: dict[int, str], latest: dict[int, list[int]], sorted_from: int
    ) -> _World | None:
        start, length, ways = self._earliest(world, unit, robots, latest)
        end = start + length
        if start < sorted_from or (self.best is not None and end >= self.best):
            return None
        after = world.copy()
        for leaf in unit:
            action = self.actions[leaf]
            robot = robots[action.role]
            if not self._spend(after, robot, action.uses, ways[leaf][1]):
                return None
            after.robot_of[action.role] = robot
            after.start[leaf] = start
            after.held[robot] = action.role
        self._move(after, unit, robots, start, end)
        for giver, taker in self.taker.items():
            if self.units[taker] == unit:
                self._hand_over(after, self.units[giver], start)
        if any(self.units[giver] == unit for giver in self.taker):
            after.lasts[unit[0]] = length
        elif unit[0] not in self.until:
            for leaf in unit:
                self._over(after, leaf, end)
        self._settle(after)
        ended = after.end
        for leaf, due in self.last_end.items():
            if leaf in ended and ended[leaf] > due:
                return None
        return None if self._in_vain(after, unit[0]) else after

    def _too_late(self, world: _World, soonest: int) -> bool:
        """Whether what is left, none of which starts sooner than that, cannot all end in time, or sooner than the best."""
        left: dict[str, int] = {}
        ended, best = world.end, self.best
        for leaf in self.leaves:
            if leaf not in world.start:
                ends = max(soonest, self.release[leaf])
                for one in self.before[leaf]:
                    if one in ended and ended[one] > ends:
                        ends = ended[one]
                ends += self.lasts[leaf]
                if ends > self.last_end.get(leaf, ends) or (best is not None and ends + self.rest[leaf] >= best):
                    return True
                type_id = self.type_of[leaf]
                left[type_id] = left.get(type_id, 0) + self.lasts[leaf]
        if best is None:
            return False
        for type_id, work in left.items():
            last, free = best - 1, world.free
            if sum(max(0, last - max(soonest, free[robot])) for robot in self.robots_of[type_id]) < work:
                return True
        return False

    def _in_vain(self, world: _World, last: int) -> bool:
        """Whether nothing that goes on from here ends sooner than the best; ``last`` was put down last."""
        if self.best is None:
            return False
        least = world.end.get(last, world.start[last]) + self.rest[last]
        return max([least, *world.end.values()]) >= self.best

    def _earliest(
        self, world: _World, unit: list[int], robots: dict[int, str], latest: dict[int, list[int]]
    ) -> tuple[int, int, dict[int, tuple[int, float]]]:
        """Start and length in milliseconds, and the ways."""
        start, length = 0, 0
        ways: dict[int, tuple[int, float]] = {}
        for leaf in unit:
            action = self.actions[leaf]
            robot = robots[action.role]
            ways[leaf] = way = self._way(world, robot, leaf)
            start = max(start, self.release[leaf], world.free[robot] + (0 if action.moves else way[0]))
            for one in self.over_first[leaf]:
                start = max(start, world.end[one])
            length = max(length, way[0] if action.moves else self.length[leaf])
            if action.at is not None:
                start = max(start, world.since.get(action.at, 0))
            for name in action.brings:
                start = max(start, world.since.get(name, 0), world.needed.get(name, 0))
        for giver, taker in self.taker.items():
            if self.units[taker] == unit:
                first = self.units[giver][0]
                start = max(start, world.start[first] + world.lasts[first])
        if unit[0] in self.until:
            length = 0
        for leaf in unit:
            for one in latest.get(leaf, ()):
                start = max(start, world.start[one] + 1 - length)
        return start, length, ways

    def _move(self, world: _World, unit: list[int], robots: dict[int, str], start: int, end: int) -> None:
        """Robots and things are elsewhere afterwards."""
        actions = [self.actions[leaf] for leaf in unit]
        targets = [None if action.at is None else world.thing[action.at] for action in actions]
        for action, target in zip(actions, targets, strict=True):
            if action.at is not None:
                world.needed[action.at] = max(world.needed.get(action.at, 0), start if action.open_ended else end)
            if action.moves or action.at is not None:
                world.spot[robots[action.role]] = target
            for name in action.brings:
                world.thing[name], world.since[name] = target, end

    def _hand_over(self, world: _World, giver: list[int], moment: int) -> None:
        """Who hands over is there until the taker starts, and so is what it brings."""
        for leaf in giver:
            self._over(world, leaf, moment)
            action = self.actions[leaf]
            if action.at is not None:
                world.needed[action.at] = max(world.needed.get(action.at, 0), moment)
            for name in action.brings:
                world.since[name] = max(world.since.get(name, 0), moment)

    def _settle(self, world: _World) -> None:
        """Open-ended actions end when the last of what they last for does."""
        changed = True
        while changed:
            changed = False
            for leaf, others in self.until.items():
                if leaf in world.start and leaf not in world.end and all(one in world.end for one in others):
                    self._over(world, leaf, max([world.start[leaf], *(world.end[one] for one in others)]))
                    changed = True

    def _over(self, world: _World, leaf: int, end: int) -> None:
        action = self.actions[leaf]
        robot = world.robot_of[action.role]
        world.end[leaf] = end
        world.free[robot] = max(world.free[robot], end)
        if leaf == self.roles[action.role][-1]:
            del world.held[robot]

    def _way(self, world: _World, robot: str, leaf: int) -> tuple[int, float]:
        """Milliseconds and metres."""
        action = self.actions[leaf]
        nominal = self.length[leaf] if action.moves else 0
        if action.at is None and not action.moves:
            return 0, 0.0
        origin, goal = world.spot[robot], None if action.at is None else world.thing[action.at]
        if goal is None or origin is None:
            return nominal, 0.0
        metres = abs(goal - origin)
        speed = self.fleet.type_of[robot].limits.get("max_speed_mps")
        if speed is None:
            return nominal, metres
        caps = [self.case.scene.by_id[name].max_speed_mps for name in action.brings]
        return _ms(metres / min([speed, *(cap for cap in caps if cap is not None)])), metres

    def _home(self, world: _World) -> bool:
        """Whether all that took part get home, where they must; they are there afterwards."""
        home_by = self.case.terms.home_by_s
        for robot in sorted({*world.robot_of.values()}) if self.case.terms.return_home else ():
            start, here = self.fleet.robots[robot].position, world.spot[robot]
            if start is None:  # the start of its type, if the type has one
                start = self.fleet.type_of[robot].position
            metres = 0.0 if start is None or here is None else abs(start.x_m - here)
            speed = self.fleet.type_of[robot].limits.get("max_speed_mps")
            world.free[robot] += 0 if speed is None else _ms(metres / speed)
            if not self._spend(world, robot, {}, metres):
                return False
            if home_by is not None and world.free[robot] > round(home_by * 1000):
                return False
        return True

    def _spend(self, world: _World, robot: str, uses: Mapping[str, float], metres: float) -> bool:
        per_m, limits = self.fleet.type_of[robot].uses_per_m, self.limits[robot]
        for name, of_name in limits.items():
            amount = uses.get(name, 0.0) + per_m.get(name, 0.0) * metres
            for whose, limit in of_name if amount else ():
                spent = world.spent[whose, name] = world.spent.get((whose, name), 0.0) + amount
                if spent > limit + SLACK:
                    return False
        return True

    def _limits_of(self, robot: str) -> dict[str, list[tuple[str, float]]]:
        """What limits the use of something by a robot: by its name, whose limit and how much."""
        kind, found = self.fleet.type_of[robot], dict[str, list[tuple[str, float]]]()
        named = {*kind.uses_per_m}.union(*(action.uses for action in self.actions.values()))
        for name in sorted(named):
            limits = (
                (robot, None if name in self.refilled[kind.id] else kind.budget(self.fleet.robots[robot], name)),
                (f"type {kind.id}", kind.total_limits.get(name)),
                ("all", self.fleet.total_limits.get(name)),
                ("stock", self.case.terms.stock.get(name)),
            )
            if set_limits := [(whose, limit) for whose, limit in limits if limit is not None]:
                found[name] = set_limits
        return found


def _ms(duration_s: float) -> int:
    return math.ceil(duration_s * 1000 - 1e-6)


def least_makespan(case: ScheduleCase, below: int | None = None) -> int | None:
    """
    Least makespan of a case in milliseconds; None if nothing works.

    Parameters
    ----------
    case
        A mission whose tree has no XOR.
    below
        Only what is over sooner is sought, which is less to try; None is the answer where there is none.

    Raises
    ------
    TooMuchError
        If there is too much to try.
    """
    return Oracle(case).least(below)


__all__: Sequence[str] = ["Oracle", "TooMuchError", "least_makespan"]
