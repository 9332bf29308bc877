"""Detours to chargers, as stretches between two things that a robot does, and who had to leave a charger first."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

from missiontree.mission.schedule import Recharge, Schedule
from missiontree.reporting.critical.spans import ms


class Detour(NamedTuple):
    """
    Visits to chargers with nothing but ways and waits between them.

    Parameters
    ----------
    since, until
        From when to when, in milliseconds: from the end of what the robot did before, if it did anything, else from when it leaves for the
        first charger; to the end of the last visit.
    visits
        Their places in :attr:`Detours.visits`, in order of time.
    after
        The action before it; None if there is none.
    """

    since: int
    until: int
    visits: tuple[int, ...]
    after: int | None


class Detours:
    """
    The detours of a schedule.

    Parameters
    ----------
    schedule
        A schedule.
    room
        How many robots may refill at one time, by charger; one that is not named has room for everybody.
    """

    def __init__(self, schedule: Schedule, room: Mapping[str, int]) -> None:
        self.visits: Sequence[Recharge] = sorted(schedule.recharges, key=lambda one: (one.robot, one.start_s))
        self.of: dict[str, list[Detour]] = {}
        self._room = room
        self._since: list[int] = []  # by visit: when the robot could have begun it, if there had been room
        self._found: list[Detour] = []  # by visit
        ends: dict[str, list[tuple[int, int]]] = {}
        for done in schedule.actions:
            ends.setdefault(done.robot, []).append((ms(done.end_s), done.leaf))
        for place, visit in enumerate(self.visits):
            self._add(place, visit, ends.get(visit.robot, ()))
        for detours in self.of.values():
            for detour in detours:
                self._found += [detour] * len(detour.visits)

    def _add(self, place: int, visit: Recharge, ends: Sequence[tuple[int, int]]) -> None:
        own = self.of.setdefault(visit.robot, [])
        leaves = ms(visit.leg.start_s if visit.leg is not None else visit.start_s)
        over, after = max(((end, leaf) for end, leaf in ends if end <= leaves), default=(-1, None))
        goes_on = bool(own) and over <= own[-1].since
        free = own[-1].until if goes_on else max(over, 0)
        self._since.append(free if visit.leg is None else ms(visit.leg.end_s))
        if goes_on:
            own[-1] = own[-1]._replace(until=ms(visit.end_s), visits=(*own[-1].visits, place))
        else:
            own.append(Detour(leaves if after is None else over, ms(visit.end_s), (place,), after))

    def holding(self, visit: int) -> Detour:
        """The detour that a visit is part of."""
        return self._found[visit]

    def waited_for(self, visit: int) -> Iterator[int]:
        """Visits of others that end just when one begins for which there was no room before."""
        one, begins = self.visits[visit], ms(self.visits[visit].start_s)
        if one.charger not in self._room or self._since[visit] >= begins:
            return
        there = [
            place
            for place, other in enumerate(self.visits)
            if other.charger == one.charger and place != visit and ms(other.start_s) < begins <= ms(other.end_s)
        ]
        if len(there) >= self._room[one.charger]:
            yield from (place for place in there if ms(self.visits[place].end_s) == begins)

    def last_wait(self, visit: int) -> int | None:
        """The last visit up to one, in the same detour, that others held up; None if there is none."""
        held_up = [place for place in self.holding(visit).visits if place <= visit and [*self.waited_for(place)]]
        return held_up[-1] if held_up else None
