"""
The critical chain of a schedule: what, end to end, makes it take as long as it does.

Found by walking back from the end of the last action: each event is bound by another that comes right before it, down to the
start of the mission (the critical path of Kelley and Walker, 1959, with robots and ways as in a resource-constrained
schedule). Shares no code with the schedulers.
"""

from __future__ import annotations

from dataclasses import replace

from missiontree.mission.chain import Bond, CriticalChain, Step, StepKind
from missiontree.mission.fleet import Fleet
from missiontree.mission.grounded import GroundedTree
from missiontree.mission.plan import Plan
from missiontree.mission.scene import Scene
from missiontree.mission.schedule import OwnLeg, Schedule
from missiontree.reporting.critical.bonds import Bonds, Cause, Event
from missiontree.reporting.critical.spans import ms


def critical_chain(
    tree: GroundedTree, schedule: Schedule, scene: Scene | None = None, fleet: Fleet | None = None
) -> tuple[Step, ...]:
    """
    A critical chain, in order of time: contiguous, from 0 to the end of the last action, or of the last way home if that is later.

    There may be several; ties go to the same role first, then to travel, order, robot and the smaller leaf. In a schedule that
    waits without a reason, the chain has a step of kind ``wait`` there. Empty if nothing takes time.

    Parameters
    ----------
    tree, schedule
        A schedule over the leaves of a tree.
    scene
        Tells what robots share. Default: nothing.
    fleet
        Tells which robots come late. Default: none does.
    """
    bonds = Bonds(tree, schedule, scene, fleet)
    end = max((ms(one.end_s) for one in schedule.actions), default=0)
    home = max(schedule.returns, key=lambda leg: (ms(leg.end_s), leg.robot), default=None)
    if home is not None and ms(home.end_s) > end:
        return _and_home(bonds, home)
    last = min((leaf for leaf, one in bonds.at.items() if ms(one.end_s) == end), default=None)
    if last is None or not end:
        return ()
    return tuple(_Walk(bonds).steps(Event("end", last)))


def chain_of(plan: Plan, schedule: Schedule) -> CriticalChain:
    """The critical chain of a schedule of a plan, with what its time goes into."""
    assert plan.grounding is not None
    tree = plan.grounding.tree
    steps = critical_chain(tree, schedule, plan.brief.world, plan.brief.fleet)
    spent = {"work": 0, "travel": 0, "waiting": 0}
    for step in steps:
        moving = step.kind in {"travel", "home"} or (step.kind == "action" and tree.action(step.leaf).moves)
        what = "travel" if moving else "work" if step.kind == "action" else "waiting"
        spent[what] += ms(step.end_s) - ms(step.start_s)
        if step.kind == "refill":
            driven = _driven(schedule, step)
            spent["travel"] += driven
            spent["waiting"] -= driven
    return CriticalChain(
        rank=schedule.rank,
        makespan_s=schedule.makespan_s,
        work_s=spent["work"] / 1000,
        travel_s=spent["travel"] / 1000,
        waiting_s=spent["waiting"] / 1000,
        steps=steps,
    )


def _driven(schedule: Schedule, step: Step) -> int:
    """Milliseconds of a stretch at chargers in which the robot is on its way to one."""
    legs = (visit.leg for visit in schedule.recharges if visit.robot == step.robot and visit.leg is not None)
    spans = ((ms(leg.start_s), ms(leg.end_s)) for leg in legs)
    return sum(max(0, min(end, ms(step.end_s)) - max(start, ms(step.start_s))) for start, end in spans)


def _and_home(bonds: Bonds, home: OwnLeg) -> tuple[Step, ...]:
    """The chain to the last action of a robot, then its way home."""
    own = [one for one in bonds.at.values() if one.robot == home.robot]
    if not own:
        return ()
    last = max(own, key=lambda one: (ms(one.end_s), ms(one.start_s), one.leaf))
    detours = bonds.detours.of.get(home.robot, ())
    visit = next((one.visits[-1] for one in detours if ms(last.end_s) == one.since < one.until), None)
    came = Event("end", last.leaf) if visit is None else Event("unplug", visit)
    steps, free, leaves = _Walk(bonds).steps(came), bonds.time(came), ms(home.start_s)
    bond: Bond = "robot" if visit is None else "refill"
    if free < leaves:
        steps.append(Step("wait", last.leaf, home.robot, free / 1000, home.start_s, "robot"))
        bond = "resource" if bonds.shares(home) else "unexplained"
    return (*steps, Step("home", last.leaf, home.robot, home.start_s, home.end_s, bond))


class _Walk:
    """The walk back. Steps are found latest first; each is given its bond by what comes next."""

    def __init__(self, bonds: Bonds) -> None:
        self._bonds = bonds
        self._found: list[Step] = []

    def steps(self, event: Event) -> list[Step]:
        """Steps in order of time, up to an event."""
        while self._bonds.time(event):
            path, event = self._back(event)
            for at, cause in path:
                self._add(at, cause)
            if self._bonds.time(event):
                before = self._gap(event)
                if before is None:
                    break
                event = before
        return self._found[::-1]

    def _back(self, last: Event) -> tuple[list[tuple[Event, Cause]], Event]:
        """Causes that bind, from an event back to the start of the mission, or else as far as they lead."""
        came: dict[Event, tuple[Event, Cause] | None] = {last: None}
        stack, furthest = [last], last
        while stack:
            event = stack.pop()
            time = self._bonds.time(event)
            if self._further(event, furthest):
                furthest = event
            if not time:
                break
            fresh: list[Event] = []
            for cause in self._bonds.causes(event):
                if cause.event not in came and self._bonds.time(cause.event) + cause.lag == time:
                    came[cause.event] = (event, cause)
                    fresh.append(cause.event)
            stack.extend(reversed(fresh))
        path: list[tuple[Event, Cause]] = []
        way = came[furthest]
        while way is not None:
            path.append(way)
            way = came[way[0]]
        return path[::-1], furthest

    def _further(self, event: Event, furthest: Event) -> bool:
        """Whether an event explains more: the start of the mission does all, a release time the rest; else the earlier one does."""

        def key(one: Event) -> tuple[bool, bool, int]:
            time = self._bonds.time(one)
            return time > 0, self._bonds.held_back(one) is None, time

        return key(event) < key(furthest)

    def _gap(self, event: Event) -> Event | None:
        """
        A wait that no other event explains, down to the last cause before it.

        Where that leads; None if there is no such cause, or if it is known why it is waited.
        """
        bonds, time = self._bonds, self._bonds.time(event)
        known: Bond | None = bonds.held_back(event)
        if known is not None:
            self._bind(known)
            leaf, since = bonds.leaf_of(event), time
            if known == "refill":
                since = bonds.detours.holding(event.leaf).since
                self._put("refill", leaf, since, time)
                known = "available" if since == bonds.comes(bonds.at[leaf].robot) else "unexplained"
            if since:
                self._bind(known)
                self._put("wait", leaf, 0, since)
            return None
        past = [cause for cause in bonds.causes(event) if bonds.time(cause.event) + cause.lag < time]
        cause = max(past, key=lambda cause: bonds.time(cause.event) + cause.lag, default=None)
        since = 0 if cause is None else bonds.time(cause.event) + cause.lag
        self._bind("unexplained")
        self._put("wait", event.leaf, since, time)
        if cause is None:
            return None
        self._add(event, cause)
        return cause.event

    def _add(self, event: Event, cause: Cause) -> None:
        """What passes between a cause and what it binds, latest first."""
        if cause.bond != "start":
            self._bind(cause.bond)
        time, leaf = self._bonds.time(cause.event), self._bonds.leaf_of(cause.event)
        if cause.bond == "until":
            self._put("until", event.leaf, time, time)
        elif cause.passing:
            self._put(cause.passing, leaf, time, time + cause.lag)
            if cause.passing == "refill" and cause.event.kind == "end":
                self._bind("robot")

    def _put(self, kind: StepKind, leaf: int, start: int, end: int) -> None:
        robot = self._bonds.at[leaf].robot
        bond: Bond = "until" if kind == "until" else "start"
        self._found.append(Step(kind, leaf, robot, start / 1000, end / 1000, bond))

    def _bind(self, bond: Bond) -> None:
        """The reason why the earliest step so far does not start earlier; the first that is given counts."""
        if self._found and self._found[-1].bond == "start":
            self._found[-1] = replace(self._found[-1], bond=bond)
