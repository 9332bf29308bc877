"""
CP-SAT at work on the model: with a time limit, a schedule to begin with, and a stop token that is heard.

Loading the solver and building a large model take long, and the solver may look at the clock late. All of it is done aside, and left behind
when time is up; what was found by then counts.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass, replace
from math import ceil
from typing import Any, Literal

from missiontree.errors import InternalError
from missiontree.mission.aside import Aside, aside
from missiontree.scheduling.joint.listing import Listed
from missiontree.scheduling.joint.model import Form, JointModel
from missiontree.scheduling.joint.paths import Paths
from missiontree.scheduling.joint.problem import JointProblem
from missiontree.scheduling.sound_solver import SOUND

WORKERS = 8
LOOK_S = 0.02
GRACE_S = 0.03
NOISE = 1e-6
Verdict = Literal["optimal", "feasible", "infeasible", "unknown"]


@dataclass(frozen=True)
class Solved:
    """
    What the solver says.

    Parameters
    ----------
    verdict
        Its word; nothing that missiontree knows by itself.
    bound
        No makespan below it, by its word.
    chosen, start
        The best it found; empty if none.
    """

    verdict: Verdict
    bound: int
    chosen: dict[int, int]
    start: dict[int, int]


def solve(
    problem: JointProblem,
    paths: Paths,
    lower: int,
    upper: int,
    *,
    seed: int,
    limit_s: float,
    stop: Callable[[], bool],
    hint: Listed | None = None,
    form: Form = "shared",
    found: Callable[[int], None] | None = None,
) -> Solved:
    """
    Ask CP-SAT for the least makespan between two bounds.

    Parameters
    ----------
    problem, paths
        The tree and its least times.
    lower, upper
        Bounds, both included.
    seed, limit_s, stop
        Of the search; ``stop`` is asked every 20 ms.
    hint
        A schedule to begin with.
    form
        Of the model.
    found
        Told of every makespan found.
    """
    ends = time.monotonic() + max(0.01, limit_s)  # importing and building count

    def over() -> bool:
        return stop() or time.monotonic() >= ends

    solver = aside(lambda: _solver(seed), over, whole=True)
    room = _Room(Solved("unknown", lower, {}, {}), found)
    if solver is None:
        return room.solved

    def work() -> None:
        model = JointModel(problem, paths, lower, upper, form)
        if hint is not None:
            model.hint(hint)
        room.solving = True
        if room.closed:
            return
        solver.parameters.max_time_in_seconds = max(0.01, ends - time.monotonic())
        _work(solver, model, room, upper)

    worker = Aside(work)
    while not worker.over(LOOK_S):
        if over():
            solver.stop_search()
            worker.over(GRACE_S)
            room.closed = True
            worker.leave(whole=room.solving)  # what calls back from foreign code must not raise
            break
    room.closed = True
    _ = worker.result  # what it raised is raised here
    return room.solved


@dataclass
class _Room:
    """Where the thread that solves puts what it has, so that it is there even if the thread comes back late."""

    solved: Solved
    found: Callable[[int], None] | None
    solving: bool = False
    closed: bool = False

    def put(self, solved: Solved) -> None:
        if not self.closed:
            self.solved = solved


def _solver(seed: int) -> Any:
    from ortools.sat.python import cp_model  # noqa: PLC0415 - heavy

    solver = cp_model.CpSolver()
    solver.parameters.num_workers = WORKERS
    solver.parameters.random_seed = seed % (1 << 31)
    solver.parameters.catch_sigint_signal = False  # the stop token hears it
    for name, value in SOUND.items():
        setattr(solver.parameters, name, value)
    return solver


def _work(solver: Any, model: JointModel, room: _Room, upper: int) -> None:
    """Solve; tell of every solution on the way."""
    from ortools.sat.python import cp_model  # noqa: PLC0415 - heavy

    class Listener(cp_model.CpSolverSolutionCallback):  # type: ignore[misc]  # the solver has no types
        def on_solution_callback(self) -> None:
            chosen, start = model.read(self.value)
            bound = max(room.solved.bound, ceil(self.best_objective_bound - NOISE))
            room.put(Solved("feasible", bound, chosen, start))
            if room.found is not None and not room.closed:
                room.found(int(self.objective_value))

    def raised(bound: float) -> None:
        room.put(replace(room.solved, bound=max(room.solved.bound, ceil(bound - NOISE))))

    solver.best_bound_callback = raised
    status = solver.solve(model.model, Listener())
    if status == cp_model.INFEASIBLE:
        room.put(Solved("infeasible", upper + 1, {}, {}))
    elif status in {cp_model.OPTIMAL, cp_model.FEASIBLE}:
        chosen, start = model.read(solver.value)
        verdict: Verdict = "optimal" if status == cp_model.OPTIMAL else "feasible"
        room.put(Solved(verdict, max(room.solved.bound, ceil(solver.best_objective_bound - NOISE)), chosen, start))
    elif status == cp_model.MODEL_INVALID:
        raise InternalError(f"the solver refuses a model: {model.model.validate()}")
