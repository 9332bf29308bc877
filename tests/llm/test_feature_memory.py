"""What is learnt of endpoints outlives the process, and a file that is in the way costs nothing but that."""

from __future__ import annotations

import json
from pathlib import Path
from threading import Thread

import pytest

from missiontree.llm.feature_memory import FeatureMemory, usual_path
from missiontree.llm.features import Features

FEWER = Features(strict=False, named=False)


def test_what_was_learnt_is_known_by_the_next_process(tmp_path: Path) -> None:
    path = tmp_path / "not" / "there" / "endpoints.json"
    FeatureMemory(path).learn("http://a/v1", "m", FEWER)
    memory = FeatureMemory(path)
    assert memory.known("http://a/v1", "m") == FEWER
    assert memory.known("http://a/v1", "n") == memory.known("http://b/v1", "m") == Features()
    assert json.loads(path.read_text(encoding="utf-8")) == {
        "format": "endpoints/1",
        "endpoints": [{"url": "http://a/v1", "model": "m", "without": ["strict", "named"]}],
    }
    assert [entry.name for entry in path.parent.iterdir()] == ["endpoints.json"]


def test_what_others_learnt_meanwhile_stays(tmp_path: Path) -> None:
    path = tmp_path / "endpoints.json"
    first, second = FeatureMemory(path), FeatureMemory(path)
    first.learn("http://a/v1", "m", FEWER)
    second.learn("http://b/v1", "m", FEWER)
    assert FeatureMemory(path).known("http://a/v1", "m") == FEWER
    assert second.known("http://a/v1", "m") == FEWER


def test_without_a_file_it_is_kept_in_the_process() -> None:
    memory = FeatureMemory()
    memory.learn("http://a/v1", "m", FEWER)
    assert memory.known("http://a/v1", "m") == FEWER
    assert FeatureMemory().known("http://a/v1", "m") == Features()


@pytest.mark.parametrize(
    "text",
    [
        "",
        "{",
        "[]",
        "7",
        "null",
        "[" * 100_000,
        '{"endpoints": 7}',
        '{"endpoints": [7]}',
        '{"endpoints": [{"url": 1, "model": "m", "without": []}]}',
        '{"endpoints": [{"url": "http://a/v1", "model": "m", "without": "strict"}]}',
        '{"endpoints": [{"url": "http://a/v1", "model": "m"}]}',
        " " * 1_000_001,
        "\udc80",
    ],
)
def test_a_damaged_file_counts_as_empty_and_is_written_anew(tmp_path: Path, text: str) -> None:
    path = tmp_path / "endpoints.json"
    path.write_bytes(text.encode("utf-8", "surrogateescape"))
    memory = FeatureMemory(path)
    assert memory.known("http://a/v1", "m") == Features()
    memory.learn("http://a/v1", "m", FEWER)
    assert FeatureMemory(path).known("http://a/v1", "m") == FEWER


def test_a_feature_of_another_version_is_passed_over(tmp_path: Path) -> None:
    path = tmp_path / "endpoints.json"
    path.write_text(
        '{"endpoints": [{"url": "u", "model": "m", "without": ["telepathy", 7, "strict"]}]}', encoding="utf-8"
    )
    assert FeatureMemory(path).known("u", "m") == Features(strict=False)


def test_a_file_that_cannot_be_written_is_not_missed(tmp_path: Path) -> None:
    """Its folder is a file. Root may write anywhere, so rights are no way to test this."""
    (tmp_path / "folder").write_text("", encoding="utf-8")
    memory = FeatureMemory(tmp_path / "folder" / "endpoints.json")
    memory.learn("http://a/v1", "m", FEWER)
    assert memory.known("http://a/v1", "m") == FEWER


def test_a_folder_in_the_place_of_the_file_is_not_missed_either(tmp_path: Path) -> None:
    path = tmp_path / "endpoints.json"
    path.mkdir()
    memory = FeatureMemory(path)
    memory.learn("http://a/v1", "m", FEWER)
    assert memory.known("http://a/v1", "m") == FEWER
    assert [entry.name for entry in tmp_path.iterdir()] == ["endpoints.json"]


def test_many_threads_lose_nothing(tmp_path: Path) -> None:
    memory = FeatureMemory(tmp_path / "endpoints.json")
    threads = [Thread(target=memory.learn, args=("u", f"m{number}", FEWER)) for number in range(20)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    again = FeatureMemory(tmp_path / "endpoints.json")
    assert [again.known("u", f"m{number}") for number in range(20)] == [FEWER] * 20


def test_only_the_latest_five_hundred_are_kept(tmp_path: Path) -> None:
    path = tmp_path / "endpoints.json"
    entries = [{"url": "u", "model": str(number), "without": ["strict"]} for number in range(500)]
    path.write_text(json.dumps({"endpoints": entries}), encoding="utf-8")
    FeatureMemory(path).learn("u", "new", FEWER)
    memory = FeatureMemory(path)
    assert (memory.known("u", "0"), memory.known("u", "1")) == (Features(), Features(strict=False))
    assert memory.known("u", "new") == FEWER


def test_the_usual_place_is_the_users_cache(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("HOME", "/home/anna")
    assert usual_path({"XDG_CACHE_HOME": "/var/cache/anna"}) == Path("/var/cache/anna/missiontree/endpoints.json")
    for environment in ({}, {"XDG_CACHE_HOME": ""}, {"XDG_CACHE_HOME": "relative"}):
        assert usual_path(environment) == Path("/home/anna/.cache/missiontree/endpoints.json")
