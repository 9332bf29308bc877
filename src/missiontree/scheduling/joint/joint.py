"""The whole road of this package: bounds, list schedules, tabu search, CP-SAT, and what is known in the end."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field

from missiontree.mission.certificate import Certificate
from missiontree.mission.columns import TreeColumns
from missiontree.mission.control import Control, Progress
from missiontree.mission.tree_schedule import TreeSchedule
from missiontree.scheduling.joint.compiled import best_engine
from missiontree.scheduling.joint.handing import handed_out
from missiontree.scheduling.joint.listing import Aim, Listed, leaves_below, listed
from missiontree.scheduling.joint.loads import Loads, loads_of
from missiontree.scheduling.joint.paths import NEVER, Paths, paths_of
from missiontree.scheduling.joint.chains import contracted
from missiontree.scheduling.joint.problem import JointProblem, problem_of
from missiontree.scheduling.joint.shops import workshop_of

TABU_SHARE = 0.3
"""Of the time limit."""
TABU_S = 20.0
"""Where there is no limit."""
MOST_FOR_SOLVER = 20_000
"""Leaves above which no model is built."""
LEAST_FOR_SOLVER_S = 0.2
STRETCHES = (1.0, 0.0, 1.03, 1.08, 1.2, 1.5, 2.0, 3.0)


@dataclass
class Known:
    """
    What is known so far.

    Parameters
    ----------
    best
        The best schedule of the whole tree; None if there is none.
    bound, method
        Of the package itself, and how it came about.
    word
        A bound by the word of the solver.
    """

    best: Listed | None = None
    bound: int = 0
    method: str = "critical_path"
    word: int = 0
    confirmed: bool = field(default=False)

    @property
    def closed(self) -> bool:
        """Whether the best meets the bound."""
        return self.best is not None and self.best.makespan <= self.bound

    def offer(self, one: Listed) -> None:
        """A further schedule."""
        if self.best is None or one.makespan < self.best.makespan:
            self.best = one

    def raise_bound(self, bound: int, method: str) -> None:
        """A further bound."""
        if bound > self.bound:
            self.bound, self.method = bound, method


def schedule_tree(columns: TreeColumns, control: Control, *, solver: bool = True) -> TreeSchedule:
    """
    A selection and its schedule of least makespan, as far as the time allows; budgets, utility and ``disjoint`` do not count.

    Parameters
    ----------
    columns
        The tree.
    control
        Its limit ends every step.
    solver
        Whether CP-SAT may be asked where the rest has not closed the gap. Default true.
    """
    problem = problem_of(columns)
    paths = paths_of(problem)
    known = Known(bound=paths.bound)
    if paths.bound >= NEVER:
        certificate = Certificate(claim="proven", method="selection", detail="Some XOR that must be reached has no child to take.")
        return TreeSchedule("infeasible", certificate, {}, {}, {}, 0)
    for _ in _steps(problem, paths, known, control, solver=solver):
        best = known.best
        assert best is not None  # the first step offers one
        control.report(Progress("scheduling", 0, best.makespan, float(max(known.bound, known.word))))
        if known.closed or control.ended():
            break
    return _told(problem, known)


def _steps(problem: JointProblem, paths: Paths, known: Known, control: Control, *, solver: bool) -> Iterator[None]:
    """Each step leaves more known than there was, or nothing; the cheapest first."""
    yield from _lists(problem, paths, known, control)
    assert known.best is not None  # a list schedule always comes about
    found = loads_of(problem, paths, known.bound, known.best.makespan, control.ended)
    known.raise_bound(found.bound, "load")
    yield
    yield from _lists(problem, paths, known, control, found)
    if max(problem.count) == 1:
        _tabu(problem, paths, known, control)
        yield
    if solver and len(problem.leaves) <= MOST_FOR_SOLVER:
        _solver(problem, paths, known, control)
        yield


def _lists(
    problem: JointProblem, paths: Paths, known: Known, control: Control, loads: Loads | None = None
) -> Iterator[None]:
    """List schedules for several targets, over the tree with its chains as leaves and then as it is."""
    smaller = contracted(problem)
    shorter = paths if len(smaller.inside) == len(problem.kind) else paths_of(smaller.problem)
    price = [1.0] * len(problem.count) if loads is None else [float(each) for each in loads.price]
    for whole in (False, True):
        if whole and shorter is paths:
            return
        tree, least = (problem, paths) if whole else (smaller.problem, shorter)
        sizes, urgency = leaves_below(tree), [-rest for rest in least.rest]
        for stretch in STRETCHES:
            target = round(stretch * known.bound)
            one = listed(tree, least, urgency, Aim(target, price, sizes))
            known.offer(one if whole else smaller.expanded(problem, one))
            yield
            if control.ended():
                return


def _tabu(problem: JointProblem, paths: Paths, known: Known, control: Control) -> None:
    best = known.best
    assert best is not None
    part = control.part(TABU_SHARE)
    limit = part.time_limit_s if part.time_limit_s is not None else TABU_S
    until = control.clock() + limit
    upper = best.makespan

    def closed(leaf: int) -> bool:
        return paths.head[leaf] + paths.rest[leaf] >= upper

    workshop = workshop_of(problem, best, best_engine(), control.seed, closed=closed)
    workshop.improved(known.bound, lambda: control.clock() >= until or control.ended())
    known.offer(workshop.best())


def _solver(problem: JointProblem, paths: Paths, known: Known, control: Control) -> None:
    """Ask CP-SAT; and where it says that nothing is better, ask the model of the other form whether anything is."""
    from missiontree.scheduling.joint.solver import solve  # noqa: PLC0415 - heavy

    best = known.best
    assert best is not None

    def left() -> float:
        whole = control.part(1.0).time_limit_s
        return 1e6 if whole is None else whole

    if left() < LEAST_FOR_SOLVER_S:
        return
    one = solve(
        problem, paths, known.bound, best.makespan, seed=control.seed, limit_s=left(), stop=control.stop, hint=best
    )
    known.word = one.bound
    if one.start:
        known.offer(handed_out(problem, one.chosen, one.start))
    best = known.best
    assert best is not None
    if known.word < best.makespan or known.closed or left() < LEAST_FOR_SOLVER_S or control.stop():
        return
    other = solve(
        problem,
        paths,
        known.bound,
        best.makespan - 1,
        seed=control.seed,
        limit_s=left(),
        stop=control.stop,
        form="own",
    )
    if other.verdict == "infeasible":
        known.confirmed = True
        known.raise_bound(best.makespan, "two_models")
    elif other.start:  # the first model was wrong; the better schedule stands, and nothing is said of the bound
        known.offer(handed_out(problem, other.chosen, other.start))
        known.word = 0


def _told(problem: JointProblem, known: Known) -> TreeSchedule:
    best = known.best
    assert best is not None
    status, certificate = _claimed(known, best.makespan)
    robots = best.robot
    return TreeSchedule(status, certificate, best.chosen, best.start, robots, best.makespan)


DETAILS = {
    "critical_path": "Some path through the tree takes as long, whichever ways are taken.",
    "load": "Some robots have as much to do, whichever ways are taken.",
    "two_models": "Two models of different form agree that nothing is shorter.",
}


def _claimed(known: Known, makespan: int) -> tuple[str, Certificate]:
    if known.closed:
        return "optimal", Certificate(
            claim="proven", method=known.method, bound=float(makespan), detail=DETAILS[known.method]
        )
    if known.word >= makespan:
        detail = "By the solver's word; no bound of missiontree's own and no second method confirms it."
        return "optimal", Certificate(claim="bounded", method="cp_sat", bound=float(makespan), detail=detail)
    if known.word > known.bound:
        return "feasible", Certificate(
            claim="bounded", method="cp_sat", bound=float(known.word), detail="A bound by the solver's word."
        )
    return "feasible", Certificate(
        claim="bounded", method=known.method, bound=float(known.bound), detail=DETAILS[known.method]
    )
