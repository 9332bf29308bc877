"""Words and files become one request; what is given goes before what a file says."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from missiontree.briefing import MAX_WORDS, request_from
from missiontree.errors import InputError
from missiontree.mission.estimate import Weights
from missiontree.samples.catalogue import PROJECT, SAMPLES, sample_file


def test_words_alone_take_the_papers_team() -> None:
    request = request_from("Find the cat")
    assert request.brief.fleet.types[0].id == "mobile_scooter"
    assert request.brief.scene is None
    assert (request.k, request.allocator, request.model, request.seed) == (4, "exact", "offline", 0)
    assert request.scheduler == "greedy"
    assert request.sources == ("fleet the paper's team",)


def test_a_mission_file_names_everything_and_arguments_go_before_it() -> None:
    request = request_from(PROJECT / "mission.yaml")
    assert request.k == 3
    assert request.brief.weights == Weights(1.0, 0.001)
    assert "Inspect" in request.brief.routines.by_id
    told = request_from(PROJECT / "mission.yaml", k=7, weights=Weights(2.0), check_kinds=False)
    assert (told.k, told.brief.weights, told.brief.check_kinds) == (7, Weights(2.0), False)


def test_words_in_a_project_take_up_its_files() -> None:
    request = request_from("Inspect the crane", project=PROJECT / "mission.yaml")
    assert request.brief.text == "Inspect the crane"
    assert request.brief.scene is not None
    assert any("make_safe" in source for source in request.sources)


def test_too_many_words_are_refused() -> None:
    with pytest.raises(InputError, match=f"at most {MAX_WORDS} words"):
        request_from("find " * (MAX_WORDS + 1))


@pytest.mark.parametrize("name", SAMPLES)
def test_every_sample_can_be_gathered(name: str) -> None:
    assert request_from(sample_file(name)).brief.text


def test_a_file_that_is_not_there_is_named(tmp_path: Path) -> None:
    with pytest.raises(InputError) as caught:
        request_from(tmp_path / "mission.yaml")
    assert caught.value.file == str(tmp_path / "mission.yaml")


def test_a_path_as_text_is_a_path() -> None:
    assert request_from(str(PROJECT / "mission.yaml")).k == 3


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        ({"mission": None}, "None"),
        ({"mission": 3}, "mission is 3"),
        ({"fleet": {"types": []}}, "a Fleet, or the path of a fleet file"),
        ({"routines": "inspect.yaml"}, "a list of routines"),
        ({"weights": (1, 2, 3, 4)}, "up to three numbers"),
        ({"weights": (-1,)}, "at least 0"),
        ({"k": "3"}, "a whole number of at least 1"),
        ({"k": 0}, "a whole number of at least 1"),
        ({"k": True}, "a whole number of at least 1"),
        ({"seed": "x"}, "a whole number"),
        ({"model": 5}, "offline, recorded"),
    ],
)
def test_an_argument_of_the_wrong_type_is_refused_in_words(arguments: dict[str, Any], words: str) -> None:
    with pytest.raises(InputError) as caught:
        request_from(**{"mission": "Find the cat", **arguments})
    assert words in str(caught.value)
