"""A suite put to models: order, resuming, giving up, interruptions."""

from collections.abc import Sequence
from pathlib import Path
from threading import Event

import pytest

from missiontree.authoring.methods.method import built_in_methods
from missiontree.errors import InputError
from missiontree.evaluation.contestant import Contestant, named
from missiontree.evaluation.evaluation import Course, Evaluation, evaluate
from missiontree.evaluation.examiner import Examiner, Task
from missiontree.evaluation.ledger import read_ledger
from missiontree.evaluation.run import Run
from missiontree.llm.chat import ChatModel, FaultKind, Message, ProviderError, Tool
from tests.evaluation.contestants import (
    FIND,
    PAINT,
    RIGHT,
    ROUTINES,
    SUITE,
    VISIT,
    Answers,
    Player,
    attach,
    declare,
    failing,
    missions_in,
    player,
    suite_folder,
)

STILL = Examiner(clock=lambda: 0.0)


def places(evaluation: Evaluation) -> list[tuple[str, str, int]]:
    return [(run.model, run.mission, run.number) for run in evaluation.runs]


def counted(contestant: Contestant, asked: list[str]) -> Contestant:
    """The contestant, that notes each run."""

    def make() -> ChatModel:
        asked.append(contestant.name)
        assert not isinstance(contestant.model, str)
        return contestant.model()

    return Contestant(contestant.name, make)


def test_every_mission_is_run_by_every_model_as_often_as_asked(tmp_path: Path) -> None:
    done = evaluate("s", missions_in(tmp_path), [player("a"), player("b")], Course(runs=2))
    ids = ("home-find", "home-visit", "home-paint")
    assert places(done) == [(model, mission, number) for model in "ab" for mission in ids for number in (1, 2)]
    assert {run.kind for run in done.runs} == {"right"}
    assert (done.size, done.interrupted, dict(done.stopped)) == (12, False, {})


def test_runs_come_back_in_one_order_whichever_is_done_first(tmp_path: Path) -> None:
    """The first run of all ends only after another has; its place stays the first."""
    another = Event()

    class Late(Player):
        def __call__(self, messages: Sequence[Message], tools: Sequence[Tool]) -> Message:
            first = FIND in messages[1].text and messages[-1].speaker == "user"
            assert not first or another.wait(60)
            return super().__call__(messages, tools)

    kept: list[str] = []

    def keep(run: Run) -> None:
        kept.append(run.mission)
        another.set()

    late = Contestant("a", lambda: Late(RIGHT))
    done = evaluate("s", missions_in(tmp_path), [late], Course(jobs=2, keep=keep, examiner=STILL))
    assert kept[0] != "home-find"
    assert [run.mission for run in done.runs] == ["home-find", "home-visit", "home-paint"]
    alone = evaluate("s", missions_in(tmp_path), [player("a")], Course(examiner=STILL))
    assert done.runs == alone.runs


def test_the_offline_author_is_the_same_in_many_threads(tmp_path: Path) -> None:
    """Its methods, of which a user's routine takes precedence, are not loaded yet when it is begun."""
    (suite_folder(tmp_path) / "home/routines.yaml").write_text(ROUTINES, encoding="utf-8")
    text = "format: suite/1\nsetting: home\nroutines: [routines.yaml]\nfleet: fleet.yaml\nmissions:\n"
    fleet = "format: fleet/1\ntypes:\n  - {id: rover, count: 1, capabilities: {look: 1, reach: 1}}\n"
    (tmp_path / "suite/home/fleet.yaml").write_text(fleet, encoding="utf-8")
    missions = missions_in(tmp_path, text + "  - {id: home-look, say: Inspect pump 4A., plan: [Inspect(Pump 4A)]}\n")
    built_in_methods.cache_clear()
    beside = evaluate("s", missions, [named("offline")], Course(runs=8, jobs=8, examiner=STILL))
    assert {run.kind for run in beside.runs} == {"right"}
    assert beside.runs == evaluate("s", missions, [named("offline")], Course(runs=8, examiner=STILL)).runs


def test_what_is_kept_is_not_run_again(tmp_path: Path) -> None:
    missions, file = missions_in(tmp_path), tmp_path / "r.jsonl"
    asked: list[str] = []
    contestants = [counted(player("a"), asked), counted(player("b"), asked)]

    def go_on(runs: int) -> Evaluation:
        ledger = read_ledger(file)
        with ledger.opened() as keep:
            return evaluate("s", missions, contestants, Course(runs=runs, known=ledger.runs, keep=keep))

    first = go_on(1)
    assert len(asked) == 6
    assert go_on(1) == first
    assert len(asked) == 6
    more = go_on(2)
    assert len(asked) == 12
    assert [run for run in more.runs if run.number == 1] == list(first.runs)


def test_of_a_suite_that_changed_only_the_missions_that_changed_are_run_again(tmp_path: Path) -> None:
    asked: list[str] = []
    contestants = [counted(player("a", {**RIGHT, "Find Anna!": attach("x", "Search(Anna)")}), asked)]
    first = evaluate("s", missions_in(tmp_path), contestants)
    known = {run.key: run for run in first.runs}
    changed = missions_in(tmp_path, SUITE.replace("say: Find Anna.", "say: Find Anna!"))
    second = evaluate("s", changed, contestants, Course(known=known))
    assert len(asked) == 4
    assert second.runs[1:] == first.runs[1:]
    assert second.runs[0].digest != first.runs[0].digest
    evaluate("s", changed, contestants, Course(known=known, examiner=Examiner(whole=True)))
    assert len(asked) == 7  # trees alone were judged before, whole plans are now


@pytest.mark.parametrize(
    ("kind", "again"),
    [("timed_out", True), ("rate_limited", True), ("unauthorised", True), ("context_overflow", False)],
)
def test_a_run_is_made_again_if_its_fault_says_nothing_about_the_model(
    tmp_path: Path, kind: FaultKind, again: bool
) -> None:
    missions = missions_in(tmp_path)
    down = evaluate("s", missions, [failing("a", lambda: ProviderError("No.", kind))], Course(jobs=1))
    up = evaluate("s", missions, [player("a")], Course(known={run.key: run for run in down.runs}))
    assert {run.kind for run in up.runs} == ({"right"} if again else {"no_answer"})


def test_a_model_that_cannot_be_used_is_given_up_after_three_runs_and_the_others_go_on(tmp_path: Path) -> None:
    out = failing("out", lambda: ProviderError("The key is not accepted.", "unauthorised"))
    done = evaluate("s", missions_in(tmp_path), [out, player("in")], Course(runs=4))
    assert (len(done.of("out")), len(done.of("in"))) == (3, 12)
    assert dict(done.stopped) == {"out": "The key is not accepted."}


@pytest.mark.parametrize("kind", ["timed_out", "failed", "context_overflow"])
def test_other_faults_end_only_their_run(tmp_path: Path, kind: FaultKind) -> None:
    done = evaluate("s", missions_in(tmp_path), [failing("a", lambda: ProviderError("No.", kind))], Course(runs=4))
    assert (len(done.runs), dict(done.stopped)) == (12, {})
    assert {run.fault for run in done.runs} == {f"provider_{kind}"}


def test_three_in_a_row_means_in_a_row(tmp_path: Path) -> None:
    """Two refusals of the key, then a right run, and so on: never three in a row."""
    fault = ProviderError("No.", "unauthorised")
    answers: Answers = {FIND: fault, VISIT: fault, PAINT: declare("paint")}
    done = evaluate("s", missions_in(tmp_path), [player("a", answers)], Course(runs=3))
    assert (len(done.runs), dict(done.stopped)) == (9, {})


def test_an_interruption_keeps_what_is_done_and_can_be_gone_on_from(tmp_path: Path) -> None:
    missions = missions_in(tmp_path)
    heard: list[tuple[int, int]] = []

    def report(done: int, size: int, run: Run | None) -> None:
        heard.append((done, size))
        if done == 2:
            raise KeyboardInterrupt

    cut = evaluate("s", missions, [player("a")], Course(report=report))
    assert (cut.interrupted, [run.mission for run in cut.runs]) == (True, ["home-find", "home-visit"])
    assert heard == [(0, 3), (1, 3), (2, 3)]
    whole = evaluate("s", missions, [player("a")], Course(known={run.key: run for run in cut.runs}))
    assert (whole.interrupted, len(whole.runs)) == (False, 3)
    assert whole.runs[:2] == cut.runs


def test_what_is_under_way_at_an_interruption_is_told_to_stop(tmp_path: Path) -> None:
    """The dialogue that goes on after the interruption ends before its second turn, and is no result."""
    begun, interrupted, over = Event(), Event(), Event()
    turns: list[str] = []

    class Slow(Player):
        def __call__(self, messages: Sequence[Message], tools: Sequence[Tool]) -> Message:
            turns.append(messages[-1].speaker)
            begun.set()
            assert interrupted.wait(60)
            return super().__call__(messages, tools)

    class Told(Examiner):
        def __call__(self, task: Task) -> Run:
            run = super().__call__(task)
            if task.contestant.name == "slow":
                over.set()
            return run

    def report(done: int, size: int, run: Run | None) -> None:
        if run is not None:
            assert begun.wait(60)
            raise KeyboardInterrupt

    contestants = [player("quick"), Contestant("slow", lambda: Slow(RIGHT))]
    course = Course(jobs=2, report=report, examiner=Told())
    done = evaluate("s", missions_in(tmp_path)[:1], contestants, course)
    interrupted.set()
    assert over.wait(60)
    assert places(done) == [("quick", "home-find", 1)]
    assert turns == ["user"]


def test_bad_input_ends_it_and_what_was_done_is_kept(tmp_path: Path) -> None:
    kept: list[Run] = []
    with pytest.raises(InputError):
        evaluate("s", missions_in(tmp_path), [player("a"), Contestant("b", "splendid")], Course(keep=kept.append))
    assert len(kept) == 3


@pytest.mark.parametrize("course", [{"runs": 0}, {"jobs": 0}])
def test_less_than_one_run_or_job_is_refused(course: dict[str, int]) -> None:
    with pytest.raises(ValueError, match="at least 1"):
        Course(**course)  # type: ignore[arg-type]
