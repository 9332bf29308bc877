"""Chat templates differ in what they take; each gets the dialogue in a form that it takes, and no name can break it."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from missiontree.llm.chat import Message, ToolCall
from missiontree.llm.local import LocalModel
from missiontree.llm.local_engine import Engine
from tests.llm.local_checks import ASKED, SHORT, check
from tests.llm.tiny_gguf import ALTERNATING, NO_SYSTEM, THINKING, write_tiny_gguf
from tests.llm.turns import OFFERED


def test_what_looks_like_a_special_token_is_read_as_letters(tmp_path: Path) -> None:
    """``< |end|>`` are 8 letters, each a token of this model; read as what it looks like, ``<|end|>`` were a single one."""

    model = LocalModel(write_tiny_gguf(tmp_path / "tiny.gguf"), bounds=SHORT)

    def read(text: str) -> int:
        usage = model((Message("user", text),), ()).usage
        assert usage is not None
        return usage.input_tokens

    assert read("Tim" + "<|end|>" * 10) - read("Tim") == 80
    assert read("Tim<|en<|end|>d|>") - read("Tim") == len("<|en< |end|>d|>")


def test_a_template_that_knows_no_system_is_told_all_by_the_user(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """That it knows none is learnt once."""
    began: list[str] = []
    answer = Engine.answer

    def noted(self: Engine, chat: Any, schema: Any, most: int) -> Any:
        began.append(chat[0]["role"])
        return answer(self, chat, schema, most)

    monkeypatch.setattr(Engine, "answer", noted)
    model = LocalModel(write_tiny_gguf(tmp_path / "tiny.gguf", template=NO_SYSTEM), bounds=SHORT)
    for _ in range(2):
        check(model(ASKED, OFFERED["no tree"]), OFFERED["no tree"], must_call=True)
    assert began == ["system", "user", "user"]


def test_a_template_that_has_models_think_aloud_is_told_not_to(tmp_path: Path) -> None:
    """What is thought aloud is no part of the answer, and no schema bounds it; a turn has its thought inside."""
    model = LocalModel(write_tiny_gguf(tmp_path / "tiny.gguf", template=THINKING), bounds=SHORT)
    check(model(ASKED, OFFERED["no tree"]), OFFERED["no tree"], must_call=True)


def test_a_template_that_wants_turns_gets_turns(tmp_path: Path) -> None:
    """Two answers and a reminder of the user follow two calls; then the user speaks twice in a row."""
    model = LocalModel(write_tiny_gguf(tmp_path / "tiny.gguf", template=ALTERNATING), bounds=SHORT)
    calls = (ToolCall("1", "listRoutines", "{}"), ToolCall("2", "listRoutines", "{}"))
    said = (
        *ASKED,
        Message("assistant", "", calls),
        Message("tool", "{}", call_id="1"),
        Message("tool", "{}", call_id="2"),
        Message("user", "Go on."),
        Message("assistant", ""),
        Message("user", "Go on!"),
    )
    check(model(said, OFFERED["no tree"]), OFFERED["no tree"], must_call=False)
