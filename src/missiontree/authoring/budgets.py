"""How long a dialogue with a model may go on, and the meter that tells what it has taken."""

from __future__ import annotations

import json
from collections.abc import Callable, Sequence
from dataclasses import dataclass

from missiontree.llm.chat import Message, Tool
from missiontree.mission.reason import Reason
from missiontree.mission.spent import Spent
from missiontree.mission.value import Count, Index, Positive, Value

BYTES_PER_TOKEN = 3
"""For providers that do not count: cautious for English and JSON, where tokenizers need about four bytes."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Budgets(Value):
    """
    How long a dialogue may go on. Each limit that is met ends it as ``exhausted``, with the tree so far.

    Parameters
    ----------
    turns
        Messages of the model. Default 60.
    calls
        Calls of all turns together. Default 500.
    refusals
        Calls refused one after the other; an answer cut at its length limit counts as one. Default 12.
    repeats
        Calls, of all turns together, that were answered before and changed nothing. Default 8.
    tokens
        Tokens sent and received, of all turns together. Default 500,000.
    seconds
        Seconds by the clock after which no further turn begins. Default 1,200.
    reminders
        How often a model that stops early is told what is missing; after that the dialogue ends as ``incomplete``. Default 2.
    reviews
        How often at most a tree that passes the gate is put before the model once more: with the answer to the call that completes it,
        and when the model stops after it has added to the tree since. Default 2.
    """

    turns: Count = 60
    calls: Count = 500
    refusals: Count = 12
    repeats: Count = 8
    tokens: Count = 500_000
    seconds: Positive = 1_200.0
    reminders: Index = 2
    reviews: Index = 2


class Meter:
    """
    What a dialogue has taken so far, against its budgets.

    Parameters
    ----------
    budgets
        What it may take.
    clock
        Monotonic seconds.
    """

    def __init__(self, budgets: Budgets, clock: Callable[[], float]) -> None:
        self.budgets = budgets
        self._clock, self._began = clock, clock()
        self.turns = self.calls = self.refused = self.refused_in_a_row = self.repeats = 0
        self._input = self._output = 0
        self._estimated, self._cost = False, 0.0
        self._cost_known = True

    def turn(self, sent: Sequence[Message], tools: Sequence[Tool], said: Message) -> None:
        """Count one message of the model. Tokens that its provider does not count are estimated."""
        self.turns += 1
        if said.usage is None:
            self._estimated = True
            self._input += estimated_tokens(sent, tools)
            self._output += estimated_tokens((said,))
        else:
            self._input += said.usage.input_tokens
            self._output += said.usage.output_tokens
        if said.usage is None or said.usage.cost_usd is None:
            self._cost_known = False
        else:
            self._cost += said.usage.cost_usd

    def call(self, ok: bool, repeated: bool) -> None:
        """Count one call."""
        self.calls += 1
        if ok:
            self.refused_in_a_row = 0
        else:
            self.refused += 1
            self.refused_in_a_row += 1
        self.repeats += repeated

    def cut(self) -> None:
        """Count an answer that was cut; it counts as a refusal, though no call was made."""
        self.refused_in_a_row += 1

    def spent(self) -> Spent:
        """What it has taken."""
        return Spent(
            turns=self.turns,
            calls=self.calls,
            refused=self.refused,
            input_tokens=self._input,
            output_tokens=self._output,
            estimated=self._estimated,
            seconds=round(max(0.0, self._clock() - self._began), 3),
            cost_usd=round(self._cost, 6) if self._cost_known and self.turns else None,
        )

    def over(self) -> tuple[Reason, ...]:
        """Which budget forbids a further turn; empty if none does."""
        limits = self.budgets
        spent = self.spent()
        met = (
            ("turns", self.turns, limits.turns),
            ("tokens", spent.input_tokens + spent.output_tokens, limits.tokens),
            ("seconds", spent.seconds, limits.seconds),
        )
        return next((_exhausted(name, limit) for name, taken, limit in met if taken >= limit), ()) or self.stuck()

    def stuck(self) -> tuple[Reason, ...]:
        """Which budget of calls forbids a further call; empty if none does."""
        limits = self.budgets
        met = (
            ("refusals one after the other", self.refused_in_a_row, limits.refusals),
            ("repeated calls", self.repeats, limits.repeats),
            ("calls", self.calls, limits.calls),
        )
        return next((_exhausted(name, limit) for name, taken, limit in met if taken >= limit), ())


def estimated_tokens(messages: Sequence[Message], tools: Sequence[Tool] = ()) -> int:
    """About how many tokens a request takes: a token for three bytes of its texts, rounded up."""
    size = sum(len(message.text.encode("utf-8", "replace")) for message in messages)
    for call in (call for message in messages for call in message.calls):
        size += len(call.name.encode("utf-8", "replace")) + len(call.arguments.encode("utf-8", "replace"))
    for tool in tools:
        size += len(json.dumps([tool.name, tool.description, dict(tool.parameters)], ensure_ascii=False).encode())
    return -(-size // BYTES_PER_TOKEN)


def _exhausted(what: str, limit: float) -> tuple[Reason, ...]:
    return (
        Reason(
            rule="budget_exhausted",
            message=f"The dialogue used up its {limit:g} {what}; the tree was not finished by then.",
            needed=what,
            hint="Allow more, or use another model.",
        ),
    )
