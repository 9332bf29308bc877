"""
Can a damaged call do harm? Sound dialogues with 25 kinds of damage, through the real loop.

::

    python -m benchmarks.malformed_streams --count 21000 --seed 1 --state streams.json

Every other run cuts a call short, until each call of each dialogue was cut after every byte, once for a model that sends the call
again when it is refused and once for one that goes on. The other runs take the other kinds in turn; some of them damage several
calls, and some models send the damaged call for ever.
"""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cache
from random import Random
from typing import Literal

from benchmarks.campaign import Campaign, Verdict, luck, run
from benchmarks.campaign_damage import DAMAGES, TRUNCATED, Damaged, cut_short, damaged, written
from benchmarks.campaign_dialogues import Call, Dialogue, dialogues
from benchmarks.campaign_history import NEVER, Violation, asked_of, faults_of
from missiontree.authoring.author import author_tree
from missiontree.authoring.budgets import Budgets
from missiontree.authoring.outcome import Authored
from missiontree.llm.chat import Message, Tool
from missiontree.llm.scripted import ScriptedModel, Turn

ACCEPTED = "damaged calls accepted"
UNFINISHED = "calls sent again in vain"
COUNT = 21_000
TOKENS = 10**9  # a text of a million letters, sent back with every turn, would use up the default
Manner = Literal["again", "on", "stubborn"]
_NEED_NO_ARGUMENTS = ("wrong function", "empty")


@dataclass
class DamagingModel:
    """
    Sends the calls of a dialogue, some of them damaged, one to a turn or all at once.

    Parameters
    ----------
    calls
        The sound calls.
    damage
        What is sent instead, by number of the call.
    manner
        What it does about a refusal: sends the sound call ``again``, goes ``on``, or sends the damaged one for ever (``stubborn``).
    at_once
        Whether all calls stand in one turn.
    """

    calls: Sequence[Call]
    damage: Mapping[int, Damaged]
    manner: Manner
    at_once: bool
    seen: Sequence[Message] = ()
    sent: list[int] = field(default_factory=list)
    mended: set[int] = field(default_factory=set)
    position: int = 0

    def __call__(self, messages: Sequence[Message], tools: Sequence[Tool]) -> Turn:
        self.seen = messages
        again = [number for number in self._refused(messages) if number in self.damage or self.at_once]
        if self.manner == "stubborn" and again:
            self.sent = again
            return [self._said(number) for number in again]
        fresh = [number for number in again if self.manner == "again" and number not in self.mended]
        if fresh:
            self.mended |= set(fresh)
            self.sent = fresh
            return [self._sound(number) for number in fresh]
        until = len(self.calls) if self.at_once else self.position + 1
        self.sent = list(range(self.position, min(until, len(self.calls))))
        self.position = until
        return [self._said(number) for number in self.sent]

    def _refused(self, messages: Sequence[Message]) -> list[int]:
        answers: list[Message] = []
        for message in reversed(messages):
            if message.speaker != "tool":
                break
            answers.insert(0, message)
        return [number for number, answer in zip(self.sent, answers, strict=False) if not json.loads(answer.text)["ok"]]

    def _said(self, number: int) -> tuple[str, str]:
        if number in self.damage:
            return self.damage[number].name, self.damage[number].arguments
        return self._sound(number)

    def _sound(self, number: int) -> tuple[str, str]:
        name, arguments = self.calls[number]
        return name, written(arguments)


@dataclass(frozen=True, slots=True)
class Stream:
    """One damaged dialogue."""

    kind: str
    dialogue: Dialogue
    damage: Mapping[int, Damaged]
    manner: Manner
    at_once: bool


@cache
def cuts(seed: int) -> list[tuple[int, int, int, Manner]]:
    """Every cut there is: dialogue, call, bytes that are left, manner; in an order of luck, so that a few are a fair sample."""
    every: list[tuple[int, int, int, Manner]] = [
        (which, number, length, manner)
        for which, dialogue in enumerate(dialogues())
        for number, (_, arguments) in enumerate(dialogue.calls)
        for length in range(len(written(arguments).encode()))
        for manner in ("again", "on")
    ]
    luck(seed, -1).shuffle(every)
    return every


def stream(seed: int, index: int) -> Stream:
    """The stream of that number."""
    rng = luck(seed, index)
    number, other = divmod(index, 2)
    if not other and number < len(cuts(seed)):
        which, call, length, manner = cuts(seed)[number]
        dialogue = dialogues()[which]
        return Stream(TRUNCATED, dialogue, {call: cut_short(dialogue.calls[call], length)}, manner, rng.random() < 0.3)
    kind = list(DAMAGES)[(number if index < 2 * len(cuts(seed)) else index) % len(DAMAGES)]
    dialogue = rng.choice(dialogues())
    damage = dict([_one(rng, dialogue, kind)])
    for _ in range(rng.choice((0, 0, 0, 1, 3))):
        further, again = _one(rng, dialogue, rng.choice(list(DAMAGES)))
        damage.setdefault(further, again)
    manner = rng.choice(("again", "again", "again", "on", "on", "on", "stubborn"))
    return Stream(kind, dialogue, damage, manner, rng.random() < 0.3)


def _one(rng: Random, dialogue: Dialogue, kind: str) -> tuple[int, Damaged]:
    fit = [number for number, (_, arguments) in enumerate(dialogue.calls) if arguments or kind in _NEED_NO_ARGUMENTS]
    number = rng.choice(fit)
    return number, damaged(rng, kind, dialogue.calls[number])


@cache
def sound(which: str) -> Authored:
    """What a dialogue comes to without damage."""
    dialogue = next(dialogue for dialogue in dialogues() if dialogue.name == which)
    return author_tree(dialogue.brief, ScriptedModel([[call] for call in dialogue.calls]))


def judge(seed: int, index: int) -> Verdict:
    """Hold the dialogue of that number, and look at everything it left."""
    drawn = stream(seed, index)
    model = DamagingModel(drawn.dialogue.calls, drawn.damage, drawn.manner, drawn.at_once)
    budgets = Budgets(tokens=TOKENS) if _mendable(drawn) else Budgets()
    made = author_tree(drawn.dialogue.brief, ScriptedModel(model), budgets)
    violations = [*faults_of(made, drawn.dialogue.brief, budgets, model.seen), *_own_faults(drawn, made)]
    asked = asked_of(made.transcript)
    counts = {made.status: 1, "calls": len(asked), "calls refused": sum(not call.ok for call in asked)}
    return Verdict(drawn.kind, counts, tuple(violations))


def _own_faults(drawn: Stream, made: Authored) -> Iterator[Violation]:
    """What only who made the damage can know: what was past help, and what the dialogue would have come to."""
    hopeless = {(damage.name, damage.arguments) for damage in drawn.damage.values() if damage.hopeless}
    for call in asked_of(made.transcript):
        if call.ok and (call.name, call.arguments) in hopeless:
            yield ACCEPTED, f"{drawn.kind}: {call.name} {call.arguments[:300]!r}"
    mendable = (
        drawn.manner == "again" and not drawn.at_once and all(damage.hopeless for damage in drawn.damage.values())
    )
    whole = sound(drawn.dialogue.name)
    if mendable and (made.tree, made.status) != (whole.tree, whole.status):
        yield UNFINISHED, f"{drawn.kind} in {drawn.dialogue.name}: {made.status} {made.reasons}"


def _mendable(drawn: Stream) -> bool:
    """Whether the dialogue must end as if nothing had been damaged: all damage is refused, and every call is sent again in its place."""
    return drawn.manner == "again" and not drawn.at_once and all(damage.hopeless for damage in drawn.damage.values())


def facts(seed: int, done: int) -> Mapping[str, object]:
    """How far the cuts have come."""
    every = len(cuts(seed))
    return {"kinds of damage": 1 + len(DAMAGES), "cuts made": f"{min((done + 1) // 2, every)} of {every}"}


CAMPAIGN = Campaign("malformed streams", __doc__, COUNT, judge, (*NEVER, ACCEPTED, UNFINISHED), "streams", facts)

if __name__ == "__main__":
    run(CAMPAIGN)
