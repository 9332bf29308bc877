"""
Large neighbourhood search over the tours of robots, for missions that are too large for one constraint model.

A few roles, one of them on a longest path, are taken out of their tours and put in again one by one where the longest path stays shortest
and the least way is added ("ruin and recreate": Schrimpf, Schneider, Stamm-Wilbrandt and Dueck, Journal of Computational Physics 159, 2000;
those out are near each other: Shaw 1998). Where a role may go, and how long the path through it would be, is told by longest paths before
and after. What is not much worse than what was held some steps ago is held (late acceptance: Burke and Bykov, European Journal of
Operational Research 258, 2017). Budgets, shared resources and deadlines are left out of that; whatever looks better than the best is
played through with all rules, and counts only then.
Where robots refill, or wait for room on ways, which takes longer or shorter with every order, whatever is tried may be played through,
and held for what comes of it.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from random import Random

from missiontree.scheduling.course import along, tours_of
from missiontree.scheduling.neighbourhood.network import FAR, Network, Paths
from missiontree.scheduling.neighbourhood.stops import Stops, stops_of
from missiontree.scheduling.problem import FILLINGS, Draft, Filling, Problem
from missiontree.scheduling.replay import replay
from missiontree.scheduling.trips import Spot

FEWEST_ROLES, FEWEST_TO_PASS = 6, 2
"""Of a mission that is searched; and of one where robots pass each other on ways that have no room for all, which no model knows."""
MOST_OUT, ALL_OUT = 12, 150
"""Roles taken out at once; and roles of a mission of which all are, in the first step."""
ANYWHERE, SOON = 0.1, 0.4
"""Shares of the steps in which they are chosen by chance, and by when they are done; in the rest, by where."""
MEMORY = 100
"""Steps back that are compared with."""
NOISE, BLIND_NOISE = 0.01, 0.5
"""By how much places are misjudged on purpose, as a share of the makespan; and half of the time where paths do not know all that counts."""
REFUSED = 30
"""Better tours in a row that break another rule, after which the search ends."""

Tours = dict[str, list[int]]


@dataclass(frozen=True)
class Regrouping:
    """
    How it is searched.

    Parameters
    ----------
    seed
        Of what is taken out.
    rounds
        How often something is taken out; None (default): until it is ended.
    patient
        Whether whatever is tried is played through, and held for what comes of it. Where robots refill, or wait for room on ways, it takes
        long, and finds much more. Default: only what looks better than the best is.
    """

    seed: int = 0
    rounds: int | None = None
    patient: bool = False


def regrouped(
    problem: Problem, draft: Draft, how: Regrouping, ended: Callable[[], bool], told: Callable[[Draft], None]
) -> Draft:
    """
    The best draft that is found; the one handed in if none is better.

    Parameters
    ----------
    problem, draft
        The mission and a schedule of it.
    how
        How it is searched.
    ended
        Whether to stop.
    told
        Told of each better draft.
    """
    stops = stops_of(problem)
    if stops is None or len(stops.of) < (FEWEST_TO_PASS if problem.sharing.on_ways else FEWEST_ROLES):
        return draft
    return _Search(problem, draft, stops, how, told).best(how.rounds, ended)


class _Search:
    def __init__(
        self, problem: Problem, draft: Draft, stops: Stops, how: Regrouping, told: Callable[[Draft], None]
    ) -> None:
        self._problem, self._draft, self._stops, self._told = problem, draft, stops, told
        self._network = Network(problem, stops)
        self._luck = Random(how.seed)  # noqa: S311 - luck for a search, not for secrets
        staffing = problem.staffing
        self._group = staffing.group_of
        self._loose = [role for role in stops.of if len(staffing.members[self._group[role]]) == 1]
        self._robots = {kind.id: [robot.id for robot in kind.members] for kind in problem.fleet.types}
        self._refused, self._patient = 0, how.patient

    def best(self, rounds: int | None, ended: Callable[[], bool]) -> Draft:
        """Search."""
        tours = self._tours()
        paths = self._network.measured(tours)
        if paths is None or not self._loose:
            return self._draft
        cost = self._cost(paths, self._draft if self._patient else None)
        memory, done, mark = [cost] * MEMORY, 0, paths.makespan
        while (rounds is None or done < rounds) and not ended() and self._refused < REFUSED:
            if self._draft.makespan == self._problem.bounds.makespan:
                break
            out = self._loose if not done and len(self._loose) <= ALL_OUT else self._chosen(paths)
            done += 1
            trial = self._recreated({robot: list(roles) for robot, roles in tours.items()}, [*out], ended)
            measured = self._network.measured(trial) if trial is not None else None
            if trial is None or measured is None:
                continue
            played = None
            if self._patient:
                hopeless = self._cost(measured, None) > max(cost, memory[done % MEMORY])  # waits come on top
                played = None if hopeless else self._played(trial, ("rest",))
                if played is None:
                    continue
                self._keep(played)
            elif (
                measured.makespan < mark
            ):  # what paths do not know of, such as ways home, is as long for both, as far as one can tell
                if not self._keep(self._played(trial, FILLINGS)):
                    continue
                mark = measured.makespan
            found = self._cost(measured, played)
            if found <= cost or found <= memory[done % MEMORY]:
                tours, paths, cost = trial, measured, found
            memory[done % MEMORY] = min(cost, memory[done % MEMORY])
        return self._draft

    def _tours(self) -> Tours:
        everybody: Tours = {robot: [] for robots in self._robots.values() for robot in robots}
        return everybody | tours_of(self._draft, self._problem.graph)

    def _cost(self, paths: Paths, played: Draft | None) -> float:
        """The makespan, as it was played if it was, and a little of when roles end, so that robots who are done sooner count."""
        ends = [paths.head[2 * stop.last + 1] for stop in self._stops.of.values()]
        return (paths.makespan if played is None else played.makespan) + 0.05 * sum(ends) / len(ends)

    def _played(self, tours: Tours, refills: Sequence[Filling]) -> Draft | None:
        """Tours, played through with all rules; None if that cannot be."""
        return replay(self._problem, along(tours), refills)

    def _keep(self, draft: Draft | None) -> bool:
        """Keep what was played if it is better in truth; whether it is."""
        if draft is None or draft.makespan >= self._draft.makespan:
            self._refused += not self._patient
            return False
        self._refused, self._draft = 0, draft
        self._told(draft)
        return True

    # --- out and in again -------------------------------------------------------------------------------------------

    def _recreated(self, tours: Tours, out: list[int], ended: Callable[[], bool]) -> Tours | None:
        """Tours with some roles taken out and put in again; None if one can go nowhere, or it is ended before."""
        gone = set(out)
        for robot, roles in tours.items():
            tours[robot] = [role for role in roles if role not in gone]
        self._luck.shuffle(out)
        for role in out:
            left = None if ended() else self._network.measured(tours)
            if left is None or not self._put_in(tours, role, left):
                return None
        return tours

    def _chosen(self, paths: Paths) -> list[int]:
        """A role on a longest path, and others near it in time or as urgent."""
        luck, stops = self._luck, self._stops.of
        critical = [
            role
            for role in self._loose
            if paths.head[2 * stops[role].first] + paths.tail[2 * stops[role].first] == paths.makespan
        ]
        seed = luck.choice(critical or self._loose)
        many = min(len(self._loose), luck.randint(1, MOST_OUT))
        middle = paths.head[2 * stops[seed].first]
        spot, chance = stops[seed].origin, luck.random()

        def far(role: int) -> int:
            return abs(paths.head[2 * stops[role].first] - middle) if chance < SOON else self._network.way(role, spot)

        if chance < ANYWHERE:
            others = luck.sample(self._loose, many)
        else:
            others = sorted(self._loose, key=lambda role: (1.0 + luck.random()) * (far(role) + 1))[:many]
        return list(dict.fromkeys([seed, *others]))[:many]

    def _put_in(self, tours: Tours, role: int, paths: Paths) -> bool:
        """Where the longest path stays shortest and the least way is added; False if it can go nowhere."""
        luck = self._luck
        share = BLIND_NOISE if self._patient and luck.random() < 0.5 else NOISE
        noise = share * paths.makespan * luck.random()
        places = (
            (cost + noise * luck.random(), robot, place) for cost, robot, place in self._places(tours, role, paths)
        )
        best = min(places, default=None)
        if best is None:
            return False
        tours[best[1]].insert(best[2], role)
        return True

    def _places(self, tours: Tours, role: int, paths: Paths) -> Iterator[tuple[int, str, int]]:
        """Where a role can go: the longest path then, with the way that it adds; the robot, and the place in its tour."""
        network, stop, head, tail = self._network, self._stops.of[role], paths.head, paths.tail
        ready, rest, waiting = head[2 * stop.first], tail[2 * stop.last + 1], network.waiting(role, paths)
        for robot in self._robots[self._problem.staffing.type_of[role]]:
            roles = tours[robot]
            if not self._may_join(role, roles):
                continue
            spot, free = network.start[robot], network.since[robot]
            for place, follows in enumerate([*roles, None]):
                next_stop = None if follows is None else self._stops.of[follows]
                if next_stop is None or ready < head[2 * next_stop.last + 1] or ready == head[2 * next_stop.first]:
                    way, onward = network.way(role, spot), self._onward(robot, stop.left_at(spot), follows)
                    left = max(rest, onward + (0 if next_stop is None else tail[2 * next_stop.first]))
                    instead = self._onward(robot, spot, follows) if roles else 0
                    if way + left < FAR:
                        through = max(ready, free) + way + stop.length + left
                        yield max(through, paths.makespan) + way + onward - instead, robot, place
                if next_stop is None or 2 * next_stop.last + 1 in waiting:
                    break
                spot, free = next_stop.left_at(spot), head[2 * next_stop.last + 1]

    def _onward(self, robot: str, spot: Spot, follows: int | None) -> int:
        """The way from a spot to the role that follows, or home."""
        return self._network.home(robot, spot) if follows is None else self._network.way(follows, spot)

    def _may_join(self, role: int, roles: list[int]) -> bool:
        staffing = self._problem.staffing
        group = self._group[role]
        if not staffing.avoids[group] and not staffing.wears[group]:
            return True
        others = [self._group[other] for other in roles]
        return not any(
            staffing.avoids[group] & staffing.wears[other] or staffing.wears[group] & staffing.avoids[other]
            for other in others
        )
