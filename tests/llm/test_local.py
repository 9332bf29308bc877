"""The real engine with a real file: a model that knows nothing, and yet cannot but say turns."""

from __future__ import annotations

import json
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest

from missiontree.authoring.author import author_tree
from missiontree.authoring.budgets import Budgets
from missiontree.authoring.prompt import opening
from missiontree.authoring.transcript import replay
from missiontree.llm.chat import Message, Tool
from missiontree.llm.local import LocalModel
from missiontree.llm.local_engine import Engine
from missiontree.llm.local_history import told_of
from tests.llm.local_checks import ASKED, SHORT, check
from tests.llm.tiny_gguf import write_tiny_gguf
from tests.llm.turns import OFFERED, STATES, builder_at

OUTCOMES = {"complete", "cannot_be_done", "incomplete", "exhausted"}
READ = " ".join(message.text for message in opening(builder_at("scene"))) + told_of(OFFERED["root only"])


@pytest.fixture(scope="module")
def file(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return write_tiny_gguf(tmp_path_factory.mktemp("model") / "tiny.gguf")


@pytest.fixture(scope="module")
def model(file: Path) -> LocalModel:
    return LocalModel(file, bounds=SHORT)


class Watched:
    """A model each of whose turns is checked against what was offered at it."""

    def __init__(self, model: LocalModel) -> None:
        self.model = model
        self.said: list[Message] = []

    def __call__(self, messages: Sequence[Message], tools: Sequence[Tool]) -> Message:
        said = self.model(messages, tools)
        self.said.append(said)
        check(said, tools, must_call=messages[-1].must_call)
        return said


@pytest.mark.parametrize(("seed", "state"), [(2, "no tree"), (3, "scene"), (4, "no tree")])
def test_a_dialogue_of_well_formed_turns_ends_in_a_named_outcome_and_replays(
    tmp_path: Path, seed: int, state: str
) -> None:
    brief = builder_at(state).brief
    model = LocalModel(write_tiny_gguf(tmp_path / "tiny.gguf", seed=seed, words_of=READ), bounds=SHORT)
    watched = Watched(model)
    made = author_tree(brief, watched, Budgets(turns=4))
    assert made.status in OUTCOMES
    assert len(watched.said) <= 4
    assert watched.said[0].calls, "the opening demands a call"
    again = replay(made.transcript, brief)
    assert (again.status, again.tree) == (made.status, made.tree)


@pytest.mark.parametrize(("seed", "state"), list(enumerate(STATES)))
def test_a_turn_at_any_state_names_only_what_is_there(tmp_path: Path, seed: int, state: str) -> None:
    """Each tool alone and all together, so that each grammar is met, and not only those that the weights happen to like."""
    model = LocalModel(write_tiny_gguf(tmp_path / "tiny.gguf", seed=seed, words_of=READ), bounds=SHORT)
    for tools in [OFFERED[state], *((tool,) for tool in OFFERED[state])]:
        check(model(ASKED, tools), tools, must_call=True)
    check(
        model((*ASKED, Message("assistant", "Hm."), Message("user", "Go on.")), OFFERED[state]),
        OFFERED[state],
        must_call=False,
    )


def test_the_same_dialogue_is_answered_alike(file: Path, model: LocalModel) -> None:
    """By another instance, and by one that has read the beginning before."""
    tools = OFFERED["scene"]
    first = model(ASKED, tools)
    assert model(ASKED, tools) == first
    assert LocalModel(file, bounds=SHORT)(ASKED, tools) == first


def test_dialogues_side_by_side_are_answered_as_one_after_the_other(file: Path, model: LocalModel) -> None:
    dialogues = [(Message("user", f"Mission {number}.", must_call=True),) for number in range(4)]
    alone = [model(dialogue, OFFERED["no tree"]) for dialogue in dialogues]
    other = LocalModel(file, bounds=SHORT)
    with ThreadPoolExecutor(4) as pool:
        assert list(pool.map(lambda dialogue: other(dialogue, OFFERED["no tree"]), dialogues)) == alone


def test_calls_have_ids_of_their_own_in_the_dialogue(model: LocalModel) -> None:
    tools = OFFERED["root only"]
    first = model(ASKED, tools)
    answers = [Message("tool", '{"ok": true}', call_id=call.id) for call in first.calls]
    second = model([*ASKED, first, *answers, Message("user", "Go on.", must_call=True)], tools)
    ids = [call.id for call in (*first.calls, *second.calls)]
    assert len(set(ids)) == len(ids) >= 2


def test_the_thought_is_told_piece_by_piece(file: Path) -> None:
    heard: list[str] = []
    said = LocalModel(file, listen=heard.append, bounds=SHORT)(ASKED, OFFERED["no tree"])
    assert "".join(heard) == said.text
    assert len(heard) > 1


def test_a_turn_that_is_cut_has_no_calls_and_says_so(file: Path, model: LocalModel) -> None:
    """12 tokens are the letters of {"thought":" as far as the quotation mark that begins it; 8 more are of the thought."""
    whole = model(ASKED, OFFERED["no tree"])
    cut = LocalModel(file, max_output_tokens=20, bounds=SHORT)(ASKED, OFFERED["no tree"])
    assert (cut.finish, cut.calls) == ("length", ())
    assert whole.text.startswith(cut.text.rstrip("�"))
    assert cut.text
    assert cut.usage is not None
    assert cut.usage.output_tokens == 20


def test_limits_of_output_are_positive(file: Path) -> None:
    with pytest.raises(ValueError, match="at least 1"):
        LocalModel(file, max_output_tokens=0)


def test_without_tools_there_are_words(model: LocalModel) -> None:
    said = model((Message("user", "Hello."),), ())
    check(said, (), must_call=False)
    assert said.calls == ()


WHOLE = {"type": "integer", "minimum": -3, "maximum": 120}
EVERY_FORM = Tool(
    "all",
    "Everything that a schema may say.",
    {
        "type": "object",
        "properties": {
            "text": {"type": "string", "minLength": 2},
            "number": WHOLE,
            "flag": {"type": "boolean"},
            "one": {"enum": ["a", 2, None]},
            "this": {"const": {"a": [1, "b"]}},
            "lists": {
                "type": "array",
                "items": {"type": "array", "items": {"anyOf": [{"type": "string"}, WHOLE]}, "minItems": 1},
            },
            "either": {"anyOf": [{"type": "array", "items": {"type": "null"}}, {"type": "object"}, {"type": "null"}]},
            "inner": {"type": "object", "properties": {"a": WHOLE, "b": {"type": "null"}}, "required": ["b"]},
        },
        "required": ["text", "number", "one", "this", "lists", "inner"],
    },
)


@pytest.mark.parametrize("seed", range(5))
def test_the_engine_keeps_to_every_form_that_a_schema_may_have(tmp_path: Path, seed: int) -> None:
    model = LocalModel(write_tiny_gguf(tmp_path / "tiny.gguf", seed=seed), bounds=SHORT)
    for number in range(3):
        asked = (Message("user", "Go on." * number, must_call=True),)
        check(model(asked, [EVERY_FORM]), [EVERY_FORM], must_call=True)


def test_names_that_are_hard_to_write_are_written_to_the_letter(model: LocalModel) -> None:
    """Quotation marks, letters of several bytes, line breaks, nothing at all."""
    names = ['the "red" one', "a\\b", "Jüngster", "犬", "🤖", "< |end|>", "two\nlines", ""]
    for name in names:
        tool = Tool(
            "find",
            "Find.",
            {
                "type": "object",
                "properties": {"who": {"type": "string", "enum": [name]}},
                "required": ["who"],
                "additionalProperties": False,
            },
        )
        calls = model(ASKED, [tool]).calls
        assert calls
        assert all(json.loads(call.arguments) == {"who": name} for call in calls)


def test_a_model_in_parts_is_one_model(tmp_path: Path, model: LocalModel) -> None:
    write_tiny_gguf(tmp_path / "parts.gguf", tensors_per_part=5)
    parts = sorted(tmp_path.glob("parts-*.gguf"))
    assert len(parts) == 3, "12 tensors, 5 to a file"
    in_parts = LocalModel(parts[1], bounds=SHORT)
    assert in_parts(ASKED, OFFERED["no tree"]) == model(ASKED, OFFERED["no tree"])


def test_the_engine_is_asked_for_the_likeliest_turn(file: Path) -> None:
    """With a schema that leaves no choice there is one answer, and it has no blank anywhere."""
    schema = {
        "type": "object",
        "properties": {"a": {"const": [1, {"b": None}]}},
        "required": ["a"],
        "additionalProperties": False,
    }
    pieces = list(Engine((file,)).answer([{"role": "user", "content": "Hello."}], schema, 100))
    assert "".join(piece.text for piece in pieces) == '{"a":[1,{"b":null}]}'
    assert [piece.finish for piece in pieces if piece.finish] == ["stop"]
