"""HiGHS, asked again with a cut for every alternative it has named. Runs as a process of its own."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable
from typing import Any

from benchmarks.peer_model import ALWAYS, Answer, Programme, answer_from_command_line


def solve(programme: Programme, k: int, left: Callable[[], float], seed: int) -> Answer:
    """The k best by HiGHS; utilities are whole numbers, so a bound less than one away is a proof."""
    import highspy  # noqa: PLC0415 - an optional install, in this process alone

    highs = highspy.Highs()
    for option, value in {
        "output_flag": False,
        "random_seed": seed,
        "mip_rel_gap": 0.0,
        "mip_abs_gap": 0.5,
    }.items():
        highs.setOptionValue(option, value)
    highs.passModel(_model(highspy, programme))
    answer, sure = Answer(), programme.gain[ALWAYS]
    optimal = {highspy.HighsModelStatus.kOptimal, highspy.HighsModelStatus.kModelEmpty}
    while len(answer.values) < k and left() > 0:
        highs.setOptionValue("time_limit", left())
        highs.run()
        status, info = highs.getModelStatus(), highs.getInfo()
        if status == highspy.HighsModelStatus.kInfeasible:
            answer.proven = True
            return answer
        if answer.bound is None:
            answer.bound = sure + info.mip_dual_bound if programme.variables else float(sure)
        found = info.primal_solution_status == highspy.SolutionStatus.kSolutionStatusFeasible or not programme.variables
        if found:
            answer.values.append(float(sure + round(info.objective_function_value)))
        if not found or status not in optimal:
            return answer
        taken = [variable for variable, value in enumerate(highs.getSolution().col_value) if value > 0.5]
        if not taken:  # no XOR is reached, so there is no other alternative
            answer.proven = True
            return answer
        highs.addRow(-highspy.kHighsInf, len(taken) - 1, len(taken), taken, [1.0] * len(taken))
    answer.proven = len(answer.values) == k
    return answer


def _model(highspy: Any, programme: Programme) -> Any:
    """The programme row by row."""
    rows: list[tuple[float, float, dict[int, int]]] = []
    for parent, children in programme.exactly_one:
        sides = dict.fromkeys(children, 1) | ({} if parent == ALWAYS else {parent: -1})
        needed = 1.0 if parent == ALWAYS else 0.0
        rows.append((needed, needed, sides))
    for uses, budget in zip(programme.uses, programme.budget, strict=True):
        amounts = Counter({variable: amount for variable, amount in uses.items() if variable != ALWAYS})
        rows.append((-highspy.kHighsInf, budget - uses[ALWAYS], dict(amounts)))
    lp = highspy.HighsLp()
    lp.num_col_, lp.num_row_ = programme.variables, len(rows)
    lp.sense_ = highspy.ObjSense.kMaximize
    lp.col_cost_ = [float(programme.gain[variable]) for variable in range(programme.variables)]
    lp.col_lower_, lp.col_upper_ = [0.0] * programme.variables, [1.0] * programme.variables
    lp.integrality_ = [highspy.HighsVarType.kInteger] * programme.variables
    lp.row_lower_, lp.row_upper_ = [low for low, _, _ in rows], [high for _, high, _ in rows]
    starts, index, value = [0], list[int](), list[float]()
    for _, _, sides in rows:
        index += sides
        value += map(float, sides.values())
        starts.append(len(index))
    lp.a_matrix_.format_ = highspy.MatrixFormat.kRowwise
    lp.a_matrix_.start_, lp.a_matrix_.index_, lp.a_matrix_.value_ = starts, index, value
    return lp


if __name__ == "__main__":
    answer_from_command_line(solve)
