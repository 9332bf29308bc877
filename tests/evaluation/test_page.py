"""The page: whole in itself, true to the runs, and harmless whatever was said."""

from __future__ import annotations

import re
from html.parser import HTMLParser
from pathlib import Path

import pytest

from missiontree.evaluation.evaluation import Evaluation
from missiontree.evaluation.page import page
from missiontree.evaluation.run import Run
from missiontree.evaluation.verdict import VERDICTS
from tests.evaluation.contestants import SUITE, missions_in, run

VOID = {"meta", "br", "link", "img"}
EVIL = '"><script>alert(1)</script><img src=x onerror=alert(2)>\x1b[31m\u202e\ud800'


class Reader(HTMLParser):
    """Reads the page as a browser would, and minds that what is opened is closed."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.open: list[str] = []
        self.tags: list[tuple[str, dict[str, str | None]]] = []
        self.words: list[str] = []
        self.feed(text)
        self.close()
        assert self.open == []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.tags.append((tag, dict(attrs)))
        if tag not in VOID:
            self.open.append(tag)

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag

    def handle_data(self, data: str) -> None:
        if data.strip() and self.open[-1] != "style":
            self.words.append(" ".join(data.split()))

    def all(self, name: str) -> list[str]:
        """Every value of an attribute."""
        return [value for _, attributes in self.tags if (value := attributes.get(name)) is not None]


def written(folder: Path, *runs: Run, models: tuple[str, ...] = ("m",), text: str = SUITE, **given: object) -> str:
    made: dict[str, object] = {"suite": "s", "missions": missions_in(folder, text), "models": models, "asked": 1}
    return page(Evaluation(**{**made, "runs": runs, **given}))  # type: ignore[arg-type]


RUNS = (
    run(number=1),
    run(number=2, right=False, got="Reach(Anna)", differences=("missing: Search(Anna)", "not expected: Reach(Anna)")),
    run("home-visit", kind="declined_though_possible", status="incomplete", right=False, got="", reasons=("What?",)),
    run("home-paint", kind="wrong_decline", status="incomplete", right=False, got=""),
    run("home-paint", 2, kind="no_answer", status="provider_failed", right=False, got="", reasons=("It is down.",)),
)


def test_the_page_is_well_formed_and_needs_nothing_beside_it(tmp_path: Path) -> None:
    text = written(tmp_path, *RUNS, asked=2)
    reader = Reader(text)
    assert not {"script", "link", "img", "iframe", "object", "form"} & {tag for tag, _ in reader.tags}
    assert not [name for _, attributes in reader.tags for name in attributes if name.startswith("on")]
    assert all(target.startswith("#") for target in reader.all("href"))
    assert not re.search(r"https?:|url\(|@import", text)
    assert "default-src 'none'" in text
    assert "prefers-color-scheme: dark" in text


def test_every_link_leads_to_one_place(tmp_path: Path) -> None:
    reader = Reader(written(tmp_path, *RUNS, asked=2, models=("m", "n")))
    places = reader.all("id")
    assert len(set(places)) == len(places)
    assert {target.removeprefix("#") for target in reader.all("href")} <= set(places)


def test_what_was_expected_and_what_was_made_stand_in_it(tmp_path: Path) -> None:
    words = Reader(written(tmp_path, *RUNS, asked=2)).words
    for expected in (
        "Find Anna.",
        "Search(Anna)",
        "must Reach(Anna) | must not Follow(*)",
        "declined as impossible, because of 'paint'",
        "Reach(Anna)",
        "not expected: Reach(Anna)",
        "What?",
        "It is down.",
        "provider failed",
    ):
        assert expected in words, expected


def test_the_matrix_counts_right_runs_and_shows_the_worst(tmp_path: Path) -> None:
    reader = Reader(written(tmp_path, *RUNS, asked=2, models=("m", "n")))
    assert [word for word in reader.words if re.fullmatch(r"\S \d/\d", word)] == ["✗ 1/2", "∅ 0/1", "≠ 0/2"]
    assert reader.words.count("–") >= 3  # nothing of n


def test_every_verdict_has_its_colour(tmp_path: Path) -> None:
    text = written(tmp_path)
    for kind in VERDICTS:
        assert text.count(f"--{kind}:") == 2  # in light and in dark
        assert f".mark.{kind}," in text


def test_runs_that_came_to_the_same_are_told_once(tmp_path: Path) -> None:
    words = Reader(written(tmp_path, run(), run(number=2), run(number=3, right=False), asked=3)).words
    assert "runs 1, 2 · score 1.000 · 2.00 s, 3.0 calls, 110 tokens" in words
    assert "run 3 · score 0.500 · 2.00 s, 3 calls, 110 tokens" in words


def test_a_twin_is_linked_and_what_was_removed_is_told(tmp_path: Path) -> None:
    text = SUITE.replace("because: paint", "because: paint\n    twin: home-find\n    removed: the brush")
    reader = Reader(written(tmp_path, run(), run("home-paint"), text=text))
    assert "#m.home-find" in reader.all("href")
    assert {"possible twin", "the brush", "1 of 1"} <= set(reader.words)


def test_a_twin_that_was_not_run_is_named_without_a_link(tmp_path: Path) -> None:
    text = SUITE.replace("because: paint", "because: paint\n    twin: home-find\n    removed: the brush")
    missions = missions_in(tmp_path, text)[2:]
    reader = Reader(written(tmp_path, run("home-paint"), missions=missions))
    assert "home-find" in reader.words
    assert "#m.home-find" not in reader.all("href")


def test_what_is_not_done_and_who_was_given_up_is_told(tmp_path: Path) -> None:
    words = Reader(written(tmp_path, run(), models=("m", "n"), stopped={"n": "No key."})).words
    assert "1 of 6 runs are done." in words
    assert "was given up: No key." in words
    assert "No run is done." in words


@pytest.mark.parametrize("evil", [EVIL, "</style></main>", "&lt;b&gt; & ' \""])
def test_nothing_that_was_said_becomes_markup(tmp_path: Path, evil: str) -> None:
    quiet, loud = (
        written(
            tmp_path,
            run(model=words, right=False, got=words, differences=(words,), reasons=(words,)),
            models=(words,),
            suite=words,
            stopped={words: words},
        )
        for words in ("x", evil)
    )
    assert [tag for tag, _ in Reader(loud).tags] == [tag for tag, _ in Reader(quiet).tags]
    assert not {"\x1b", "\u202e", "\ud800"} & set(loud)
    assert loud.encode()


def test_equal_evaluations_give_equal_pages(tmp_path: Path) -> None:
    assert written(tmp_path, *RUNS) == written(tmp_path, *RUNS)
