"""What a model's runs come to in numbers."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from missiontree.evaluation.evaluation import Evaluation
from missiontree.evaluation.pass_k import mean_pass
from missiontree.evaluation.run import Run
from missiontree.evaluation.tally import Tally, tally
from missiontree.mission.spent import Spent
from missiontree.mission.value import Index, NonNegative, Value


@dataclass(frozen=True, slots=True, kw_only=True)
class Summary(Value):
    """
    A model in numbers.

    Parameters
    ----------
    model
        Its name.
    runs
        Runs done.
    verdicts
        How many of each kind.
    pass_k
        pass^1, pass^2 and so on: the chance that k runs of a mission are all right, averaged over missions that were run, as far as
        each of them has k runs.
    score
        Mean score of the runs, from 0 to 1; 0 if there are none.
    seconds
        By the clock, all runs together.
    asked
        Runs in which a language model was asked.
    spent
        What these took together; its cost is None if it is not known for each that was answered.
    twins
        Runs in which both an impossible mission and its possible twin were tried.
    told_apart
        Those of them in which both are right.
    """

    model: str
    runs: Index
    verdicts: Tally
    pass_k: tuple[float, ...]
    score: NonNegative
    seconds: NonNegative
    asked: Index
    spent: Spent
    twins: Index
    told_apart: Index

    @property
    def right(self) -> float:
        """Share of right runs, averaged over missions: pass^1; 0 if there are no runs."""
        return self.pass_k[0] if self.pass_k else 0.0


def summaries(evaluation: Evaluation) -> tuple[Summary, ...]:
    """A summary of each model, in their order."""
    return tuple(_summary(evaluation, model) for model in evaluation.models)


def _summary(evaluation: Evaluation, model: str) -> Summary:
    runs = evaluation.of(model)
    twins = _twins(evaluation, runs)
    asked = [run.spent for run in runs if run.spent is not None]
    return Summary(
        model=model,
        runs=len(runs),
        verdicts=tally(runs),
        pass_k=mean_pass(_counts(runs)),
        score=sum(run.score for run in runs) / len(runs) if runs else 0.0,
        seconds=sum(run.seconds for run in runs),
        asked=len(asked),
        spent=_together(asked),
        twins=len(twins),
        told_apart=sum(twins),
    )


def _counts(runs: Sequence[Run]) -> list[tuple[int, int]]:
    """Runs and right runs of each mission that was run."""
    by_mission: dict[str, list[bool]] = {}
    for run in runs:
        by_mission.setdefault(run.mission, []).append(run.kind == "right")
    return [(len(right), sum(right)) for right in by_mission.values()]


def _twins(evaluation: Evaluation, runs: Sequence[Run]) -> list[bool]:
    """For each run of an impossible mission and of its twin under one number: whether both are right."""
    right = {(run.mission, run.number): run.kind == "right" for run in runs}
    twin_of = {mission.id: mission.twin for _, mission in evaluation.missions if mission.twin is not None}
    pairs = (((mission, number), (twin_of.get(mission, ""), number)) for mission, number in right)
    return [right[one] and right[other] for one, other in pairs if other in right]


def _together(spent: Sequence[Spent]) -> Spent:
    dear = [one.cost_usd for one in spent if one.turns]  # nothing was paid for what was never answered
    costs = [cost for cost in dear if cost is not None]
    return Spent(
        turns=sum(one.turns for one in spent),
        calls=sum(one.calls for one in spent),
        refused=sum(one.refused for one in spent),
        input_tokens=sum(one.input_tokens for one in spent),
        output_tokens=sum(one.output_tokens for one in spent),
        estimated=any(one.estimated for one in spent),
        seconds=sum(one.seconds for one in spent),
        cost_usd=sum(costs) if dear and len(costs) == len(dear) else None,
    )
