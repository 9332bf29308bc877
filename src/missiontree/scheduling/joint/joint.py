"""The whole road of this package: bounds, list schedules, searches, CP-SAT, and what is known in the end."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cached_property
from random import Random

from missiontree.mission.certificate import Certificate
from missiontree.mission.columns import TreeColumns
from missiontree.mission.control import Control, Progress
from missiontree.mission.tree_schedule import TreeSchedule
from missiontree.scheduling.joint.balance import POWERS, balanced
from missiontree.scheduling.joint.chains import Contraction, contracted
from missiontree.scheduling.joint.compiled import engine_for
from missiontree.scheduling.joint.dispatching import dispatched
from missiontree.scheduling.joint.flips import flipped
from missiontree.scheduling.joint.handing import handed_out
from missiontree.scheduling.joint.justify import justified, reversed_in_time
from missiontree.scheduling.joint.known import Known
from missiontree.scheduling.joint.listing import Aim, Listed, leaves_below, listed
from missiontree.scheduling.joint.loads import loads_of
from missiontree.scheduling.joint.paths import NEVER, Paths, paths_of
from missiontree.scheduling.joint.problem import JointProblem, problem_of
from missiontree.scheduling.joint.shops import workshop_of

STRETCHES = (1.0, 0.0, 1.03, 1.08, 1.2, 1.5, 2.0, 3.0)
"""Targets of list schedules, as multiples of the bound."""
BALANCE_SHARE, FLIP_SHARE, GLANCE_SHARE, TABU_SHARE = 0.05, 0.05, 0.05, 0.3
BALANCE_ALONE = 0.4
"""Of the time limit that is left; the second, where robots are equal and the tabu search has no place."""
NOISE = 0.2
"""By how much the urgency of an action is shaken in later list schedules, as a share."""
SEARCH_S = 20.0
"""What each search may take where there is no limit."""
PATIENCE = 0.3
"""Of the time of the tabu search, without a new best after which it ends."""
TRIES = 300
"""Moves per action without a new best after which it ends as well."""
MOST_FOR_TABU = 20_000
MOST_FOR_SOLVER = 12_000
MOST_FOR_GLANCE = 120
"""Leaves above which these are not worth their while."""
LEAST_S = 0.2
"""Of time left, to ask the solver."""


def schedule_tree(
    columns: TreeColumns, control: Control, *, solver: bool = True, bound_share: float = 0.0
) -> TreeSchedule:
    """
    A selection and its schedule of least makespan, as far as the time allows; budgets, utility and ``disjoint`` do not count.

    Parameters
    ----------
    columns
        The tree.
    control
        Its limit ends every step; the first schedule is made in any case.
    solver
        Whether CP-SAT may be asked where all else leaves a gap. Default true.
    bound_share
        Of the time that is left for CP-SAT, from 0 to 1, what goes into raising the bound instead of shortening the schedule. Default 0.
    """
    view = _View(problem_of(columns))
    if view.shorter.bound >= NEVER:
        detail = "Some XOR that must be reached has no child to take."
        return TreeSchedule("infeasible", Certificate(claim="proven", method="selection", detail=detail), {}, {}, {}, 0)
    known = Known(view.first_list(), view.shorter.bound)
    if not known.closed:
        for _ in _steps(view, known, control, solver, bound_share):
            _tell(known, control)
            if known.closed or control.ended():
                break
    return known.told()


def _tell(known: Known, control: Control, found: int | None = None) -> None:
    """Tell of the best schedule, or of one that is just found, and of the bound."""
    best = known.best.makespan if found is None else min(found, known.best.makespan)
    control.report(Progress("scheduling", 0, 1, float(max(known.bound, known.word)), float(best)))


class _View:
    """The tree as it is and with its chains as leaves, and what follows from both alone."""

    def __init__(self, problem: JointProblem) -> None:
        self.problem = problem
        self.contraction: Contraction = contracted(problem)
        self.smaller = self.contraction.problem
        self.shorter: Paths = paths_of(self.smaller)
        self.sizes = leaves_below(self.smaller)
        self.urgency = [-rest for rest in self.shorter.rest]
        self.price = [1.0] * len(problem.count)

    @cached_property
    def paths(self) -> Paths:
        """Least times in the whole tree."""
        return paths_of(self.problem)

    @cached_property
    def mirror(self) -> JointProblem:
        """The tree reversed in time."""
        return reversed_in_time(self.problem)

    def first_list(self) -> Listed:
        """The list schedule that is aimed at the bound."""
        return self.whole(self.list_for(self.shorter.bound))

    def list_for(self, target: int) -> Listed:
        """A list schedule of the smaller tree."""
        return listed(self.smaller, self.shorter, self.urgency, Aim(target, self.price, self.sizes))

    def whole(self, one: Listed) -> Listed:
        """A schedule of the smaller tree, as one of the whole."""
        return self.contraction.expanded(self.problem, one)

    def pushed(self, one: Listed, known: Known, control: Control) -> Listed:
        """The schedule of the whole tree, pushed to and fro."""
        return justified(self.problem, self.mirror, self.paths, one, known.bound, control.ended)


def _steps(view: _View, known: Known, control: Control, solver: bool, bound_share: float) -> Iterator[None]:
    """Each step leaves more known than there was, or nothing; the cheapest first."""
    yield from _lists(view, known)
    found = loads_of(view.smaller, view.shorter, known.bound, known.best.makespan, control.ended)
    known.raise_bound(found.bound, "load")
    view.price = [float(each) for each in found.price]
    yield
    leaves = len(view.problem.leaves)
    if (
        solver and leaves <= MOST_FOR_GLANCE
    ):  # what is small is often solved and confirmed before any search has begun to tell
        _solver(view, known, control, _Turn(control, GLANCE_SHARE).left)
        yield
    yield from _balances(view, known, control)
    known.offer(view.pushed(known.best, known, control))
    yield from _lists(view, known)
    _flips(view, known, control)
    yield
    if max(view.problem.count) == 1 and leaves <= MOST_FOR_TABU:
        _tabu(view, known, control)
        yield
    if solver and leaves <= MOST_FOR_SOLVER:
        yield from _raise(view, known, control, bound_share)
        _solver(view, known, control, lambda: _left(control))
        yield


def _lists(view: _View, known: Known) -> Iterator[None]:
    for stretch in STRETCHES:
        known.offer(view.whole(view.list_for(round(stretch * known.bound))))
        yield


@dataclass
class _Turn:
    """The time of one search."""

    control: Control
    share: float

    def __post_init__(self) -> None:
        part = self.control.part(self.share)
        self.limit = SEARCH_S * self.share if part.time_limit_s is None else part.time_limit_s
        self.until = self.control.clock() + self.limit

    def over(self) -> bool:
        """Whether to stop."""
        return self.left() <= 0 or self.control.ended()

    def left(self) -> float:
        """Seconds that are left of it."""
        return self.until - self.control.clock()


def _left(control: Control) -> float:
    """Seconds that are left of the whole; very many where there is no limit."""
    left = control.part(1.0).time_limit_s
    return 1e6 if left is None else left


def _balances(view: _View, known: Known, control: Control) -> Iterator[None]:
    """Selections that keep robots about equally busy, as long as the load is what binds."""
    if known.method != "load":
        return
    share = BALANCE_SHARE if max(view.problem.count) == 1 else BALANCE_ALONE
    turn, luck, rounds = _Turn(control, share), Random(control.seed), 0  # noqa: S311 - luck for a search
    while rounds < len(POWERS) or (rounds < 2000 and not turn.over()):
        chosen = balanced(view.smaller, view.price, POWERS[rounds % len(POWERS)], luck, control.ended)
        noise = NOISE if rounds >= len(POWERS) else 0.0
        urgency = [each * (1.0 + noise * luck.random()) for each in view.urgency]
        rounds += 1
        one = view.whole(dispatched(view.smaller, urgency, chosen))
        known.offer(view.pushed(one, known, control))
        yield


def _flips(view: _View, known: Known, control: Control) -> None:
    turn = _Turn(control, FLIP_SHARE)
    best = min((view.list_for(round(stretch * known.bound)) for stretch in STRETCHES), key=lambda one: one.makespan)
    found = flipped(view.smaller, view.shorter, best, Aim(known.bound, view.price, view.sizes), control.seed, turn.over)
    known.offer(view.whole(found))


def _tabu(view: _View, known: Known, control: Control) -> None:
    turn, upper, paths = _Turn(control, TABU_SHARE), known.best.makespan, view.paths

    def closed(leaf: int) -> bool:
        return paths.head[leaf] + paths.rest[leaf] >= upper

    engine = engine_for(len(known.best.start), turn.limit, turn.over)
    workshop = workshop_of(view.problem, known.best, engine, control.seed, closed=closed)
    since = control.clock()

    def ended(better: bool) -> bool:
        nonlocal since
        now = control.clock()
        if better:
            since = now
            _tell(known, control, workshop.makespan)
        in_vain = now - since >= PATIENCE * turn.limit or workshop.in_vain >= TRIES * workshop.items
        return in_vain or turn.over()

    workshop.improved(known.bound, ended)
    known.offer(workshop.best())


def _raise(view: _View, known: Known, control: Control, share: float) -> Iterator[None]:
    """
    Ask whether anything ends by the bound; if not, raise it, by more each time; by less where no answer comes.

    With the end given, windows of time are narrow, and many ways are closed (destructive bounds, Klein and Scholl, European Journal of
    Operational Research 112, 1999).
    """
    from missiontree.scheduling.joint.solver import solve  # noqa: PLC0415 - heavy

    turn, width = _Turn(control, share), 1
    known.word = max(known.word, known.bound)
    while share > 0 and width and known.word < known.best.makespan and not turn.over():
        upper = min(known.word + width, known.best.makespan) - 1
        asked = solve(
            view.problem, view.paths, known.word, upper, seed=control.seed, limit_s=turn.left() / 2, stop=control.stop
        )
        if asked.verdict == "infeasible":
            known.word, width = upper + 1, 2 * width
        elif asked.start:
            known.offer(handed_out(view.problem, view.paths, asked.chosen, asked.start))
        else:
            width //= 2
        yield


def _solver(view: _View, known: Known, control: Control, left: Callable[[], float]) -> None:
    """
    Ask CP-SAT; and where it says that nothing is better, ask the model of the other form whether anything is.

    ``left`` says how many seconds are left for that.
    """
    from missiontree.scheduling.joint.solver import solve  # noqa: PLC0415 - heavy

    problem = view.problem
    if left() < LEAST_S:
        return
    one = solve(
        problem,
        view.paths,
        max(known.bound, known.word),
        known.best.makespan,
        seed=control.seed,
        limit_s=left(),
        stop=control.stop,
        hint=known.best,
        found=lambda makespan: _tell(known, control, makespan),
    )
    if one.start:
        known.offer(handed_out(problem, view.paths, one.chosen, one.start))
    known.word = min(max(one.bound, known.word), known.best.makespan)
    if known.closed or known.word < known.best.makespan or left() < LEAST_S or control.stop():
        return
    other = solve(
        problem,
        view.paths,
        known.bound,
        known.best.makespan - 1,
        seed=control.seed,
        limit_s=left(),
        stop=control.stop,
        form="own",
    )
    if other.verdict == "infeasible":
        known.raise_bound(known.best.makespan, "second_formulation")
    elif other.start:  # the first model was wrong: the better schedule stands, and the solver's word does not
        known.offer(handed_out(problem, view.paths, other.chosen, other.start))
        known.word = 0
