"""
Robots of a type that travel: each robot that takes part makes a tour over its roles.

Node 0 is where tours begin and end, then comes a node per robot, then one per role. An arc from a role to another says that a robot
does the second right after the first, and how long it is under way between. A role done anywhere leaves its robot where it was.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from itertools import product

from missiontree.estimation.travel import Blocked
from missiontree.scheduling.cpsat.crew import Crew, uses_of
from missiontree.scheduling.cpsat.heads import Spans, count_heads
from missiontree.scheduling.cpsat.model import FAR, Affine, ExactlyOne, Linear, Model, Routes, negated
from missiontree.scheduling.cpsat.ordering import Ordering
from missiontree.scheduling.cpsat.placing import Stations, Way, Where
from missiontree.scheduling.cpsat.staff import MOST_FACTOR, Staff, least_whole, scale_of, whole
from missiontree.scheduling.cpsat.times import Times
from missiontree.scheduling.cpsat.travel import Distances, Legs, home_after
from missiontree.scheduling.cpsat.unsupported import TimeIsUpError, UnsupportedError
from missiontree.scheduling.own_work import own_work
from missiontree.scheduling.problem import Problem
from missiontree.scheduling.trips import Spot, Trip

MOST_ARCS = 40_000


class Tours:
    """
    The tours of one crew.

    Parameters
    ----------
    model, problem, crew
        What is built, of what, for whom.
    times, spans, stations, ordering, legs, distances
        Its parts so far.
    over
        Asked now and then whether time is up.
    """

    def __init__(
        self,
        model: Model,
        problem: Problem,
        crew: Crew,
        times: Times,
        spans: Spans,
        stations: Stations,
        ordering: Ordering,
        legs: Legs,
        distances: Distances,
        over: Callable[[], bool],
    ) -> None:
        self._model, self._problem, self.crew = model, problem, crew
        self._times, self._spans, self._stations, self._ordering = times, spans, stations, ordering
        self._legs, self._distances, self._time_is_up = legs, distances, over
        self.arcs: dict[tuple[int, int], int] = {}  # nodes to literal
        self._first_node = 1 + len(crew.members)
        self._node = {role: self._first_node + number for number, role in enumerate(crew.roles)}
        if (len(crew.roles) + len(crew.members)) * len(crew.roles) > MOST_ARCS:
            raise UnsupportedError(f"{len(crew.roles)} roles of {crew.kind.label!r} are too many stops for tours")
        self._passing = {role: self._anywhere(role) for role in crew.roles if stations.first[role] is None}
        self._add_arcs()
        self.staff = self._add_staff()
        self._add_times()
        self._homes = tuple(self._ways_home()) if problem.returning else ()
        self._add_homes()
        self._add_work()
        count_heads(model, crew, spans, crew.usable)
        self._add_budgets()
        self._add_leaving()
        self._take_part()

    def node(self, role: int) -> int:
        """Node of a role."""
        return self._node[role]

    def tour(self, values: list[int]) -> dict[int, list[int]]:
        """Roles of each member in order, by the values of an answer."""
        after = {
            tail: head
            for (tail, head), literal in self.arcs.items()
            if tail and (values[literal] if literal >= 0 else not values[negated(literal)])
        }
        found: dict[int, list[int]] = {}
        for number in range(len(self.crew.members)):
            node = after[1 + number]
            while node:
                found.setdefault(number, []).append(self.crew.roles[node - self._first_node])
                node = after[node]
        return found

    def _anywhere(self, role: int) -> Where:
        """Literals of where a robot is during a role that is done anywhere."""
        spots: dict[Spot, None] = dict.fromkeys(member.start for member in self.crew.members)
        for other in self.crew.roles:
            last = self._stations.last[other]
            if last is not None:
                spots |= dict.fromkeys(self._stations.where[last])
        found = {spot: self._model.boolean() for spot in spots}
        self._model.add(ExactlyOne(tuple(found.values())))
        return found

    def _add_arcs(self) -> None:
        roles, model = self.crew.roles, self._model
        for number in range(len(self.crew.members)):
            self.arcs[0, 1 + number] = model.true
            self.arcs[1 + number, 0] = model.boolean()
            for role in roles:
                self.arcs[1 + number, self.node(role)] = model.boolean()
        for role in roles:
            if self._time_is_up():
                raise TimeIsUpError
            self.arcs[self.node(role), 0] = model.boolean()
            for other in roles:
                if role != other and self._may_follow(role, other):
                    self.arcs[self.node(role), self.node(other)] = model.boolean()
        model.add(Routes(tuple((tail, head, literal) for (tail, head), literal in self.arcs.items())))
        self._into_node: dict[int, list[tuple[int, int]]] = {}
        for (tail, head), literal in self.arcs.items():
            self._into_node.setdefault(head, []).append((tail, literal))

    def _may_follow(self, role: int, other: int) -> bool:
        """Whether a robot can do the other role right after this one."""
        graph, bounds = self._problem.graph, self._problem.bounds
        first, last = graph.activity_of[graph.roles[other][0]], graph.activity_of[graph.roles[role][-1]]
        for mine in graph.roles[role]:
            for its in graph.roles[other]:
                activity, its_activity = graph.activity_of[mine], graph.activity_of[its]
                if activity == its_activity or self._ordering.certain(its_activity, activity):
                    return False
        return bounds.heads[2 * last + 1] <= self._times.horizon - bounds.tails[2 * first]

    def _add_staff(self) -> Staff | None:
        crew, model = self.crew, self._model
        homes = {member.start for member in crew.members} if self._problem.returning else set()
        indifferent = len(crew.groups) == len(crew.roles) and len(homes) <= 1
        if not crew.apart and (len(crew.members) == 1 or indifferent):
            return None
        staff = Staff(model, self._problem, crew)
        group_of = self._problem.staffing.group_of
        for (tail, head), literal in self.arcs.items():
            if head < self._first_node or tail == 0:
                continue
            group = group_of[crew.roles[head - self._first_node]]
            if tail < self._first_node:
                model.implies((literal,), staff.fills[group, tail - 1])
                continue
            before = group_of[crew.roles[tail - self._first_node]]
            for number in range(len(crew.members)) if before != group else ():
                model.implies((literal, staff.fills[before, number]), staff.fills[group, number])
                model.implies((literal, staff.fills[group, number]), staff.fills[before, number])
        return staff

    def _add_times(self) -> None:
        stations, spans = self._stations, self._spans
        for role in self.crew.roles:
            if self._time_is_up():
                raise TimeIsUpError
            first = stations.first[role]
            for tail, taken in self._into(role):
                here, over = self._left_at(tail), self._over(tail)
                self._model.at_least(spans.start(role), over, 0, (taken,))
                if first is None:
                    self._stay(here, taken, role)
                    continue
                for origin, is_there in here.items():
                    for goal, goes_there in stations.where[first].items():
                        when = tuple(one for one in (taken, is_there, goes_there) if one != self._model.true)
                        self._come(first, stations.way(first, origin, goal), over, when)

    def _ways_home(self) -> Iterator[tuple[int, Way | None, tuple[int, ...]]]:
        """Every way home that a tour may end with: the role before it, the way (None if there is none), and what holds then."""
        crew, trips, group_of = self.crew, self._problem.trips, self._problem.staffing.group_of
        one_home = len({member.start for member in crew.members}) == 1
        for role in crew.roles:
            if self._time_is_up():
                raise TimeIsUpError
            ends = self.arcs[self.node(role), 0]
            for number, member in enumerate(crew.members[:1] if one_home else crew.members):
                who = () if one_home or self.staff is None else (self.staff.fills[group_of[role], number],)
                for spot, is_there in self._left_at(self.node(role)).items():
                    when = tuple(literal for literal in (ends, *who, is_there) if literal != self._model.true)
                    if self._model.false not in when:
                        yield role, _way(trips.approach(crew.kind.id, spot, member.start)), when

    def _add_homes(self) -> None:
        """The mission lasts until everybody is home."""
        for role, way, when in self._homes:
            if way is None:
                self._model.clause(*(negated(literal) for literal in when))
                continue
            self._model.at_least(Affine(self._times.makespan), self._spans.end(role), way.ticks, when)
            self._distances.least(home_after(role), way.mm, when)

    def _add_work(self) -> None:
        """
        All tours together last no longer than the robots that make them are there.

        That is nothing new, but said as one sum over arcs: of a chain of times the relaxation knows next to nothing; from the sum, with the
        cuts that keep tours whole, it knows how long the least ones are (Dantzig, Fulkerson and Johnson 1954).
        """
        crew, model, graph, bounds = self.crew, self._model, self._problem.graph, self._problem.bounds
        first = self._stations.first
        work = sum(own_work(graph, bounds.duration, bounds.lag, role, first[role]) for role in crew.roles)
        absent = [
            (member.since, self.arcs[1 + number, 0]) for number, member in enumerate(crew.members) if member.since
        ]
        terms = [*self._least_ways(), *self._least_ways_home(), *((-since, idle) for since, idle in absent)]
        there = (-crew.usable, self._times.makespan)
        model.add(Linear((*terms, there), -FAR, -work - sum(since for since, _ in absent)))

    def _least_ways(self) -> Iterator[tuple[int, int]]:
        """For every arc to a role, the least that the way takes."""
        for role in self.crew.roles:
            first = self._stations.first[role]
            if first is None or self._problem.graph.activity_of[first] in self._problem.graph.until:
                continue
            for tail, taken in self._into(role):
                pairs = product(self._left_at(tail), self._stations.where[first])
                ways = [way for pair in pairs if (way := self._stations.way(first, *pair)) is not None]
                if least := min((way.ticks for way in ways), default=0):
                    yield least, taken

    def _least_ways_home(self) -> Iterator[tuple[int, int]]:
        least: dict[int, int] = {}
        for role, way, _ in self._homes:
            if way is not None:
                least[role] = min(way.ticks, least.get(role, way.ticks))
        return ((ticks, self.arcs[self.node(role), 0]) for role, ticks in least.items() if ticks)

    def _come(self, leaf: int, way: Way | None, over: Affine, when: tuple[int, ...]) -> None:
        if leaf in self._stations.before:
            over = self._times.end[self._problem.graph.activity_of[self._stations.before[leaf]]]
        self._legs.takes(leaf, way, over, when)
        if way is None:
            return
        if len(when) == 1:
            if way.mm:
                self._distances.arcs.setdefault(leaf, []).append((way.mm, when[0]))
        else:
            self._distances.least(leaf, way.mm, when)

    def _stay(self, here: Where, taken: int, role: int) -> None:
        for spot, literal in here.items():
            self._model.implies((taken, literal), self._passing[role][spot])

    def _into(self, role: int) -> list[tuple[int, int]]:
        """Nodes from which an arc leads to a role, with its literal."""
        return self._into_node[self._node[role]]

    def _left_at(self, node: int) -> Where:
        """Where a robot is when it leaves a node."""
        if node < self._first_node:
            return {self.crew.members[node - 1].start: self._model.true}
        role = self.crew.roles[node - self._first_node]
        last = self._stations.last[role]
        return self._passing[role] if last is None else self._stations.where[last]

    def _over(self, node: int) -> Affine:
        """When a robot leaves a node at the earliest."""
        if node < self._first_node:
            return Affine(None, self.crew.members[node - 1].since)
        return self._spans.end(self.crew.roles[node - self._first_node])

    def _take_part(self) -> None:
        """Who must take part does, no more do than may, and of equal robots the first ones do."""
        crew, model = self.crew, self._model
        idle = [self.arcs[1 + number, 0] for number in range(len(crew.members))]
        for number, member in enumerate(crew.members):
            if member.required:
                model.clause(negated(idle[number]))
            if number and crew.classes[number] == crew.classes[number - 1] and self.staff is None:
                model.implies((idle[number - 1],), idle[number])
        if crew.usable < len(crew.members):
            model.add(Linear(tuple((1, literal) for literal in idle), len(idle) - crew.usable, len(idle)))

    def _add_leaving(self) -> None:
        """Nobody is kept longer than it stays: along a tour, every role knows when its robot leaves."""
        crew, model, far = self.crew, self._model, self._times.horizon
        if all(member.until is None for member in crew.members):
            return
        leaves = {role: Affine(model.integer(0, far)) for role in crew.roles}
        for role in crew.roles:
            model.at_least(leaves[role], self._spans.end(role))
            for tail, taken in self._into(role):
                if tail >= self._first_node:
                    model.at_least(leaves[crew.roles[tail - self._first_node]], leaves[role], 0, (taken,))
                elif (until := crew.members[tail - 1].until) is not None:
                    model.at_least(Affine(None, until), leaves[role], 0, (taken,))
        for role, way, when in self._homes:
            if way is not None:
                model.at_least(leaves[role], self._spans.end(role), way.ticks, when)

    def _add_budgets(self) -> None:
        """What is left of a budget, role by role along a tour."""
        budgets = {name for member in self.crew.members for name in member.budget}
        for name in sorted(budgets):
            self._add_budget(name)

    def _add_budget(self, name: str) -> None:
        crew, model, graph = self.crew, self._model, self._problem.graph
        most = max(member.budget.get(name, 0.0) for member in crew.members)
        scale, per_mm = scale_of(most), crew.kind.uses_per_m.get(name, 0.0) / 1000
        full = whole(most, scale)
        left = {role: model.integer(0, full) for role in crew.roles}
        limited = self._limited(name)
        factor = min(MOST_FACTOR, int(per_mm * scale * (1 - 1e-9)))
        for role in crew.roles:
            need = least_whole(uses_of(self._problem, role).get(name, 0.0), scale)
            leaves = graph.roles[role]
            known = sum(self._distances.known.get(leaf, 0) for leaf in leaves)
            varying = [(factor, self._distances.varying[leaf]) for leaf in leaves if leaf in self._distances.varying]
            arc_mm = {taken: mm for leaf in leaves for mm, taken in self._distances.arcs.get(leaf, ())}
            for tail, taken in self._into(role):
                # millimetres are rounded: by as many the model allows too much
                spent = need + factor * (known + arc_mm.get(taken, 0) - 1 - len(leaves))
                spend = ((1, left[role]), *varying)
                if tail < self._first_node:
                    member = crew.members[tail - 1]
                    if name in member.budget:
                        there = whole(member.budget[name], scale)
                        model.add(Linear(spend, -FAR, there - spent, (taken,)))
                else:
                    before = left[crew.roles[tail - self._first_node]]
                    when = tuple(one for one in (taken, limited[role]) if one != model.true)
                    model.add(Linear((*spend, (-1, before)), -FAR, -spent, when))

        for role, way, when in self._homes:
            if way is not None and way.mm > 1 and factor:
                home = tuple(one for one in (*when, limited[role]) if one != model.true)
                model.add(Linear(((1, left[role]),), factor * (way.mm - 1), FAR, home))

    def _limited(self, name: str) -> dict[int, int]:
        """By role the literal that its robot has only so much of a budget."""
        crew, model = self.crew, self._model
        if all(name in member.budget for member in crew.members):
            return dict.fromkeys(crew.roles, model.true)
        found = {role: model.boolean() for role in crew.roles}
        for role, literal in found.items():
            for tail, taken in self._into(role):
                if tail < self._first_node:
                    has_limit = name in crew.members[tail - 1].budget
                    model.implies((taken,), literal if has_limit else negated(literal))
                else:
                    before = found[crew.roles[tail - self._first_node]]
                    model.implies((taken, before), literal)
                    model.implies((taken, literal), before)
        return found


def _way(trip: Trip | Blocked) -> Way | None:
    return None if isinstance(trip, Blocked) else Way(trip.ticks, round(trip.metres * 1000), trip.metres)
