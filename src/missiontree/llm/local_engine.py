"""The engine of local models (mistralrs): a GGUF file loaded, and one constrained answer at a time. All that knows mistralrs is here."""

from __future__ import annotations

import json
import os
from collections.abc import Generator, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from missiontree.llm.chat import FaultKind, ProviderError
from missiontree.llm.local_thread import apart

_QUIET_AND_OFFLINE = {"RUST_LOG": "off", "HF_HUB_OFFLINE": "1"}
_COMPACT = {"x-guidance": {"whitespace_flexible": False}}  # free blanks would let a model write blanks for ever
_KNOWN: tuple[tuple[str, FaultKind, str], ...] = (
    (
        "sequence length is greater",
        "context_overflow",
        "Use a model with a longer context, or a shorter mission or scene.",
    ),
    (
        "chat template",
        "bad_request",
        "Use the GGUF file of an instruction-tuned model, with its chat template in it (tokenizer.chat_template).",
    ),
    (
        "chat_template",
        "bad_request",
        "The chat template of the file does not take the dialogue; use another GGUF file.",
    ),
    ("satisfy the grammar", "failed", "A name on offer may look like a special token of the model; give it another."),
)
_DAMAGED = "The file may be damaged, or of a kind that the engine does not know; get it anew, or use another."


@dataclass(frozen=True, slots=True)
class Piece:
    """
    A piece of an answer.

    Parameters
    ----------
    text
        What is new.
    finish
        How the answer ended, in the engine's words; empty before it ends.
    input_tokens, output_tokens
        As counted by the engine; with the last piece only.
    """

    text: str
    finish: str = ""
    input_tokens: int = 0
    output_tokens: int = 0


class Engine:
    """
    A model in memory.

    Parameters
    ----------
    files
        The GGUF file, or all its parts.

    Raises
    ------
    ProviderError
        ``not_installed`` without mistralrs; ``failed`` if it does not take the file.
    """

    def __init__(self, files: Sequence[Path]) -> None:
        self._file = files[0]
        self._special: dict[int, str] = {}
        with _faults(self._file):
            (self._runner,) = apart(lambda: [_load(files)])

    def answer(
        self, chat: Sequence[Mapping[str, str]], schema: Mapping[str, Any], most: int
    ) -> Generator[Piece, None, None]:
        """
        Continue a chat by one answer that keeps to a schema, at each step by the likeliest token.

        Parameters
        ----------
        chat
            Messages of ``role`` and ``content``.
        schema
            JSON Schema of the answer.
        most
            Tokens after which it is cut.

        Raises
        ------
        ProviderError
            If the engine fails, or does not take the dialogue.
        """
        with _faults(self._file):
            messages = [{"role": one["role"], "content": self._harmless(one["content"])} for one in chat]
            yield from apart(lambda: self._pieces(messages, json.dumps({**_COMPACT, **schema}), most))

    def _pieces(self, messages: list[dict[str, str]], grammar: str, most: int) -> Iterator[Piece]:
        from mistralrs import ChatCompletionRequest

        request = ChatCompletionRequest(
            messages=messages,
            model="default",
            max_tokens=most,
            temperature=0.0,
            enable_thinking=False,  # thinking before the grammar begins has no bound
            stream=True,
            grammar_type="json_schema",
            grammar=grammar,
        )
        chunks: Any = self._runner.send_chat_completion_request(request)
        for chunk in chunks:
            choice, usage = chunk.choices[0], chunk.usage
            counts = (usage.prompt_tokens, usage.completion_tokens) if usage is not None else (0, 0)
            yield Piece(choice.delta.content or "", choice.finish_reason or "", *counts)

    def _harmless(self, text: str) -> str:
        """
        The text with a blank in whatever would be read as a special token.

        Otherwise a name in a scene could end the user's message and begin one of the system's.
        """
        while found := sorted({seen for seen in map(self._special_text, self._tokens(text)) if seen and seen in text}):
            for special in found:
                text = text.replace(special, f"{special[0]} {special[1:]}")
        return text

    def _tokens(self, text: str) -> list[int]:
        return sorted(set(self._runner.tokenize_text(text, add_special_tokens=False, enable_thinking=None)))

    def _special_text(self, token: int) -> str:
        """What a special token looks like; empty for any other, and for one that cannot be seen."""
        if token not in self._special:
            shown = self._runner.detokenize_text([token], skip_special_tokens=False).strip()
            plain = self._runner.detokenize_text([token], skip_special_tokens=True)
            self._special[token] = "" if plain or len(shown) < 2 else shown
        return self._special[token]


def _load(files: Sequence[Path]) -> Any:
    with _environment(_QUIET_AND_OFFLINE):
        try:
            from mistralrs import Runner, Which
        except ImportError as error:
            raise ProviderError(
                f"A local model needs mistralrs, which cannot be imported: {error}",
                "not_installed",
                "Install it: pip install 'missiontree[local]'",
            ) from error
        which: Any = Which.GGUF(
            quantized_model_id=str(files[0].parent), quantized_filename=[file.name for file in files]
        )
        return Runner(which, token_source="none")  # noqa: S106 - "none" says that there is no token


@contextmanager
def _environment(wanted: Mapping[str, str]) -> Iterator[None]:
    """The variables set while the engine starts, which reads them then; what the user has set stays."""
    new = {name: value for name, value in wanted.items() if name not in os.environ}
    os.environ.update(new)
    try:
        yield
    finally:
        for name in new:
            os.environ.pop(name, None)


@contextmanager
def _faults(file: Path) -> Iterator[None]:
    """Make a ``ProviderError`` of whatever the engine raises: errors of value, and panics, which are no ``Exception``."""
    try:
        yield
    except (ProviderError, KeyboardInterrupt, SystemExit, GeneratorExit):
        raise
    except BaseException as raised:
        said = next(iter(str(raised).splitlines()), type(raised).__name__)  # a trace of the engine's code follows
        for words, kind, hint in _KNOWN:
            if words in said:
                raise ProviderError(f"The local model {file.name} failed: {said:.500}", kind, hint) from raised
        raise ProviderError(f"The local model {file.name} failed: {said:.500}", "failed", _DAMAGED) from raised
