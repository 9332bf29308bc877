"""An evaluation for other programs."""

import json
from pathlib import Path

from missiontree import __version__
from missiontree.evaluation.evaluation import Evaluation
from missiontree.evaluation.plain import plain_evaluation
from missiontree.formats.json_text import json_text
from missiontree.mission.spent import Spent
from tests.evaluation.contestants import missions_in, run


def test_numbers_missions_and_runs_are_told(tmp_path: Path) -> None:
    runs = (run(), run(number=2, right=False, spent=Spent(turns=1)))
    evaluation = Evaluation(
        suite="s", missions=missions_in(tmp_path)[:1], models=("m", "n"), asked=2, runs=runs, stopped={"n": "No key."}
    )
    plain = json.loads(json_text(plain_evaluation(evaluation)))
    assert plain["models"][0] == {
        "name": "m",
        "stopped": None,
        "runs": 2,
        "right": 1,
        "wrong_plans": 1,
        "wrong_refusals": 0,
        "wrong_declines": 0,
        "no_answers": 0,
        "pass_k": [0.5, 0.0],
        "score": 0.75,
        "twins": 0,
        "twins_told_apart": 0,
        "seconds": 4.0,
        "runs_with_a_language_model": 2,
        "turns": 3,
        "calls": 3,
        "refused": 1,
        "input_tokens": 100,
        "output_tokens": 10,
        "tokens_estimated": False,
        "cost_usd": None,
    }
    assert (plain["models"][1]["stopped"], plain["models"][1]["pass_k"]) == ("No key.", [])
    assert plain["missions"] == [
        {"id": "home-find", "setting": "home", "say": "Find Anna.", "wanted": ["Search(Anna)"], "digest": "d"}
    ]
    assert plain["runs"][1]["differences"] == ["missing: Search(Anna)"]
    assert {key: plain[key] for key in ("format", "missiontree", "suite", "runs_each", "complete")} == {
        "format": "evaluation/1",
        "missiontree": __version__,
        "suite": "s",
        "runs_each": 2,
        "complete": False,
    }
