"""Suites by name."""

from pathlib import Path

import pytest

from missiontree.errors import InputError
from missiontree.evaluation.built_in import built_in_suites, suite_named
from tests.evaluation.contestants import suite_folder


def test_those_that_ship_are_known_by_name() -> None:
    assert {"english", "everyday", "models"} <= set(built_in_suites())
    for name in built_in_suites():
        called, suite = suite_named(name)
        assert (called, bool(suite.settings)) == (name, True)


def test_a_folder_is_a_suite_of_its_name(tmp_path: Path) -> None:
    name, suite = suite_named(str(suite_folder(tmp_path)))
    assert (name, list(suite.ids)) == ("suite", ["home"])


def test_what_is_neither_is_refused_with_what_there_is() -> None:
    with pytest.raises(InputError, match="english, everyday, models"):
        suite_named("splendid")


def test_a_setting_alone_is_a_suite_unless_there_is_a_folder_of_that_name(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert suite_named("paper")[1].ids.keys() == {"paper"}
    suite_folder(tmp_path).rename(tmp_path / "paper")
    monkeypatch.chdir(tmp_path)
    assert suite_named("paper")[1].ids.keys() == {"home"}
