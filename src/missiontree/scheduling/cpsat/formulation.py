"""
One alternative as a constraint model: the parts, in the order in which they need each other.

Whatever cannot be said exactly is said more loosely, so that the least value of the model is never above that of the mission, and
every answer is replayed by our own means before anything is made of it. So does what robots can refill last for ever here.
"""

from __future__ import annotations

from collections.abc import Callable

from missiontree.mission.control import never
from missiontree.scheduling.course import Course, begun_is_enough, passings
from missiontree.scheduling.cpsat.crew import Crew, crews, uses_of
from missiontree.scheduling.cpsat.heads import Spans, add_heads
from missiontree.scheduling.cpsat.model import FAR, Affine, Linear, Model, negated
from missiontree.scheduling.cpsat.ordering import Ordering
from missiontree.scheduling.cpsat.orders import keep_to_orders
from missiontree.scheduling.cpsat.placing import Stations
from missiontree.scheduling.cpsat.shared import add_sharing
from missiontree.scheduling.cpsat.staff import MOST_FACTOR, Staff, least_whole, scale_of, whole
from missiontree.scheduling.cpsat.things import Things
from missiontree.scheduling.cpsat.times import Times
from missiontree.scheduling.cpsat.tours import Tours
from missiontree.scheduling.cpsat.travel import Distances, Legs, home_after
from missiontree.scheduling.cpsat.unsupported import UnsupportedError
from missiontree.scheduling.problem import Draft, Problem
from missiontree.scheduling.recharging import may_wait_at_chargers
from missiontree.scheduling.room import order_of_events, turns


class Formulation:
    """
    The model of a problem.

    Parameters
    ----------
    problem
        The alternative.
    horizon
        Ticks by which everything must be over.
    over
        Asked now and then whether time is up. Default: it never is.

    Raises
    ------
    UnsupportedError
        If the mission has something that the model does not express.
    TimeIsUpError
        If time was up before.
    """

    def __init__(self, problem: Problem, horizon: int, over: Callable[[], bool] = never) -> None:
        if may_wait_at_chargers(problem):
            raise UnsupportedError(
                "robots may refill while they wait, and be nearer to what comes next than where they were"
            )
        self.problem, self.model = problem, Model()
        model = self.model
        self.stations = Stations(model, problem)
        self.times = Times(model, problem, self.stations, horizon)
        self.ordering = Ordering(model, problem)
        self.things = Things(model, problem, self.times, self.stations, self.ordering)
        self.distances = Distances(model)
        legs = Legs(model, problem, self.times, self.stations, self.distances)
        legs.inside_roles()
        spans = Spans(model, problem, self.times)
        self.tours: list[Tours] = []
        self.heads: list[tuple[Crew, Staff | None]] = []
        for crew in crews(problem):
            if crew.tours:
                parts = (self.times, spans, self.stations, self.ordering, legs, self.distances, over)
                self.tours.append(Tours(model, problem, crew, *parts))
            else:
                self.heads.append((crew, add_heads(model, problem, crew, spans)))
        self._add_totals()
        add_sharing(model, problem, self.times)
        self.minimise_makespan()

    def minimise_makespan(self) -> None:
        """The first thing that counts."""
        self.model.objective = ((1, self.times.makespan),)

    def keep_to_orders(self) -> bool:
        """From now on, forbid what times allow and no order of events does (see :mod:`orders`); False if the model is no other for it."""
        before = len(self.model.constraints)
        staffs = [staff for _, staff in self.heads if staff is not None]
        keep_to_orders(self.model, self.problem, self.times, self.ordering, self.tours, staffs)
        return len(self.model.constraints) > before

    def minimise_travel(self, makespan: int) -> bool:
        """The second, with the makespan kept; False if there is nothing to gain."""
        self.times.no_later(((1, self.times.makespan),), makespan)
        self.model.objective = tuple(self._travel()[0])
        return bool(self.model.objective)

    def minimise_ends(self, travel_mm: int) -> None:
        """The third, with travel kept."""
        terms, offset = self._travel()
        if terms:
            self.times.no_later(tuple(terms), travel_mm - offset)
        self.model.objective = self.times.total_of_ends()[0]

    def travel_mm(self, draft: Draft) -> int:
        """Millimetres of a draft, each way rounded as in the model."""
        trips = [one.trip for one in draft.done]
        trips += [*(one.trip for one in draft.returns), *(one.trip for one in draft.refills)]
        return sum(round(trip.metres * 1000) for trip in trips if trip is not None)

    def _travel(self) -> tuple[list[tuple[int, int]], int]:
        graph = self.problem.graph
        return self.distances.of((*graph.activity_of, *(home_after(role) for role in graph.roles)))

    def _add_totals(self) -> None:
        """What all robots of a type, or all robots, may use together, ways included."""
        for tours in self.tours:
            for name, there in tours.crew.kind.total_limits.items():
                self._add_total(name, there, [tours])
        for name, there in self.problem.shared.items():
            self._add_total(name, there, self.tours)

    def _add_total(self, name: str, there: float, tours: list[Tours]) -> None:
        per_m = {one.crew.kind.id: one.crew.kind.uses_per_m.get(name, 0.0) for one in tours}
        if not any(per_m.values()):
            return
        graph, scale, terms, spent = self.problem.graph, scale_of(there), [], 0
        everybody = len(tours) == len(self.tours) and name in self.problem.shared
        roles = list(graph.roles) if everybody else [role for one in tours for role in one.crew.roles]
        for role in roles:
            spent += least_whole(uses_of(self.problem, role).get(name, 0.0), scale)
        for one in tours:
            factor = min(MOST_FACTOR, int(per_m[one.crew.kind.id] / 1000 * scale * (1 - 1e-9)))
            own = one.crew.roles
            leaves = (*(leaf for role in own for leaf in graph.roles[role]), *(home_after(role) for role in own))
            ways, known = self.distances.of(leaves)
            terms += [(factor * mm, variable) for mm, variable in ways]
            spent += factor * (known - len(leaves))
        if terms:
            self.model.add(Linear(tuple(terms), -FAR, whole(there, scale) - spent))

    def course(self, values: list[int]) -> Course:
        """What an answer of the solver decides."""
        robots: dict[int, str] = {}
        tours: dict[str, list[int]] = {}
        for one in self.tours:
            for number, roles in one.tour(values).items():
                name = one.crew.members[number].name
                tours[name] = roles
                robots |= dict.fromkeys(roles, name)
        for crew, staff in self.heads:
            for role, name in self._hand_out(crew, staff, values).items():
                robots[role] = name
                tours.setdefault(name, []).append(role)
        after_end, after_start = self._order_of_things(values)
        if self.problem.sharing:
            after_end += self._turns(values, [*after_end, *passings(self.problem.graph, tours)], after_start)
        return Course(robots, tours, after_end, after_start, self._under_way(values))

    def _turns(
        self, values: list[int], after_end: list[tuple[int, int]], after_start: list[tuple[int, int]]
    ) -> list[tuple[int, int]]:
        """Who waits for whom at shared resources, with who comes after whom for other reasons."""
        graph, times = self.problem.graph, self.times
        spans = {
            one: (_when(times.start[one], values), _when(times.end[one], values))
            for one in range(len(graph.activities))
        }
        return turns(self.problem.sharing, spans, order_of_events(graph, spans, after_end, after_start))

    def _hand_out(self, crew: Crew, staff: Staff | None, values: list[int]) -> dict[int, str]:
        """Robots of roles in order of their starts: those that were named, else the first that is free (interval colouring)."""
        spans = {role: self._span(role, values) for role in crew.roles}
        group_of = self.problem.staffing.group_of
        free = [0] * crew.usable
        found: dict[int, str] = {}
        for role in sorted(crew.roles, key=lambda role: (*spans[role], role)):
            if staff is not None:
                number = next(n for n in range(len(crew.members)) if self.holds(staff.fills[group_of[role], n], values))
            else:
                number = next((n for n, until in enumerate(free) if until <= spans[role][0]), 0)
                free[number] = spans[role][1]
            found[role] = crew.members[number].name
        return found

    def _span(self, role: int, values: list[int]) -> tuple[int, int]:
        graph = self.problem.graph
        first, last = (graph.activity_of[graph.roles[role][end]] for end in (0, -1))
        start, end = self.times.start[first], self.times.end[last]
        return _when(start, values), _when(end, values)

    def _order_of_things(self, values: list[int]) -> tuple[list[tuple[int, int]], list[tuple[int, int]]]:
        after_end: list[tuple[int, int]] = []
        after_start: list[tuple[int, int]] = []
        for pair in self.things.pairs:
            first, second = pair if self.holds(self.ordering.before(*pair), values) else pair[::-1]
            begun = begun_is_enough(self.problem.graph, first, second)
            (after_start if begun else after_end).append((first, second))
        return after_end, after_start

    def _under_way(self, values: list[int]) -> dict[int, int]:
        found: dict[int, int] = {}
        for (open_ended, one), literal in self.times.latest.items():
            if self.holds(literal, values):
                found.setdefault(open_ended, one)
        return found

    @staticmethod
    def holds(literal: int, values: list[int]) -> bool:
        """Whether a literal is true in an answer."""
        return bool(values[literal]) if literal >= 0 else not values[negated(literal)]


def _when(time: Affine, values: list[int]) -> int:
    return time.offset + (0 if time.var is None else values[time.var])
