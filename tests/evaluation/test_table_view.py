"""An evaluation in the terminal, wide and narrow."""

from dataclasses import replace
from pathlib import Path

from missiontree.evaluation.evaluation import Evaluation
from missiontree.evaluation.run import Run
from missiontree.evaluation.table_view import evaluation_view
from missiontree.mission.spent import Spent
from missiontree.reporting.text import render
from tests.evaluation.contestants import missions_in, run


def shown(folder: Path, *runs: Run, width: int = 100, asked: int = 1, models: tuple[str, ...] = ("m",)) -> list[str]:
    evaluation = Evaluation(suite="s", missions=missions_in(folder), models=models, asked=asked, runs=runs)
    return render(evaluation_view(evaluation), width).splitlines()


def test_models_are_rows_where_there_is_room(tmp_path: Path) -> None:
    """Three runs of 2 turns, 3 calls and 2 s each; the score is (1 + 1 + 0.5) / 3; half a dollar each."""
    spent = Spent(turns=2, calls=3, refused=1, input_tokens=100, output_tokens=10, cost_usd=0.5)
    runs = (run(spent=spent), run("home-visit", spent=spent), run("home-paint", right=False, spent=spent))
    assert shown(tmp_path, *runs) == [
        "Suite s: 3 missions, 1 run each, 1 model",
        "",
        "How often right",
        "                      wrong    wrong    wrong      no",
        "  model  runs  right   plan  refusal  decline  answer  score",
        "  m         3      2      1        0        0       0  0.833",
        "",
        "What a run takes",
        "                                tokens  tokens            money",
        "  model  turns  calls  refused      in     out  seconds  in all",
        "  m        2.0    3.0      1.0     100      10     2.00   $1.50",
        "",
        "Not right",
        "  wrong plan home-paint: missing: Search(Anna)",
    ]


def test_models_are_blocks_where_there_is_none(tmp_path: Path) -> None:
    lines = shown(tmp_path, run(), width=34)
    assert "  m" in lines
    assert "    wrong refusal      0" in lines
    assert "    money in all  $0.2500" in lines
    assert max(map(len, lines)) <= 34


def test_pass_k_has_a_table_of_its_own_once_there_are_two(tmp_path: Path) -> None:
    """Right once in two runs: pass^1 = 1/2, pass^2 = 0."""
    lines = shown(tmp_path, run(), run(number=2, right=False), asked=2)
    at = lines.index("pass^k: the chance that k runs of a mission are all right")
    assert [line.split() for line in lines[at + 1 : at + 3]] == [["model", "pass^1", "pass^2"], ["m", "0.500", "0.000"]]


def test_of_many_pass_k_the_first_and_the_last_are_shown(tmp_path: Path) -> None:
    lines = shown(tmp_path, *(run(number=number) for number in range(1, 21)), asked=20, width=200)
    at = lines.index("pass^k: the chance that k runs of a mission are all right")
    assert lines[at + 1].split()[1:] == [f"pass^{k}" for k in (1, 2, 3, 4, 5, 6, 7, 20)]


def test_what_is_not_done_and_who_was_given_up_is_told(tmp_path: Path) -> None:
    evaluation = Evaluation(
        suite="s",
        missions=missions_in(tmp_path),
        models=("m", "n"),
        asked=1,
        runs=(run(),),
        stopped={"n": "The key is not accepted."},
    )
    lines = render(evaluation_view(evaluation)).splitlines()
    assert lines[0] == "Suite s: 3 missions, 1 run each, 2 models; 1 of 6 runs done"
    assert "✗ n was given up: The key is not accepted." in lines
    assert "Not right" not in "\n".join(lines)


def test_the_worst_comes_first_and_the_rest_is_counted(tmp_path: Path) -> None:
    """Four lines are left to each of four models."""
    declined = run(
        kind="declined_though_possible", status="incomplete", right=False, reasons=("It is not understood.",)
    )
    silent = run("home-visit", kind="no_answer", status="provider_failed", right=False, reasons=("It is down.",))
    lines = shown(tmp_path, declined, silent, run("home-paint", right=False))
    at = lines.index("Not right")
    assert [line.strip() for line in lines[at + 1 :]] == [
        "wrong plan home-paint: missing: Search(Anna)",
        "wrong refusal home-find: It is not understood.",
        "no answer home-visit: It is down.",
    ]


def test_runs_that_miss_are_counted_and_their_worst_is_told(tmp_path: Path) -> None:
    declined = run(number=1, kind="declined_though_possible", status="incomplete", right=False)
    lines = shown(tmp_path, declined, run(number=2, right=False), run(number=3), asked=3)
    assert "  wrong plan home-find (2 of 3 runs): missing: Search(Anna)" in lines


def test_more_than_a_screenful_of_misses_is_cut(tmp_path: Path) -> None:
    setting, mission = missions_in(tmp_path)[0]
    many = tuple((setting, replace(mission, id=f"home-{n}")) for n in range(15))
    runs = tuple(run(mission.id, right=False) for _, mission in many)
    evaluation = Evaluation(suite="s", missions=many, models=("m",), asked=1, runs=runs)
    lines = render(evaluation_view(evaluation)).splitlines()
    assert sum(line.startswith("  wrong plan") for line in lines) == 12
    assert lines[-1] == "  … and 3 more; --html and --json list them all"


def test_names_and_words_of_others_do_no_harm(tmp_path: Path) -> None:
    evil = "[red]m\x1b[31m\n\u202e"
    missed = run(model=evil, right=False, differences=("missing: [bold]\x1b]0;x\x07Search(A)",))
    lines = shown(tmp_path, missed, models=(evil,))
    text = "\n".join(lines)
    assert "[red]m" in text
    assert "missing: [bold]Search(A)" in text
    assert not {"\x1b", "\u202e", "\x07"} & set(text)


def test_a_model_that_is_none_takes_only_time(tmp_path: Path) -> None:
    lines = shown(tmp_path, run(spent=None))
    assert lines[-1].split() == ["m", "–", "–", "–", "–", "–", "2.00", "–"]


def test_unknown_money_is_said_to_be_unknown(tmp_path: Path) -> None:
    assert shown(tmp_path, run(spent=Spent(turns=1)))[-1].endswith("not known")
