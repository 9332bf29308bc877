"""Files that do not fit together: the line of the name that nothing has, and the names there are."""

from __future__ import annotations

from pathlib import Path

import pytest

from missiontree.formats.misfit import misfit

PLACES = {"robot type": ("truck", "cart"), "place": ("base", "camp")}
ALL = "fleet.yaml, scene.yaml: these do not fit together."


@pytest.fixture
def files(tmp_path: Path) -> list[Path]:
    fleet, scene = tmp_path / "fleet.yaml", tmp_path / "scene.yaml"
    fleet.write_text("# bse is not a place\ntypes:\n  - id: truck\n    near: bse-2\n    place: bse\n", encoding="utf-8")
    scene.write_text("places: [{id: base}, {id: camp}]\n", encoding="utf-8")
    return [tmp_path / "none.yaml", tmp_path, fleet, scene]


def test_the_line_is_that_of_the_name_that_nothing_has(files: list[Path]) -> None:
    """Not the comment above it, nor a longer name that it is part of; what cannot be read is passed over."""
    told = misfit("'truck' starts at place 'bse', which the scene does not have.", files, PLACES, ALL)
    assert (told.file, told.line, told.accepted, told.hint) == (str(files[2]), 5, "base, camp", "Did you mean 'base'?")


def test_without_a_near_name_those_there_are_are_enough(files: list[Path]) -> None:
    told = misfit("goal 'x' names robot type 'lorry', which the fleet does not have.", files, PLACES, ALL)
    assert (told.file, told.line, told.accepted, told.hint) == ("", 0, "truck, cart", ALL)
    files[3].write_text("places: []\nby: [lorry]", encoding="utf-8")
    told = misfit("goal 'x' names robot type 'lorry', which the fleet does not have.", files, PLACES, ALL)
    assert (told.file, told.line, told.hint) == (str(files[3]), 2, "")


def test_where_no_name_is_strange_all_files_are_told(files: list[Path]) -> None:
    for message in (
        "'truck' starts at place 'base', which is in a keep-out.",
        "place 'bse' is told twice.",
        "a road joins two floors; use a lift.",
    ):
        told = misfit(message, files, PLACES, ALL)
        assert (str(told), told.file) == (f"{message}\n  {ALL}", "")


def test_where_there_is_nothing_to_choose_from_all_files_are_told_beside_the_line(files: list[Path]) -> None:
    told = misfit("'truck' starts at place 'bse', which the scene does not have.", files, {"place": ()}, ALL)
    assert (told.line, told.accepted, told.hint) == (5, "", ALL)


def test_of_many_names_some_are_listed(files: list[Path]) -> None:
    names = tuple(f"p{number}" for number in range(40))
    told = misfit("'truck' starts at place 'bse', which the scene does not have.", files, {"place": names}, ALL)
    assert told.accepted == f"{', '.join(names[:12])}, …"
