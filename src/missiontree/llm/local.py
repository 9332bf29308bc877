"""A language model in this process, from a GGUF file; it can say nothing but turns that its schema allows."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from contextlib import closing
from pathlib import Path
from threading import Lock
from typing import Any

from missiontree.llm.chat import Listener, Message, ProviderError, Tool, Usage, deaf
from missiontree.llm.local_engine import Engine, Piece
from missiontree.llm.local_file import model_files
from missiontree.llm.local_history import plain_chat
from missiontree.llm.local_turn import read_turn, thought_in
from missiontree.llm.turn_schema import USUAL, TurnBounds, turn_schema


class LocalModel:
    """
    A chat model from a GGUF file, run by mistralrs (extra ``local``).

    Each turn is held to the JSON Schema of the tools offered at it, see :mod:`missiontree.llm.turn_schema`, so that it cannot call what
    is not offered or name what is not there. There is no chance in it: the likeliest token is taken at each step, and the same file on
    the same machine answers the same dialogue alike.

    Parameters
    ----------
    path
        The file. It is looked at here, and loaded at the first call.
    listen
        Told each piece of the thought as it comes in.
    max_output_tokens
        Tokens after which a turn is cut; it then ends as ``length`` and has no calls. Default 2,048.
    bounds
        The most that one turn may hold.

    Raises
    ------
    InputError
        If the file is missing, cannot be read, or is no GGUF file.
    ValueError
        If ``max_output_tokens`` is not positive.
    """

    def __init__(
        self,
        path: str | Path,
        *,
        listen: Listener = deaf,
        max_output_tokens: int = 2_048,
        bounds: TurnBounds = USUAL,
    ) -> None:
        if max_output_tokens < 1:
            raise ValueError(f"max_output_tokens must be at least 1, got {max_output_tokens}.")
        self._files = model_files(Path(path))
        self._listen, self._most, self._bounds = listen, max_output_tokens, bounds
        self._engine: Engine | None = None
        self._system_apart = True
        self._one_at_a_time = Lock()  # side by side, sums are rounded otherwise, and answers could differ

    def __call__(self, messages: Sequence[Message], tools: Sequence[Tool]) -> Message:
        """
        Say the next turn.

        Raises
        ------
        ProviderError
            ``not_installed`` without mistralrs, ``context_overflow``, ``bad_request`` if the file has no chat template that takes the
            dialogue, ``failed`` for anything else that the engine reports.
        """
        with self._one_at_a_time:
            return self._turn(messages, tools)

    def _turn(self, messages: Sequence[Message], tools: Sequence[Tool]) -> Message:
        schema = turn_schema(tools, must_call=bool(messages) and messages[-1].must_call, bounds=self._bounds)
        try:
            text, last = self._said(plain_chat(messages, tools, system_apart=self._system_apart), schema)
        except ProviderError as fault:
            if fault.kind != "bad_request" or not self._system_apart:
                raise
            # Some templates know no system; what it says can open the user's first message.
            text, last = self._said(plain_chat(messages, tools, system_apart=False), schema)
            self._system_apart = False
        return _message(text, last, turn=1 + sum(message.speaker == "assistant" for message in messages))

    def _said(self, chat: Sequence[Mapping[str, str]], schema: Mapping[str, Any]) -> tuple[str, Piece]:
        """What the engine writes, and the last piece of it; the thought is told on the way."""
        if self._engine is None:
            self._engine = Engine(self._files)
        text, told, last = "", "", Piece("")
        with closing(self._engine.answer(chat, schema, self._most)) as pieces:
            for last in pieces:
                text += last.text
                if len(thought := thought_in(text)) > len(told):
                    self._listen(thought[len(told) :])
                    told = thought
        return text, last


def _message(text: str, last: Piece, turn: int) -> Message:
    """The answer as a message. One that was cut has a thought, as far as it got, and no calls: nothing is made of half a turn."""
    usage = Usage(last.input_tokens, last.output_tokens)
    if last.finish == "length":
        return Message("assistant", thought_in(text), finish="length", usage=usage)
    if last.finish != "stop":
        raise ProviderError(
            f"The local model's answer broke off ({last.finish or 'without an end'}).", "cut_off", _AGAIN
        )
    try:
        thought, calls = read_turn(text, turn)
    except ValueError as error:
        raise ProviderError(f"The local model wrote no turn: {error}.", "failed", _NO_TURN) from error
    return Message("assistant", thought, calls, usage=usage)


_AGAIN = "Ask again; if it happens again, use another model."
_NO_TURN = "The engine is to hold it to one; use the version of mistralrs that missiontree[local] asks for."
