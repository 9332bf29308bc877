"""CP-SAT at work on the model: with a time limit, a schedule to begin with, and a stop token that is heard."""

from __future__ import annotations

import threading
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Literal

from missiontree.scheduling.joint.listing import Listed
from missiontree.scheduling.joint.model import Form, JointModel
from missiontree.scheduling.joint.paths import Paths
from missiontree.scheduling.joint.problem import JointProblem

WORKERS = 8
LOOK_S = 0.05
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
        Of the search; ``stop`` is asked every 50 ms, from a thread of its own.
    hint
        A schedule to begin with.
    form
        Of the model.
    found
        Told of every makespan found.
    """
    from ortools.sat.python import cp_model  # noqa: PLC0415 - heavy

    model = JointModel(problem, paths, lower, upper, form)
    if hint is not None:
        model.hint(hint)
    solver: Any = cp_model.CpSolver()
    solver.parameters.max_time_in_seconds = max(0.01, limit_s)
    solver.parameters.num_workers = WORKERS
    solver.parameters.random_seed = seed % (1 << 31)

    class Listener(cp_model.CpSolverSolutionCallback):  # type: ignore[misc]  # the solver has no types
        def on_solution_callback(self) -> None:
            if found is not None:
                found(int(self.objective_value))

    done = threading.Event()

    def watch() -> None:
        while not done.wait(LOOK_S):
            if stop():
                solver.stop_search()

    watcher = threading.Thread(target=watch, daemon=True)
    watcher.start()
    try:
        status = solver.solve(model.model, Listener())
    finally:
        done.set()
        watcher.join()
    verdicts: dict[Any, Verdict] = {
        cp_model.OPTIMAL: "optimal",
        cp_model.FEASIBLE: "feasible",
        cp_model.INFEASIBLE: "infeasible",
    }
    verdict = verdicts.get(status, "unknown")
    if verdict in {"optimal", "feasible"}:
        chosen, start = model.read(solver.value)
        return Solved(verdict, round(solver.best_objective_bound), chosen, start)
    bound = upper + 1 if verdict == "infeasible" else max(lower, round(solver.best_objective_bound))
    return Solved(verdict, bound, {}, {})
