"""
A second formulation, to agree or disagree with the first: can everything be over by some tick?

It has nothing in common with the first but the problem. There are no intervals, no cumulative resources and no tours: only, for every
two roles that one robot could fill, the choice of which comes first. Travel between two roles is the least over all chains of legs and
all spots where they may be done, and every action takes its least time. Of shared resources only what finds no room beside each other
is kept apart. So it asks for less than the mission does; where even that cannot be, nothing can.
"""

from __future__ import annotations

from collections.abc import Callable
from itertools import combinations

from missiontree.estimation.travel import Blocked
from missiontree.mission.control import never
from missiontree.scheduling.cpsat.crew import Crew, crews
from missiontree.scheduling.cpsat.model import Affine, Model, negated
from missiontree.scheduling.cpsat.net import precedences
from missiontree.scheduling.cpsat.ordering import Ordering
from missiontree.scheduling.cpsat.staff import Staff
from missiontree.scheduling.cpsat.unsupported import TimeIsUpError
from missiontree.scheduling.problem import Problem
from missiontree.scheduling.trips import Spot

MOST_LITERALS = 60_000


class SecondForm:
    """
    The question as a model without objective.

    Parameters
    ----------
    problem
        The alternative.
    latest
        The tick.
    over
        Asked now and then whether time is up. Default: it never is.

    Raises
    ------
    TimeIsUpError
        If time was up before the model was built.
    """

    def __init__(self, problem: Problem, latest: int, over: Callable[[], bool] = never) -> None:
        self.model, self._problem, self._graph, self._latest = Model(), problem, problem.graph, latest
        self.too_large = False
        model, bounds = self.model, problem.bounds
        ends = range(2 * len(self._graph.activities))
        self._at = {event: Affine(self._variable(event, bounds.heads, bounds.tails)) for event in ends}
        for activity in range(len(self._graph.activities)):
            model.at_least(self._at[2 * activity + 1], self._at[2 * activity], bounds.duration[activity])
        for leaf, lag in bounds.lag.items():
            role = self._graph.roles[self._graph.tree.action(leaf).role]
            before = role[role.index(leaf) - 1]
            model.at_least(self._at[self._graph.start(leaf)], self._at[self._graph.end(before)], lag)
        for activity, deadline in sorted(self._graph.deadline.items()):
            model.at_least(Affine(None, deadline), self._at[2 * activity + 1])
        for earlier, later in precedences(self._graph):
            model.at_least(self._event(later), self._event(earlier))
        for giver, taker in sorted(problem.hand_overs.taker.items()):
            model.at_least(self._at[2 * giver + 1], self._at[2 * taker])
        for open_ended, ones in sorted(self._graph.until.items()):
            self._under_way(open_ended, sorted(ones))
        self._ordering = Ordering(model, problem)
        self._share()
        sizes = [len(crew.roles) ** 2 * (len(crew.members) + 2) for crew in crews(problem)]
        self.too_large = sum(sizes) > MOST_LITERALS
        if not self.too_large:
            for crew in crews(problem):
                self._one_at_a_time(crew, over)

    def _variable(self, event: int, heads: list[int], tails: list[int]) -> int:
        return self.model.integer(heads[event], max(heads[event], self._latest - tails[event]))

    def _event(self, event: int) -> Affine:
        if event not in self._at:
            self._at[event] = Affine(self.model.integer(0, self._latest))
        return self._at[event]

    def _under_way(self, open_ended: int, ones: list[int]) -> None:
        literals = [self.model.boolean() for _ in ones]
        for one, literal in zip(ones, literals, strict=True):
            self.model.at_least(self._at[2 * one + 1], self._at[2 * open_ended], 1, (literal,))
        if ones:
            self.model.clause(*literals)

    def _share(self) -> None:
        """Of two activities that find no room beside each other in a shared resource, one comes first."""
        sharing = self._problem.sharing
        for first, second in sorted({pair for name in sharing.capacity for pair in sharing.rivals(name)}):
            for before, after in ((first, second), (second, first)):
                literal = self._ordering.before(before, after)
                self.model.at_least(self._at[2 * after], self._at[2 * before + 1], 0, (literal,))

    def _one_at_a_time(self, crew: Crew, over: Callable[[], bool]) -> None:
        model, group_of, ways = self.model, self._problem.staffing.group_of, _Ways(self._problem, crew)
        staff = None
        if len(crew.members) > 1 or crew.apart or any(member.since or member.until for member in crew.members):
            staff = Staff(model, self._problem, crew)
            staff.taking_part()
            staff.budgets()
            self._present(crew, staff)
        members = range(len(crew.members))
        if self._problem.returning and crew.tours:
            self._come_home(crew, staff, ways)
        for role in crew.roles if crew.tours else ():
            for number in members:
                arrival = ways.least(crew.members[number].start, role)
                literal = model.true if staff is None else staff.fills[group_of[role], number]
                self._arrive(role, Affine(None, crew.members[number].since), arrival, (literal,))
        for number, (first, second) in enumerate(combinations(crew.roles, 2)):
            if number % 64 == 0 and over():
                raise TimeIsUpError
            sooner, later = self._either_order(first, second, ways)
            for who in members:
                if staff is None or group_of[first] == group_of[second]:
                    model.clause(sooner, later)
                    break
                one, other = (staff.fills[group_of[role], who] for role in (first, second))
                model.clause(sooner, later, negated(one), negated(other))

    def _present(self, crew: Crew, staff: Staff) -> None:
        """Nobody does anything before it comes, or after it has left."""
        for (group, number), literal in staff.fills.items():
            member = crew.members[number]
            for role in self._problem.staffing.members[group]:
                start, end = (
                    self._graph.start(self._graph.roles[role][0]),
                    self._graph.end(self._graph.roles[role][-1]),
                )
                self.model.at_least(self._at[start], Affine(None, member.since), 0, (literal,))
                if member.until is not None:
                    self.model.at_least(Affine(None, member.until), self._at[end], 0, (literal,))

    def _come_home(self, crew: Crew, staff: Staff | None, ways: _Ways) -> None:
        """After each of its roles a robot can still be home in time."""
        for role in crew.roles:
            over = self._at[self._graph.end(self._graph.roles[role][-1])]
            for number, member in enumerate(crew.members):
                literal = (
                    self.model.true if staff is None else staff.fills[self._problem.staffing.group_of[role], number]
                )
                way = ways.home(role, member.start)
                if way is None:
                    self.model.clause(negated(literal))
                    continue
                self.model.at_least(Affine(None, self._latest), over, way, (literal,))
                if member.until is not None:
                    self.model.at_least(Affine(None, member.until), over, way, (literal,))

    def _either_order(self, first: int, second: int, ways: _Ways) -> tuple[int, int]:
        """Literals of the two orders; where one holds, the robot has time to get from the one to the other."""
        found = []
        for before, after in ((first, second), (second, first)):
            over, begins = self._graph.roles[before][-1], self._graph.roles[after][0]
            literal = self.model.boolean()
            if self._ordering.certain(
                self._graph.activity_of[self._graph.roles[after][-1]], self._graph.activity_of[over]
            ):
                self.model.clause(negated(literal))
            self.model.at_least(self._at[self._graph.start(begins)], self._at[self._graph.end(over)], 0, (literal,))
            left = self._at[self._graph.end(over)]
            self._arrive(after, left, ways.between(before, after), (literal,))
            found.append(literal)
        return found[0], found[1]

    def _arrive(self, role: int, left: Affine, way: int | None, when: tuple[int, ...]) -> None:
        """A robot that is free from ``left`` on gets to the first place of a role in time."""
        leaf = next((one for one in self._graph.roles[role] if self._graph.tree.action(one).is_somewhere), None)
        if leaf is None or self._graph.activity_of[leaf] in self._graph.until:
            return
        if way is None:
            self.model.clause(*(negated(literal) for literal in when))
            return
        for one in self._graph.roles[role]:
            if one == leaf:
                break
            way += self._problem.bounds.duration[self._graph.activity_of[one]]  # it stands still meanwhile
        event = self._graph.end(leaf) if self._graph.tree.action(leaf).moves else self._graph.start(leaf)
        self.model.at_least(self._at[event], left, way, when)


class _Ways:
    """Least ticks between the roles of a crew, over any chain of spots; None if there is no way."""

    def __init__(self, problem: Problem, crew: Crew) -> None:
        self._problem, self._crew = problem, crew
        graph, places = problem.graph, problem.places
        self._places = {
            role: [places.of[leaf] for leaf in graph.roles[role] if graph.tree.action(leaf).is_somewhere]
            for role in crew.roles
        }
        spots: set[Spot] = {member.start for member in crew.members}
        for visited in self._places.values():
            spots |= set().union(*visited)
        self._nominal = not problem.trips.speed_known(crew.kind.id)
        self._least = self._closure(sorted(spots, key=repr)) if crew.tours else {}

    def _closure(self, spots: list[Spot]) -> dict[tuple[Spot, Spot], int]:
        """Least ticks over any chain (Floyd 1962, Warshall 1962); an unknown spot is near everything."""
        least: dict[tuple[Spot, Spot], int] = {}
        for origin in spots:
            for goal in spots:
                if origin is None or goal is None or origin == goal:
                    least[origin, goal] = 0
                    continue
                trip = self._problem.trips.approach(self._crew.kind.id, origin, goal)
                if not isinstance(trip, Blocked):
                    least[origin, goal] = trip.ticks
        for middle in spots:
            for origin in spots:
                first = least.get((origin, middle))
                if first is None:
                    continue
                for goal in spots:
                    second = least.get((middle, goal))
                    if second is not None and first + second < least.get((origin, goal), first + second + 1):
                        least[origin, goal] = first + second
        return least

    def least(self, origin: Spot, role: int) -> int | None:
        """From a spot to the first place of a role."""
        if not self._places[role]:
            return 0
        found = [self._least[origin, goal] for goal in self._places[role][0] if (origin, goal) in self._least]
        return min(found, default=None)

    def home(self, role: int, start: Spot) -> int | None:
        """From the last place of a role to a start."""
        if not self._places[role]:
            return 0
        return min(
            (self._least[spot, start] for spot in self._places[role][-1] if (spot, start) in self._least), default=None
        )

    def between(self, before: int, after: int) -> int | None:
        """From the last place of a role to the first of another."""
        if not (self._crew.tours and self._places[before] and self._places[after]):
            return 0
        found = [way for origin in self._places[before][-1] if (way := self.least(origin, after)) is not None]
        return min(found, default=None)
