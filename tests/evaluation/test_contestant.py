"""Models as a person names them."""

from collections.abc import Callable
from pathlib import Path

import pytest

from missiontree.errors import InputError
from missiontree.evaluation.contestant import Contestant, named
from missiontree.llm.chat import ChatModel
from missiontree.llm.scripted import ScriptedModel


def test_the_offline_author_is_itself() -> None:
    assert named("offline") == Contestant("offline", "offline")
    assert named("offline", base_url="http://host/v1") == Contestant("offline", "offline")


def test_an_address_is_part_of_the_name_without_its_secrets() -> None:
    own = named("openai:m@http://me:secret@host:8000/v1?key=secret")
    assert (own.name, own.model) == ("openai:m@http://host:8000/v1", "openai:m")
    assert own.base_url == "http://me:secret@host:8000/v1?key=secret"
    common = named("openai:m", base_url="http://other/v1")
    assert (common.name, common.base_url) == ("openai:m@http://other/v1", "http://other/v1")
    assert named("openai:m@http://host/v1", base_url="http://other/v1").base_url == "http://host/v1"


def test_a_name_may_hold_an_at_sign() -> None:
    assert named("openai:m@2024", base_url="http://host/v1").model == "openai:m@2024"


def test_a_model_that_has_no_address_keeps_its_name() -> None:
    assert named("anthropic:m", base_url="http://host/v1") == Contestant("anthropic:m", "anthropic:m")


@pytest.mark.parametrize(
    "text",
    [
        "splendid",
        "openai:",
        "openai",
        "",
        "anthropic:m@http://host/v1",
        "offline@http://host/v1",
        "recorded:a@http://host/v1",
        "recorded:none.jsonl",
        "local:none.gguf",
        "local:",
    ],
)
def test_what_is_no_model_is_refused_before_anything_is_run(text: str) -> None:
    with pytest.raises(InputError):
        named(text)


def test_a_recording_is_a_contestant(tmp_path: Path) -> None:
    file = tmp_path / "r.jsonl"
    file.write_text("{}\n", encoding="utf-8")
    assert named(f"recorded:{file}") == Contestant(f"recorded:{file}", f"recorded:{file}")


def test_a_function_makes_a_model_for_each_run() -> None:
    make: Callable[[], ChatModel] = lambda: ScriptedModel([])  # noqa: E731
    contestant = Contestant("mine", make)
    assert contestant.ready() is not contestant.ready()
