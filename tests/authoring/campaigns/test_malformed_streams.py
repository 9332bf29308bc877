"""A sample of the campaign of malformed streams, and whether its judges would see a fault at all."""

from __future__ import annotations

import json
from collections import Counter
from dataclasses import replace

import pytest

from benchmarks.campaign import luck, made
from benchmarks.campaign_damage import DAMAGES, KINDS, cut_short, damaged, written
from benchmarks.campaign_dialogues import dialogues
from benchmarks.campaign_history import INVALID, REPLAYS, TRACES, UNBOUNDED, UNNAMED, faults_of, history_faults
from benchmarks.malformed_streams import ACCEPTED, CAMPAIGN, cuts, judge, sound, stream
from missiontree.authoring.budgets import Budgets
from missiontree.authoring.tools import TOOLS
from missiontree.llm.chat import Message, ToolCall

SAMPLE = 300


def test_a_sample_shows_nothing_that_must_never_be() -> None:
    state = made(CAMPAIGN, 1, 0, SAMPLE)
    assert state.violations == {}
    assert set(state.rows) == set(KINDS)
    total = sum((Counter(row) for row in state.rows.values()), Counter())
    assert total["streams"] == SAMPLE
    # Every end but that of a provider, which is not at fault here, is met.
    assert all(total[end] for end in ("complete", "cannot_be_done", "incomplete", "exhausted"))


def test_the_sound_dialogues_end_well_and_call_every_function() -> None:
    ends = {dialogue.name: sound(dialogue.name).status for dialogue in dialogues()}
    assert (ends.pop("restaurants"), ends.pop("not clear")) == ("cannot_be_done", "incomplete")
    assert set(ends.values()) == {"complete"}
    assert {name for dialogue in dialogues() for name, _ in dialogue.calls} == {tool.name for tool in TOOLS}


def test_the_full_campaign_cuts_every_call_after_every_byte() -> None:
    """Twice each: for a model that sends the call again, and for one that goes on; every other run is a cut until all are made."""
    every = {
        (which, number, length)
        for which, dialogue in enumerate(dialogues())
        for number, (_, arguments) in enumerate(dialogue.calls)
        for length in range(len(json.dumps(arguments, ensure_ascii=False).encode()))
    }
    assert Counter(cut[:3] for cut in cuts(1)) == dict.fromkeys(every, 2)
    assert 2 * len(cuts(1)) <= CAMPAIGN.count
    made_first = [stream(1, 2 * number).kind for number in range(len(cuts(1)))]
    assert set(made_first) == {"cut short"}


def test_a_cut_within_a_letter_leaves_half_of_it() -> None:
    # {"objective": "é… : the quote stands at byte 14, "é" is bytes 15 and 16.
    call = ("HierarchicalTree_init", {"objective": "é"})
    assert cut_short(call, 16).arguments == '{"objective": "\udcc3'
    assert cut_short(call, 17).arguments == '{"objective": "é'


@pytest.mark.parametrize(
    "kind",
    ["quotes flipped", "single quotes", "trailing commas", "comments", "keys unquoted", "wrong bracket", "two objects",
     "fences and prose", "byte-order mark", "no object"],
)  # fmt: skip
def test_damage_of_the_text_leaves_no_object(kind: str) -> None:
    """So whoever takes such a call has repaired it, which the design forbids."""
    calls = [call for dialogue in dialogues() for call in dialogue.calls if call[1]]
    for number, call in enumerate(calls * 3):
        bent = damaged(luck(5, number), kind, call)
        assert bent.hopeless
        try:
            left = json.loads(bent.arguments)
        except ValueError:
            continue
        assert not isinstance(left, dict), bent.arguments


def test_a_reader_that_repairs_is_seen(monkeypatch: pytest.MonkeyPatch) -> None:
    """With the check of keys given twice taken out, the campaign says so."""
    monkeypatch.setattr("missiontree.authoring.wire._once", dict)
    twice = [number for number in range(1, 1_500, 2) if stream(1, number).kind == "keys twice"]
    found = {kind for number in twice for kind, _ in judge(1, number).violations}
    assert ACCEPTED in found
    assert len(DAMAGES) == 24


def test_a_dialogue_that_is_not_what_it_says_is_seen() -> None:
    dialogue, whole = dialogues()[0], sound(dialogues()[0].name)
    assert whole.tree is not None
    assert list(faults_of(whole, dialogue.brief, Budgets(), ())) == []

    def kinds(**changes: object) -> set[str]:
        bent = replace(whole, **changes)  # type: ignore[arg-type]
        return {kind for kind, _ in faults_of(bent, dialogue.brief, Budgets(turns=20, calls=20), ())}

    lone = replace(whole.tree, nodes=(replace(whole.tree.root, children=(), gate=None),), links=())
    assert {INVALID, REPLAYS, TRACES} <= kinds(tree=lone)
    assert UNNAMED in kinds(status="incomplete")
    assert REPLAYS in kinds(transcript=tuple(line.replace('"Child', '"Mom') for line in whole.transcript[:-1]))
    short = list(faults_of(whole, dialogue.brief, Budgets(turns=2, calls=3), ()))
    assert {kind for kind, _ in short} == {UNBOUNDED}


def test_a_history_that_a_provider_would_reject_is_seen() -> None:
    call = ToolCall("a", "printTree", "{}")
    asked = Message("assistant", calls=(call,))
    answer = Message("tool", "{}", call_id="a")
    assert list(history_faults([asked, answer, Message("user", "Go on.")])) == []
    for wrong in (
        [asked],
        [answer],
        [asked, answer, answer],
        [asked, answer, asked, answer],
        [asked, Message("user", "?")],
    ):
        assert list(history_faults(wrong)), wrong


def test_what_is_written_is_what_a_sound_model_writes() -> None:
    assert json.loads(written({"a": ["é", 1]})) == {"a": ["é", 1]}
