"""Missions by patterns."""

from pathlib import Path

import pytest

from missiontree.errors import InputError
from missiontree.evaluation.selection import chosen
from missiontree.evaluation.suite import load_suite
from tests.evaluation.contestants import suite_folder


@pytest.mark.parametrize(
    ("patterns", "ids"),
    [
        ((), ["find", "visit", "paint"]),
        (("home",), ["find", "visit", "paint"]),
        (("home-v*",), ["visit"]),
        (("home-paint", "home-find"), ["find", "paint"]),
        (("*-[fp]*", "home-find"), ["find", "paint"]),
    ],
)
def test_ids_and_settings_fit_in_the_order_of_the_suite(
    tmp_path: Path, patterns: tuple[str, ...], ids: list[str]
) -> None:
    missions = chosen(load_suite(suite_folder(tmp_path)), patterns)
    assert [mission.id.removeprefix("home-") for _, mission in missions] == ids


def test_a_pattern_that_fits_nothing_is_refused(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="'HOME' fits no mission"):
        chosen(load_suite(suite_folder(tmp_path)), ("home", "HOME"))
