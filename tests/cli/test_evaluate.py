"""``missiontree evaluate``: files, exit codes, going on, and Ctrl-C."""

from __future__ import annotations

import json
import os
import signal
from collections.abc import Iterator
from contextlib import contextmanager
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from threading import Event, Thread

import pytest

from tests.cli.running import Ran, Shell

MISSIONS = """\
format: suite/1
setting: {0}
missions:
  - id: {0}-find
    say: Find Anna.
    plan: [Search(Anna)]
  - id: {0}-visit
    say: Go to Anna.
    plan: [{1}]
"""


@pytest.fixture
def suite(tmp_path: Path) -> str:
    """A suite of two settings; the offline author gets three of its four missions right."""
    for name, visit in (("farm", "Reach(Anna)"), ("home", "Follow(Anna)")):
        (tmp_path / "mine" / name).mkdir(parents=True)
        (tmp_path / "mine" / name / "missions.yaml").write_text(MISSIONS.format(name, visit), encoding="utf-8")
    return "mine"


def test_the_offline_author_is_put_to_a_suite_of_ones_own(shell: Shell, suite: str) -> None:
    ran = shell("evaluate", suite)
    assert (ran.code, ran.err) == (0, "")
    assert "Suite mine: 4 missions, 1 run each, 1 model" in ran.out
    assert "wrong plan home-visit: missing: Follow(Anna)" in ran.out


def test_everything_is_written_where_it_is_asked_for(shell: Shell, suite: str, tmp_path: Path) -> None:
    ran = shell("evaluate", suite, "--json", "e.json", "--html", "e.html", "--results", "r.jsonl", "--runs", "2")
    assert ran.err == "written to e.json\nwritten to e.html\n"
    plain = json.loads((tmp_path / "e.json").read_text(encoding="utf-8"))
    assert (plain["models"][0]["pass_k"], plain["models"][0]["wrong_plans"]) == ([0.75, 0.75], 2)
    assert (tmp_path / "e.html").read_text(encoding="utf-8").startswith("<!doctype html>")
    assert len((tmp_path / "r.jsonl").read_text(encoding="utf-8").splitlines()) == 8
    again = shell("evaluate", suite, "--json", "-", "--results", "r.jsonl", "--runs", "2", "--jobs", "2")
    assert json.loads(again.out) == plain
    assert again.err == ""


def test_quiet_is_quiet(shell: Shell, suite: str) -> None:
    assert shell("evaluate", suite, "--quiet", "--json", "e.json").err == ""


def test_the_model_of_the_environment_is_the_default(
    shell: Shell, suite: str, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setenv("MISSIONTREE_MODEL", "splendid:model")
    assert "splendid:model" in shell("evaluate", suite).err
    monkeypatch.setenv("MISSIONTREE_MODEL", "")
    assert shell("evaluate", suite).code == 0
    monkeypatch.setenv("MISSIONTREE_MODEL", "splendid:model")
    assert shell("evaluate", suite, "--model", "offline").code == 0


@pytest.mark.parametrize(
    ("only", "ids"),
    [
        (["home"], ["home-find", "home-visit"]),
        (["*-find"], ["farm-find", "home-find"]),
        (["home-visit", "farm-*"], ["farm-find", "farm-visit", "home-visit"]),
    ],
)
def test_some_missions_alone_are_run(shell: Shell, suite: str, only: list[str], ids: list[str]) -> None:
    patterns = [part for pattern in only for part in ("--only", pattern)]
    plain = json.loads(shell("evaluate", suite, "--json", "-", *patterns).out)
    assert [mission["id"] for mission in plain["missions"]] == ids


@pytest.mark.parametrize(
    ("arguments", "says"),
    [
        (["splendid"], "there is no suite 'splendid'\n  accepted: english, everyday, models"),
        (["mine", "--only", "barn"], "--only 'barn' fits no mission\n  accepted: ids such as farm-find"),
        (["mine", "--runs", "0"], "--runs 0\n  accepted: a whole number of at least 1"),
        (["mine", "--jobs", "0"], "--jobs 0"),
        (["mine", "--jobs", "65"], "from 1 to 64"),
        (["mine", "--fail-under", "95"], "--fail-under 95\n  accepted: a share from 0 to 1"),
        (["mine", "--fail-under", "nan"], "--fail-under nan"),
        (["mine", "--model", "offline", "--model", "offline"], "--model 'offline' is given twice"),
        (["mine", "--model", "splendid"], "there is no model 'splendid'"),
        (["mine", "--html", "none/e.html"], "cannot be written"),
        (["mine", "--json", "mine"], "It is a folder"),
        (["mine", "--results", "mine/home/missions.yaml"], "missions.yaml:1: this line is not JSON"),
        (["mine", "--max-turns", "0"], "--max-turns 0"),
    ],
)
def test_bad_input_is_told_in_words(shell: Shell, suite: str, arguments: list[str], says: str) -> None:
    ran = shell("evaluate", *arguments)
    assert (ran.code, ran.out) == (2, "")
    assert says in ran.err


def test_a_file_that_is_no_file_of_results_is_left_as_it_is(shell: Shell, suite: str, tmp_path: Path) -> None:
    file = tmp_path / "mine/home/missions.yaml"
    before = file.read_bytes()
    shell("evaluate", suite, "--results", str(file))
    assert file.read_bytes() == before


def test_a_share_that_is_not_reached_is_a_fault(shell: Shell, suite: str) -> None:
    """Three of four missions are right."""
    assert shell("evaluate", suite, "--fail-under", "0.75").code == 0
    below = shell("evaluate", suite, "--fail-under", "0.76")
    assert (below.code, below.err) == (6, "offline: pass^1 is 0.750, below 0.76\n")


def test_missions_that_changed_are_named_and_run_again(shell: Shell, suite: str, tmp_path: Path) -> None:
    shell("evaluate", suite, "--results", "r.jsonl")
    path = tmp_path / "mine/home/missions.yaml"
    path.write_text(path.read_text(encoding="utf-8").replace("Follow(Anna)", "Reach(Anna)"), encoding="utf-8")
    ran = shell("evaluate", suite, "--results", "r.jsonl", "--fail-under", "1")
    assert ran.code == 0
    assert "results of missions that have changed since (home-visit); they are run again" in ran.err
    assert len((tmp_path / "r.jsonl").read_text(encoding="utf-8").splitlines()) == 5
    assert shell("evaluate", suite, "--results", "r.jsonl").err == ""


def test_a_model_without_its_key_is_given_up_and_ends_as_a_failure(
    shell: Shell, suite: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.delenv("OPENAI_API_KEY", raising=False)
    monkeypatch.delenv("OPENAI_BASE_URL", raising=False)
    ran = shell("evaluate", suite, "--model", "openai:m", "--model", "offline")
    assert ran.code == 4
    assert "openai:m was given up: " in ran.out
    assert "7 of 8 runs done" in ran.out


def test_the_built_in_suite_of_models_is_the_default(shell: Shell) -> None:
    ran = shell("evaluate", "--only", "paper")
    assert ran.code == 0
    assert ran.out.startswith("Suite models: 5 missions")


class Endpoint(ThreadingHTTPServer):
    """An OpenAI-compatible endpoint that asks for one call of a function, then has nothing more to say."""

    daemon_threads = True

    def __init__(self) -> None:
        super().__init__(("127.0.0.1", 0), Answer)
        self.asked = 0
        self.interrupt_at = 0
        self.go_on = Event()

    @property
    def url(self) -> str:
        """Its address."""
        return f"http://127.0.0.1:{self.server_address[1]}/v1"


class Answer(BaseHTTPRequestHandler):
    """One request."""

    server: Endpoint

    def do_POST(self) -> None:
        """Declare the mission impossible; at one request, interrupt the program as a terminal would, and keep it waiting."""
        self.rfile.read(int(self.headers["Content-Length"]))
        self.server.asked += 1
        if self.server.asked == self.server.interrupt_at:
            os.kill(os.getpid(), signal.SIGINT)
            self.server.go_on.wait(60)
        call = {"name": "declareImpossible", "arguments": json.dumps({"missing": "dance", "reason": "Nobody can."})}
        message = {"role": "assistant", "tool_calls": [{"id": "1", "type": "function", "function": call}]}
        choice = {"index": 0, "message": message, "finish_reason": "tool_calls"}
        usage = {"prompt_tokens": 100, "completion_tokens": 10, "total_tokens": 110}
        plain = {
            "id": "1",
            "object": "chat.completion",
            "created": 0,
            "model": "m",
            "choices": [choice],
            "usage": usage,
        }
        body = json.dumps(plain).encode()
        self.send_response(200)
        self.send_header("Content-Type", "application/json")
        self.send_header("Content-Length", str(len(body)))
        self.end_headers()
        self.wfile.write(body)

    def log_message(self, format: str, *args: object) -> None:
        """Say nothing."""


@contextmanager
def endpoint() -> Iterator[Endpoint]:
    """An endpoint while it is needed."""
    server = Endpoint()
    thread = Thread(target=server.serve_forever)
    thread.start()
    try:
        yield server
    finally:
        server.go_on.set()
        server.shutdown()
        thread.join()
        server.server_close()


SUITE_OF_DANCES = """\
format: suite/1
setting: stage
missions:
  - {id: stage-1, say: Dance., declined: impossible, because: dance}
  - {id: stage-2, say: Dance again., declined: impossible, because: dance}
  - {id: stage-3, say: Dance once more., declined: impossible, because: sing}
"""


def danced(shell: Shell, folder: Path, server: Endpoint, *arguments: str) -> Ran:
    """Evaluate the endpoint's model on three missions."""
    (folder / "stage").mkdir(exist_ok=True)
    (folder / "stage/missions.yaml").write_text(SUITE_OF_DANCES, encoding="utf-8")
    return shell("evaluate", "stage", "--model", f"openai:m@{server.url}", *arguments)


def test_a_model_behind_an_address_is_put_to_a_suite(shell: Shell, tmp_path: Path) -> None:
    """Two missions are rightly declined, one for another reason."""
    with endpoint() as server:
        ran = danced(shell, tmp_path, server, "--json", "-", "--jobs", "3")
    model = json.loads(ran.out)["models"][0]
    assert ran.code == 0
    assert model["name"] == f"openai:m@{server.url}"
    assert (model["right"], model["wrong_declines"], model["pass_k"]) == (2, 1, [round(2 / 3, 6)])
    assert (model["turns"], model["input_tokens"], model["cost_usd"]) == (server.asked, 100 * server.asked, None)


def test_ctrl_c_keeps_what_is_done_says_how_to_go_on_and_can_be_gone_on_from(shell: Shell, tmp_path: Path) -> None:
    with endpoint() as server:
        alone = danced(shell, tmp_path, server, "--only", "stage-1")
        assert alone.code == 0
        turns = server.asked
        server.interrupt_at = 2 * turns + 1  # the first request of the second mission
        cut = danced(shell, tmp_path, server, "--results", "r.jsonl")
        assert cut.code == 130
        assert cut.err == "interrupted: 1 of 3 runs are done and kept in r.jsonl; the same command goes on from here.\n"
        assert "1 of 3 runs done" in cut.out
        server.go_on.set()
        whole = danced(shell, tmp_path, server, "--results", "r.jsonl", "--json", "-")
    plain = json.loads(whole.out)
    assert (whole.code, plain["complete"], len(plain["runs"])) == (0, True, 3)


def test_ctrl_c_without_a_file_says_what_would_have_helped(shell: Shell, tmp_path: Path) -> None:
    with endpoint() as server:
        server.interrupt_at = 1
        cut = danced(shell, tmp_path, server)
        assert cut.code == 130
        assert "0 of 3 runs are done, and not kept in a file; with --results FILE" in cut.err


def test_progress_is_shown_on_a_terminal_alone(
    shell: Shell, suite: str, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    from missiontree.cli.evaluate import _progress
    from tests.evaluation.contestants import run

    assert "of 4 runs" not in shell("evaluate", suite).err
    monkeypatch.setattr("sys.stderr.isatty", lambda: True, raising=False)
    report = _progress(quiet=False)
    report(0, 2, None)
    report(2, 2, run(model="m\x1b[2J"))
    assert capsys.readouterr().err == "\r\x1b[K0 of 2 runs\r\x1b[K2 of 2 runs: home-find by m: right\n"
