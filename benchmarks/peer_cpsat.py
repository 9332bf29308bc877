"""CP-SAT with eight workers, asked again with a no-good for every alternative it has named. Runs as a process of its own."""

from __future__ import annotations

from collections.abc import Callable

from benchmarks.peer_model import ALWAYS, Answer, Programme, answer_from_command_line

WORKERS = 8


def solve(programme: Programme, k: int, left: Callable[[], float], seed: int) -> Answer:
    """The k best by CP-SAT."""
    from ortools.sat.python import cp_model  # noqa: PLC0415 - an optional install, in this process alone

    model = cp_model.CpModel()
    variables = [model.new_bool_var("") for _ in range(programme.variables)]

    def of(variable: int) -> cp_model.LinearExprT:
        return 1 if variable == ALWAYS else variables[variable]

    for parent, children in programme.exactly_one:
        if parent == ALWAYS:
            model.add_exactly_one(variables[child] for child in children)
        else:
            model.add(sum(variables[child] for child in children) == variables[parent])
    for uses, budget in zip(programme.uses, programme.budget, strict=True):
        if uses:
            model.add(sum(amount * of(variable) for variable, amount in uses.items()) <= budget)
    model.maximize(sum(gain * of(variable) for variable, gain in programme.gain.items()))
    solver = cp_model.CpSolver()
    solver.parameters.num_workers, solver.parameters.random_seed = WORKERS, seed
    answer = Answer()
    while len(answer.values) < k and left() > 0:
        solver.parameters.max_time_in_seconds = left()
        status = solver.solve(model)
        if status == cp_model.INFEASIBLE:
            answer.proven = True
            return answer
        if answer.bound is None:
            answer.bound = solver.best_objective_bound
        if status == cp_model.FEASIBLE:
            answer.values.append(solver.objective_value)
        if status != cp_model.OPTIMAL:
            return answer
        answer.values.append(solver.objective_value)
        model.add_bool_or(variable.Not() for variable in variables if solver.value(variable))
    answer.proven = len(answer.values) == k
    return answer


if __name__ == "__main__":
    answer_from_command_line(solve)
