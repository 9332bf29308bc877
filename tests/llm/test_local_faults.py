"""Whatever goes wrong with a local model comes as a ProviderError that says what it was; nothing crashes."""

from __future__ import annotations

import random
import sys
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path
from types import ModuleType, SimpleNamespace
from typing import Any

import pytest

from missiontree.llm.chat import Message, ProviderError, Tool
from missiontree.llm.local import LocalModel
from missiontree.llm.turn_schema import TurnBounds
from tests.llm.tiny_gguf import TURNS, write_tiny_gguf

HELLO = (Message("user", "Hello."),)
SHORT = TurnBounds(thought=8)


@pytest.fixture(scope="module")
def file(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return write_tiny_gguf(tmp_path_factory.mktemp("model") / "tiny.gguf")


def fault_of(file: Path, messages: tuple[Message, ...] = HELLO, tools: tuple[Tool, ...] = ()) -> ProviderError:
    """What the model in the file raises when it is asked, and raises again when it is asked again."""
    model = LocalModel(file, bounds=SHORT)
    with pytest.raises(ProviderError) as raised:
        model(messages, tools)
    with pytest.raises(ProviderError) as again:
        model(messages, tools)
    assert (str(again.value), again.value.kind) == (str(raised.value), raised.value.kind)
    assert "\n" not in str(raised.value), "the engine's trace is nothing for people"
    assert raised.value.hint
    return raised.value


@pytest.mark.parametrize("kept", [4, 5, 8, 16, 24, 100, 2_000, 6_000, 20_000, -1])
def test_a_file_that_is_cut_is_reported_with_its_name(file: Path, tmp_path: Path, kept: int) -> None:
    cut = tmp_path / "cut.gguf"
    cut.write_bytes(file.read_bytes()[:kept])
    fault = fault_of(cut)
    assert fault.kind == "failed"
    assert "cut.gguf" in str(fault)
    assert "damaged" in fault.hint


@pytest.mark.parametrize("seed", range(10))
def test_a_file_with_wrong_bytes_answers_or_is_reported(file: Path, tmp_path: Path, seed: int) -> None:
    """In the first bytes stand sizes, names and kinds, where a wrong one does most harm."""
    rng = random.Random(seed)  # noqa: S311 - chance that is not chance
    sound = file.read_bytes()
    for number in range(10):
        wrong = bytearray(sound)
        for _ in range(rng.choice((1, 2, 5))):
            wrong[rng.randrange(4, 6_000)] = rng.randrange(256)
        damaged = tmp_path / f"{number}.gguf"
        damaged.write_bytes(wrong)
        with suppress(ProviderError):
            assert LocalModel(damaged, bounds=SHORT)(HELLO, ()).speaker == "assistant"


def test_weights_that_are_no_numbers_are_reported(file: Path, tmp_path: Path) -> None:
    """All weights made NaN: there is no likeliest token any more."""
    sound = file.read_bytes()
    broken = tmp_path / "nan.gguf"
    broken.write_bytes(sound[:-100_000] + b"\xff\xff\xff\x7f" * 25_000)
    assert fault_of(broken).kind == "failed"


def test_a_file_without_a_chat_template_is_reported(tmp_path: Path) -> None:
    fault = fault_of(write_tiny_gguf(tmp_path / "base.gguf", template=None))
    assert fault.kind == "bad_request"
    assert "instruction-tuned" in fault.hint


@pytest.mark.parametrize("template", ["{% for %}", "{{ raise_exception('not this one') }}" + TURNS])
def test_a_template_that_takes_no_dialogue_is_reported(tmp_path: Path, template: str) -> None:
    fault = fault_of(write_tiny_gguf(tmp_path / "odd.gguf", template=template))
    assert fault.kind == "bad_request"
    assert "template" in fault.hint


def test_a_dialogue_longer_than_the_context_is_reported(tmp_path: Path) -> None:
    """1,000 letters, each a token, for a model that takes in 512."""
    small = write_tiny_gguf(tmp_path / "small.gguf", context=512)
    fault = fault_of(small, (Message("user", "x" * 1_000),))
    assert fault.kind == "context_overflow"
    assert "longer context" in fault.hint


def test_a_turn_that_fills_the_context_ends_as_cut(tmp_path: Path) -> None:
    """With 500 of 512 tokens read, 12 are left; the shortest turn, {"thought":"","calls":[]}, needs more than those."""
    small = LocalModel(write_tiny_gguf(tmp_path / "small.gguf", context=512))
    shortest = small((Message("user", ""),), ()).usage
    assert shortest is not None
    said = small((Message("user", "x" * (500 - shortest.input_tokens)),), ())
    assert (said.finish, said.calls) == ("length", ())
    assert said.usage is not None
    assert said.usage.input_tokens == 500


def test_a_name_on_offer_that_is_a_special_token_is_reported_and_harms_nothing_else(file: Path) -> None:
    model = LocalModel(file, bounds=SHORT)
    who = {
        "type": "object",
        "properties": {"who": {"enum": ["<|end|>"]}},
        "required": ["who"],
        "additionalProperties": False,
    }
    with pytest.raises(ProviderError, match="grammar") as raised:
        model((Message("user", "Hello.", must_call=True),), [Tool("find", "Find.", who)])
    assert "give it another" in raised.value.hint
    assert model(HELLO, ()).finish == "stop"


def test_without_the_extra_the_error_says_how_to_install_it(file: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "mistralrs", None)  # as if it were not there
    fault = fault_of(file)
    assert fault.kind == "not_installed"
    assert "pip install 'missiontree[local]'" in fault.hint


class Panic(BaseException):
    """As native code raises them: no Exception."""


def engine_that(monkeypatch: pytest.MonkeyPatch, says: Any) -> None:
    """Put an engine in place that does what the real one cannot be brought to do: give these pieces, or raise this."""

    class Runner:
        def __init__(self, which: object, **more: object) -> None:
            if says is Panic:
                raise Panic("index out of bounds\nat engine.rs:1")

        def tokenize_text(self, text: str, **more: object) -> list[int]:
            return []

        def send_chat_completion_request(self, request: object) -> Iterator[object]:
            for text, finish in says:
                if isinstance(text, BaseException):
                    raise text
                choice = SimpleNamespace(delta=SimpleNamespace(content=text), finish_reason=finish)
                yield SimpleNamespace(choices=[choice], usage=None)

    module = ModuleType("mistralrs")
    vars(module).update(Runner=Runner, Which=SimpleNamespace(GGUF=dict), ChatCompletionRequest=dict)
    monkeypatch.setitem(sys.modules, "mistralrs", module)


@pytest.mark.parametrize(
    ("says", "kind", "words"),
    [
        (Panic, "failed", "index out of bounds"),
        ([('{"thou', None), (Panic("worse"), None)], "failed", "worse"),
        ([('{"thou', None), (ValueError(""), None)], "failed", "ValueError"),
        ([('{"thought":"', None), ("", "canceled")], "cut_off", "canceled"),
        ([('{"thought":"a","calls":[]}', None)], "cut_off", "without an end"),
        ([], "cut_off", "without an end"),
        ([("", "stop")], "failed", "wrote no turn"),
        ([("Let me think.", "stop")], "failed", "wrote no turn"),
        ([('{"thought":"a","calls":[', "stop")], "failed", "wrote no turn"),
        ([(None, None), ('{"thought": "a", "calls": []}', "stop")], "failed", "wrote no turn"),
    ],
)
def test_an_engine_that_fails_or_breaks_its_promise_is_reported_and_its_words_are_not_mended(
    file: Path, monkeypatch: pytest.MonkeyPatch, says: Any, kind: str, words: str
) -> None:
    engine_that(monkeypatch, says)
    fault = fault_of(file)
    assert fault.kind == kind
    assert words in str(fault)


def test_a_turn_of_the_stand_in_engine_is_taken(file: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The engine above is believed where it keeps its promise, so what it was refused for is its fault."""
    engine_that(monkeypatch, [('{"thought":"a', None), (None, None), ('","calls":[]}', "stop")])
    assert LocalModel(file)(HELLO, ()).text == "a"
