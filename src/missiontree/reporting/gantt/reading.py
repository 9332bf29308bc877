"""A schedule read for a Gantt chart."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise

from missiontree.mission.chain import Step
from missiontree.mission.grounded import GroundedTree
from missiontree.mission.plan import Plan
from missiontree.mission.schedule import Leg, OwnLeg, Schedule, ScheduledAction, TravelLeg
from missiontree.mission.tree import IN_ORDER
from missiontree.reporting.critical.bonds import Bonds, Event
from missiontree.reporting.critical.chain import critical_chain
from missiontree.reporting.critical.spans import ms
from missiontree.reporting.escape import one_line
from missiontree.reporting.gantt.away import away_of
from missiontree.reporting.gantt.content import Bar, Content, Order, Row, Stretch
from missiontree.reporting.gantt.dues import dues_of, times_at, times_of
from missiontree.reporting.gantt.shared import shared_rows
from missiontree.reporting.gantt.time import exact
from missiontree.reporting.gantt.waits import why_stayed, why_waited
from missiontree.reporting.palette import Livery, liveries
from missiontree.reporting.visits import Visit, visits_of


def content_of(plan: Plan, schedule: Schedule) -> Content:
    """What there is to see of a schedule that has actions."""
    assert plan.grounding is not None
    tree = plan.grounding.tree
    scene, fleet = plan.brief.world, plan.brief.fleet
    chain = critical_chain(tree, schedule, scene, fleet)
    bonds = Bonds(tree, schedule, scene, fleet)
    own: dict[str, list[ScheduledAction]] = {}
    for one in bonds.at.values():
        own.setdefault(one.robot, []).append(one)
    looks = liveries(plan.brief.fleet)
    names = [*(robot for robot in looks if robot in own), *sorted(own.keys() - looks.keys())]
    kinds = plan.brief.fleet.type_of
    legs = {(leg.robot, leg.leaf): leg for leg in schedule.legs}
    returns = {leg.robot: leg for leg in schedule.returns}
    end_s = max([*(one.end_s for one in schedule.actions), *(leg.end_s for leg in schedule.returns)])
    visits = visits_of(plan, schedule)
    rows = [
        _Robot(
            tree,
            bonds,
            chain,
            legs,
            returns.get(robot),
            visits.get(robot, ()),
            sorted(own[robot], key=lambda one: (one.start_s, one.end_s, one.leaf)),
            away_of(fleet, robot, end_s),
        ).row(
            robot,
            one_line(kinds[robot].label) if robot in kinds and kinds[robot].label != robot else "",
            looks.get(robot, Livery(0)),
        )
        for robot in names
    ]
    idle = [robot for robot in looks if robot not in own]
    joint = sorted({tuple(bonds.joint(leaf)) for leaf in bonds.at if len(bonds.joint(leaf)) > 1})
    return Content(
        rows,
        idle,
        end_s,
        chain,
        list(_orders(tree, bonds, chain)),
        joint,
        tree.nodes[0].deadline_s,
        shared_rows(tree, schedule, scene, looks),
        handing_of(bonds),
        times_at(bonds),
    )


def handing_of(bonds: Bonds) -> dict[int, str]:
    """Who hands over to whom, and who takes over from whom, by leaf."""
    words = {giver: f"hands over to {bonds.at[taker].robot}" for giver, taker in bonds.taker.items()}
    for giver, taker in bonds.taker.items():
        for mate in bonds.joint(taker):
            words.setdefault(mate, f"takes over from {bonds.at[giver].robot}")
    return words


@dataclass(frozen=True, slots=True)
class _Robot:
    """Reads one robot's part of a schedule."""

    tree: GroundedTree
    bonds: Bonds
    chain: Sequence[Step]
    legs: dict[tuple[str, int], TravelLeg]
    home: OwnLeg | None
    visits: Sequence[Visit]
    done: Sequence[ScheduledAction]
    away: Sequence[Stretch]

    def row(self, robot: str, kind: str, livery: Livery) -> Row:
        lit = {(step.kind, step.leaf) for step in self.chain}
        bars = [
            self._bar(one, any(("action", mate) in lit for mate in self.bonds.joint(one.leaf))) for one in self.done
        ]
        ways = [
            self._way(leg, ("travel", one.leaf) in lit)
            for one in self.done
            if (leg := self.bonds.legs.get(one.leaf)) is not None and leg.robot == robot
        ]
        ways += [_way_to(visit, self._refilling(visit)) for visit in self.visits if visit.recharge.leg is not None]
        if self.home is not None:
            ways.append(_way_home(self.home, any(step.kind == "home" and step.robot == robot for step in self.chain)))
        dues = dues_of(self.tree, [one.leaf for one in self.done])
        return Row(
            robot,
            kind,
            livery,
            bars,
            ways,
            list(self._waits()),
            self._roles(),
            dues,
            self.away,
            list(self._refills(robot)),
        )

    def _refills(self, robot: str) -> Iterator[Stretch]:
        for visit in self.visits:
            one = visit.recharge
            title = f"{visit.text}\n{robot}, {exact(one.start_s)} to {exact(one.end_s)}\n{visit.levels}"
            yield Stretch(one.start_s, one.end_s, f"+{visit.gain}", title, self._refilling(visit))

    def _refilling(self, visit: Visit) -> bool:
        """Whether the critical chain runs through a visit to a charger."""
        one = visit.recharge
        return any(
            step.kind == "refill"
            and step.robot == one.robot
            and step.start_s <= one.start_s
            and one.end_s <= step.end_s
            for step in self.chain
        )

    def _bar(self, one: ScheduledAction, lit: bool) -> Bar:
        action = self.tree.action(one.leaf)
        leg = self.legs.get((one.robot, one.leaf))
        way = f"{leg.distance_m:,.0f} m" if action.moves and leg is not None and leg.distance_m >= 0.5 else ""
        text = one_line(action.text)
        lines = [
            text,
            f"{one.robot}, {exact(one.start_s)} to {exact(one.end_s)} ({exact(one.end_s - one.start_s)})",
            f"part of {one_line(self.tree.roles[action.role].label)}",
        ]
        lines += times_of(self.tree, one.leaf)
        lines += [words for leaf, words in handing_of(self.bonds).items() if leaf == one.leaf]
        if action.moves and leg is not None:
            lines.append(_distance(leg))
        return Bar(one.leaf, one.start_s, one.end_s, text, way, action.moves, lit, "\n".join(lines))

    def _way(self, leg: TravelLeg, lit: bool) -> Stretch:
        text = one_line(self.tree.action(leg.leaf).text)
        title = f"on the way to: {text}\n{leg.robot}, {exact(leg.start_s)} to {exact(leg.end_s)}\n{_distance(leg)}"
        label = f"{leg.distance_m:,.0f} m" if leg.distance_m >= 0.5 else ""
        return Stretch(leg.start_s, leg.end_s, label, title, lit)

    def _waits(self) -> Iterator[Stretch]:
        """Time in which the robot is held, or there already, or has no room on its way, and does nothing."""
        yield from (wait for visit in self.visits for wait in self._waits_for_room(visit))
        begun: set[int] = set()
        before: ScheduledAction | None = None
        for one in self.done:
            role, leg = self.tree.action(one.leaf).role, self.bonds.legs.get(one.leaf)
            held = before if role in begun else None
            if leg is None:
                why = why_waited(self.bonds, one.leaf)
                if held is not None:
                    yield from _wait(one.robot, held.end_s, one.start_s, why)
                elif why and self._stands_by(one.leaf):
                    yield from _wait(one.robot, self._free_by(one.start_s), one.start_s, why)
            else:
                stayed = why_stayed(self.bonds, one.leaf)
                if held is not None or stayed:
                    yield from _wait(one.robot, self._free_by(leg.start_s), leg.start_s, stayed)
                yield from _wait(one.robot, leg.end_s, one.start_s, why_waited(self.bonds, one.leaf))
            begun.add(role)
            before = one
        if self.home is not None and self.bonds.shares(self.home):
            yield from _wait(
                self.home.robot, self._free_by(self.home.start_s), self.home.start_s, "for room on the way home"
            )

    def _waits_for_room(self, visit: Visit) -> Iterator[Stretch]:
        """The wait for others at a charger, to which the robot has come, or where it is already."""
        one, leg = visit.recharge, visit.recharge.leg
        yield from _wait(
            one.robot,
            self._free_by(one.start_s) if leg is None else leg.end_s,
            one.start_s,
            f"for room at {visit.label}",
        )

    def _stands_by(self, leaf: int) -> bool:
        """Whether a robot that need not travel for an action waits where it is done, for its time to come, for room, or to take over."""
        action = self.tree.action(leaf)
        shares = action.at is not None and (bool(action.holds) or leaf in self.bonds.taker.values())
        return shares or self.bonds.released(Event("start", leaf))

    def _free_by(self, when_s: float) -> float:
        """When the robot was done with whatever it did before a moment, or came."""
        ends = [one.end_s for one in self.done] + [visit.recharge.end_s for visit in self.visits]
        ends += [stretch.end_s for stretch in self.away]
        return max((end for end in ends if ms(end) <= ms(when_s)), default=0.0)

    def _roles(self) -> list[Stretch]:
        spans: dict[int, tuple[float, float]] = {}
        for one in self.done:
            role = self.tree.action(one.leaf).role
            start, end = spans.get(role, (one.start_s, one.end_s))
            spans[role] = (min(start, one.start_s), max(end, one.end_s))
        return [
            Stretch(start, end, label, f"{label}\n{exact(start)} to {exact(end)} ({exact(end - start)})")
            for role, (start, end) in sorted(spans.items(), key=lambda span: (span[1], span[0]))
            if (label := one_line(self.tree.roles[role].label)) is not None
        ]


def _wait(robot: str, since: float, until: float, reason: str) -> Iterator[Stretch]:
    if ms(since) < ms(until):
        title = f"{robot} waits, {exact(since)} to {exact(until)} ({exact(until - since)})"
        yield Stretch(since, until, reason, f"{title}\n{reason}".rstrip())


def _way_to(visit: Visit, lit: bool) -> Stretch:
    leg = visit.recharge.leg
    assert leg is not None
    title = f"on the way to charger {visit.label}\n{leg.robot}, {exact(leg.start_s)} to {exact(leg.end_s)}\n{_distance(leg)}"
    return Stretch(leg.start_s, leg.end_s, f"{leg.distance_m:,.0f} m" if leg.distance_m >= 0.5 else "", title, lit)


def _way_home(leg: OwnLeg, lit: bool) -> Stretch:
    title = f"on the way home\n{leg.robot}, {exact(leg.start_s)} to {exact(leg.end_s)}\n{_distance(leg)}"
    return Stretch(leg.start_s, leg.end_s, f"home, {leg.distance_m:,.0f} m", title, lit)


def _distance(leg: Leg) -> str:
    return f"{leg.distance_m:.1f} m" + (f" via {', '.join(leg.via)}" if leg.via else "")


def _orders(tree: GroundedTree, bonds: Bonds, chain: Sequence[Step]) -> Iterator[Order]:
    """Where the chain changes robots, then precedence links between robots, each pair of actions once."""
    seen: set[tuple[int, int]] = set()
    for before, after in pairwise(chain):
        if before.kind in {"action", "until"} and after.kind != "wait":
            second = _waiting(bonds, before, after)
            if bonds.at[second].robot != before.robot:
                seen.add((before.leaf, second))
                yield Order(before.leaf, second, lit=True, to_end=after.kind == "until")
    for link in tree.links:
        if link.kind in IN_ORDER:
            first, last = bonds.last_below(link.first), bonds.first_below(link.second)
            if first is None or last is None or (first, last) in seen:
                continue
            if bonds.at[first].robot != bonds.at[last].robot:
                seen.add((first, last))
                yield Order(first, last)


def _waiting(bonds: Bonds, before: Step, after: Step) -> int:
    """Who waits for a step of the chain: the action after it, or the joint partner that the action waits for."""
    if after.bond == "partner":
        for mate in bonds.joint(after.leaf):
            start = Event("start", mate)
            for cause in bonds.causes(start):
                if cause.event == Event("end", before.leaf) and bonds.time(cause.event) == bonds.time(start):
                    return mate
    return after.leaf
