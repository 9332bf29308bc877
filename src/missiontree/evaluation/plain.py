"""An evaluation as plain data, for other programs."""

from __future__ import annotations

from typing import Any

from missiontree import __version__
from missiontree.evaluation.evaluation import Evaluation
from missiontree.evaluation.run import Run
from missiontree.evaluation.summary import Summary, summaries
from missiontree.formats.plain import to_plain

FORMAT = "evaluation/1"


def plain_evaluation(evaluation: Evaluation) -> dict[str, Any]:
    """
    What models came to: their numbers, the missions, and every run.

    Every number is there, those that are 0 as well; ``cost_usd`` is null where it is not known.
    """
    missions = [
        {
            "id": mission.id,
            "setting": setting.id,
            "say": mission.say,
            "wanted": list(mission.wanted),
            "digest": next((run.digest for run in evaluation.runs if run.mission == mission.id), None),
        }
        for setting, mission in evaluation.missions
    ]
    return {
        "format": FORMAT,
        "missiontree": __version__,
        "suite": evaluation.suite,
        "runs_each": evaluation.asked,
        "complete": len(evaluation.runs) == evaluation.size,
        "models": [_model(summary, evaluation.stopped.get(summary.model)) for summary in summaries(evaluation)],
        "missions": missions,
        "runs": [_run(run) for run in evaluation.runs],
    }


def _model(summary: Summary, stopped: str | None) -> dict[str, Any]:
    verdicts, spent = summary.verdicts, summary.spent
    return {
        "name": summary.model,
        "stopped": stopped,
        "runs": summary.runs,
        "right": verdicts.right,
        "wrong_plans": verdicts.wrong,
        "wrong_refusals": verdicts.declined_though_possible,
        "wrong_declines": verdicts.wrong_decline,
        "no_answers": verdicts.no_answer,
        "pass_k": [round(value, 6) for value in summary.pass_k],
        "score": round(summary.score, 6),
        "twins": summary.twins,
        "twins_told_apart": summary.told_apart,
        "seconds": round(summary.seconds, 3),
        "runs_with_a_language_model": summary.asked,
        "turns": spent.turns,
        "calls": spent.calls,
        "refused": spent.refused,
        "input_tokens": spent.input_tokens,
        "output_tokens": spent.output_tokens,
        "tokens_estimated": spent.estimated,
        "cost_usd": spent.cost_usd,
    }


def _run(run: Run) -> dict[str, Any]:
    plain: dict[str, Any] = to_plain(run)
    plain.pop("digest")
    return {**plain, "score": run.score, "seconds": run.seconds}
