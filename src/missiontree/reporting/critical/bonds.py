"""
What holds back every start and every end of a schedule, read off the schedule itself.

Times are whole milliseconds, the grid of schedules. An event can be no earlier than any of its causes allows: the cause's own
time and what has to pass in between, a way or an action. It is *bound* by a cause if it comes at exactly that time.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterator
from typing import Literal, NamedTuple

from missiontree.mission.chain import Bond
from missiontree.mission.fleet import Fleet
from missiontree.mission.grounded import GroundedTree
from missiontree.mission.scene import Scene
from missiontree.mission.schedule import OwnLeg, Schedule, ScheduledAction, TravelLeg
from missiontree.mission.ticks import ticks
from missiontree.reporting.critical.refills import Detour, Detours
from missiontree.reporting.critical.spans import Spans, ms

Passing = Literal["", "action", "travel", "under_way", "refill"]


class Event(NamedTuple):
    """
    Something that happens at a moment.

    Parameters
    ----------
    kind
        Start or end of an action, or the departure of the robot that does it; or that a robot begins, or ends, to refill.
    leaf
        The action; of a visit to a charger, its place in :attr:`Bonds.detours`.
    """

    kind: Literal["start", "end", "departure", "plug", "unplug"]
    leaf: int


class Cause(NamedTuple):
    """
    Something an event has to wait for.

    Parameters
    ----------
    bond
        Why.
    event
        What comes before.
    lag
        Milliseconds that pass in between, at least.
    passing
        What happens in them; empty if none pass.
    """

    bond: Bond
    event: Event
    lag: int = 0
    passing: Passing = ""


class Bonds:
    """
    Causes of every event of a schedule.

    Parameters
    ----------
    tree
        The grounded tree.
    schedule
        A schedule over its leaves.
    scene
        Tells what robots share. Default: nothing.
    fleet
        Tells which robots come late. Default: none does.
    """

    def __init__(
        self,
        tree: GroundedTree,
        schedule: Schedule,
        scene: Scene | None = None,
        fleet: Fleet | None = None,
    ) -> None:
        self.tree = tree
        self.shared = scene.shared if scene is not None else {}
        self._ways = {leg.leaf: scene.passed(leg.via) for leg in schedule.legs} if scene is not None else {}
        self._passed = scene.passed if scene is not None else None
        self._fleet = fleet
        self.at: dict[int, ScheduledAction] = {one.leaf: one for one in schedule.actions}
        self.legs: dict[int, TravelLeg] = {leg.leaf: leg for leg in schedule.legs if self._leads(leg)}
        self._before: dict[int, int] = {}  # what stands before an action in its role
        self._joint: dict[int, list[int]] = {}
        self._robots: dict[str, list[tuple[int, int, int]]] = {}  # end, start, leaf
        self._brought: dict[str, list[int]] = {}  # leaves that move an entity
        self._used: dict[str, list[int]] = {}  # leaves done where an entity is
        room = {charger.id: charger.capacity for charger in scene.chargers} if scene is not None else {}
        self.detours = Detours(schedule, room)
        self._held_by: dict[
            str, list[tuple[int, int, Cause]]
        ] = {}  # by shared resource: from when to when, and what its end is
        self._sort_leaves()
        self._spans = Spans(tree, self.at)
        self._held = self._spans.inherited("precedence")
        self._ended_by = self._spans.inherited("until")
        self._keeps = self._reversed_until()
        self.taker = self._takers()

    def time(self, event: Event) -> int:
        """When an event happens."""
        if event.kind == "departure":
            return ms(self.legs[event.leaf].start_s)
        if event.kind in {"plug", "unplug"}:
            visit = self.detours.visits[event.leaf]
            return ms(visit.start_s if event.kind == "plug" else visit.end_s)
        one = self.at[event.leaf]
        return ms(one.start_s if event.kind == "start" else one.end_s)

    def causes(self, event: Event) -> Iterator[Cause]:
        """What an event waits for, the nearest reasons first."""
        if event.kind == "end":
            yield from self._causes_of_end(event.leaf)
        elif event.kind == "unplug":
            yield from self._causes_of_unplug(event)
        elif event.kind == "plug":
            yield from (Cause("resource", Event("unplug", other)) for other in self.detours.waited_for(event.leaf))
        elif event.kind == "departure":
            yield from self._free(event)
            yield from self._resources(event)
        else:
            yield from self._causes_of_start(event)
            yield from (Cause("partner", Event("start", mate)) for mate in self.joint(event.leaf) if mate != event.leaf)

    def released(self, event: Event) -> bool:
        """Whether an action starts at its release time, or at that of its joint work."""
        releases = (self.tree.windows[mate].release for mate in self.joint(event.leaf))
        return event.kind == "start" and max(releases) == self.time(event) > 0

    def held_back(self, event: Event) -> Literal["release", "available", "refill"] | None:
        """What holds back an event that is no other event: a release time, or that a robot is not there, or refills, before; else None."""
        if event.kind in {"plug", "unplug"}:
            return None if any(self.causes(event)) else "refill"
        if self.released(event):
            return "release"
        late = event.kind != "end" and any(
            self._comes_at(mate) == self.time(event) > 0 for mate in self.joint(event.leaf)
        )
        return "available" if late else None

    def detour_to(self, event: Event) -> Detour | None:
        """The detour to chargers that a robot ends with an event; None if it ends none then."""
        detours = self.detours.of.get(self.at[event.leaf].robot, ())
        return next((one for one in detours if one.until == self.time(event)), None)

    def leaf_of(self, event: Event) -> int:
        """The action that an event is about; of a visit to a charger, the one that the robot did before, else the first that it does."""
        if event.kind not in {"plug", "unplug"}:
            return event.leaf
        before = self.detours.holding(event.leaf).after
        robot = self.detours.visits[event.leaf].robot
        own = (one for one in self.at.values() if one.robot == robot)
        return (
            before if before is not None else min(own, key=lambda one: (ms(one.start_s), ms(one.end_s), one.leaf)).leaf
        )

    def _comes_at(self, leaf: int) -> int:
        return self.comes(self.at[leaf].robot)

    def comes(self, robot: str) -> int:
        """From when on a robot takes part, in milliseconds."""
        kind = self._fleet.type_of.get(robot) if self._fleet is not None else None
        return 0 if kind is None or self._fleet is None else ticks(kind.availability(self._fleet.robots[robot])[0])

    def shares(self, leg: OwnLeg) -> bool:
        """Whether a way leads along what robots share."""
        return self._passed is not None and bool(self._passed(leg.via))

    def joint(self, leaf: int) -> list[int]:
        """Actions that start and end together with one, itself included."""
        sync = self.tree.action(leaf).sync
        return [leaf] if sync is None else self._joint[sync]

    def last_below(self, node: int) -> int | None:
        """The scheduled action below a node that ends last; None if there is none."""
        return self._spans.last[node]

    def first_below(self, node: int) -> int | None:
        """The scheduled action below a node that starts first; None if there is none."""
        return self._spans.first[node]

    def _causes_of_end(self, leaf: int) -> Iterator[Cause]:
        if (last := self._set_end(leaf)) is not None:
            yield Cause("until", Event("end", last))
        else:
            one = self.at[leaf]
            yield Cause("start", Event("start", leaf), ms(one.end_s) - ms(one.start_s), "action")
        if leaf in self.taker:  # a hand-over ends when somebody takes over
            yield Cause("hand_over", Event("start", self.taker[leaf]))
        for open_ended in self._kept_up_by(leaf):
            yield Cause("under_way", Event("start", open_ended), 1, "under_way")

    def _causes_of_unplug(self, event: Event) -> Iterator[Cause]:
        """The last wait for room at a charger on the same detour; else what the robot did before it."""
        now, detour = self.time(event), self.detours.holding(event.leaf)
        held_up = self.detours.last_wait(event.leaf)
        if held_up is not None:
            plug = Event("plug", held_up)
            yield Cause("start", plug, now - self.time(plug), "refill")
        elif detour.after is not None:
            yield Cause("robot", Event("end", detour.after), now - detour.since, "refill")

    def _kept_up_by(self, leaf: int) -> Iterator[int]:
        """Open-ended actions that must be under way when an action ends, those that last until such a one ends included."""
        seen: set[int] = set()
        waiting = list(self.joint(leaf))
        while waiting:
            for open_ended in self._keeps.get(waiting.pop(), ()):
                if open_ended not in seen:
                    seen.add(open_ended)
                    waiting += self.joint(open_ended)
                    yield open_ended

    def _set_end(self, leaf: int) -> int | None:
        """The action whose end an open-ended one, or its joint partner, lasts until, and does."""
        for mate in self.joint(leaf):
            last = self._ended_by.get(mate) if self.tree.action(mate).open_ended else None
            if last is not None and last != leaf and ms(self.at[last].end_s) == ms(self.at[leaf].end_s):
                return last
        return None

    def _causes_of_start(self, event: Event) -> Iterator[Cause]:
        leaf = event.leaf
        if leaf in self._before:
            yield Cause("role", Event("end", self._before[leaf]))
        if leaf in self.legs:
            leg = self.legs[leaf]
            yield Cause("travel", Event("departure", leaf), max(0, ms(leg.end_s) - ms(leg.start_s)), "travel")
        if (last := self._held.get(leaf)) is not None:
            yield Cause("order", Event("end", last))
        yield from self._free(event)
        yield from self._entities(event)
        yield from self._resources(event)
        for open_ended in self._kept_up_by(leaf):
            if leaf in self._ended_by:
                yield Cause("under_way", Event("start", open_ended), 1, "under_way")

    def _free(self, event: Event) -> Iterator[Cause]:
        """The end of what the robot did before."""
        done, now = self._robots[self.at[event.leaf].robot], self.time(event)
        place = bisect_right(done, (now, now, len(self.tree.nodes)))
        latest: int | None = None
        detour = self.detour_to(event)
        for end, _, leaf in reversed(done[:place]):
            if leaf == event.leaf:
                continue
            if detour is not None and end <= detour.since < now:
                break
            if latest is not None and end < latest:
                return
            latest = end
            bond: Bond = "role" if self._before.get(event.leaf) == leaf else "robot"
            yield Cause(bond, Event("end", leaf))
        if detour is not None:
            yield Cause("refill", Event("unplug", detour.visits[-1]))

    def _entities(self, event: Event) -> Iterator[Cause]:
        """Who is brought here first, and who still needs what is to be taken away."""
        action, now = self.tree.action(event.leaf), self.time(event)
        mates = self.joint(event.leaf)
        for name in dict.fromkeys(filter(None, (action.at, *action.brings))):
            for leaf in self._brought.get(name, ()):
                if leaf not in mates and ms(self.at[leaf].end_s) <= now:
                    yield Cause("entity", Event("end", leaf))
        for name in action.brings:
            for leaf in self._used.get(name, ()):
                kind: Literal["start", "end"] = "start" if self.tree.action(leaf).open_ended else "end"
                if leaf not in mates and self.time(Event(kind, leaf)) <= now:
                    yield Cause("entity", Event(kind, leaf))

    def holds(self, event: Event) -> tuple[str, ...]:
        """Shared resources that are held from a start or a departure on."""
        leaf = event.leaf
        if event.kind == "departure":
            return self._ways.get(leaf, ())
        along = self._ways.get(leaf, ()) if self.tree.action(leaf).moves else ()
        return tuple(dict.fromkeys((*self.tree.action(leaf).holds, *along)))

    def _resources(self, event: Event) -> Iterator[Cause]:
        """Who was the last to hold a shared resource that had no room until then."""
        now = self.time(event)
        mates = [event.leaf] if event.kind == "departure" else self.joint(event.leaf)  # each has a way of its own
        for name in self.holds(event):
            wanted = 1
            if event.kind == "start":
                wanted = sum(name in self.holds(Event("start", mate)) for mate in mates)
            held = [one for one in self._held_by.get(name, ()) if one[2].event.leaf not in mates]
            before = [(end, cause) for start, end, cause in held if start < now <= end]
            if name in self.shared and len(before) + wanted > self.shared[name].capacity:
                yield from (cause for end, cause in before if end == now)

    def _leads(self, leg: TravelLeg) -> bool:
        """Whether a leg leads to a scheduled action and is not that action itself."""
        return leg.leaf in self.at and not self.tree.action(leg.leaf).moves

    def _sort_leaves(self) -> None:
        last_of_role: dict[int, int] = {}
        for leaf in sorted(self.at):
            action, one = self.tree.action(leaf), self.at[leaf]
            if action.role in last_of_role:
                self._before[leaf] = last_of_role[action.role]
            last_of_role[action.role] = leaf
            self._robots.setdefault(one.robot, []).append((ms(one.end_s), ms(one.start_s), leaf))
            if action.sync is not None:
                self._joint.setdefault(action.sync, []).append(leaf)
            if action.at is not None:
                self._used.setdefault(action.at, []).append(leaf)
            for name in self.holds(Event("start", leaf)):
                over = Cause("resource", Event("end", leaf))
                self._held_by.setdefault(name, []).append((ms(one.start_s), ms(one.end_s), over))
            if leaf in self.legs:
                start, end = ms(self.legs[leaf].start_s), ms(self.legs[leaf].end_s)
                over = Cause("resource", Event("departure", leaf), end - start, "travel")
                for name in self._ways.get(leaf, ()):
                    self._held_by.setdefault(name, []).append((start, end, over))
            for name in action.brings:
                self._brought.setdefault(name, []).append(leaf)
        for done in self._robots.values():
            done.sort()

    def _takers(self) -> dict[int, int]:
        """By action that ends with a hand-over: the action that takes over."""
        found: dict[int, int] = {}
        for link in self.tree.links:
            last, first = self.last_below(link.first), self.first_below(link.second)
            if link.kind == "hand_over" and last is not None and first is not None:
                found |= dict.fromkeys(self.joint(last), first)
        return found

    def _reversed_until(self) -> dict[int, list[int]]:
        """By action: the open-ended actions that must be under way when it ends, by whichever link."""
        keeps: dict[int, list[int]] = {}
        links = [link for link in self.tree.links if link.kind == "until"]
        for leaf in sorted(self.at) if links else ():
            if self.tree.action(leaf).open_ended:
                above = self._spans.above(leaf)
                lasts = {self._spans.last[link.second] for link in links if link.first in above}
                for last in lasts:
                    if last is not None and last != leaf:
                        keeps.setdefault(last, []).append(leaf)
        return keeps
