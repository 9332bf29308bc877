import pytest

from missiontree.errors import InputError
from missiontree.llm.chat import Message, ProviderError, ToolCall
from missiontree.llm.recorded import RecordedModel
from missiontree.llm.recording import answer_line, header_line, line_of, message_line, read_recording

TURNS = (Message("assistant", "first", (ToolCall("1", "a", "{\ud800"),)), Message("assistant", "second"))
END = line_of({"kind": "end", "status": "complete", "reasons": [], "reading": [], "remarks": [], "spent": {}})
LINES = [
    header_line("somebody", "large-1", "", "0" * 64),
    message_line(Message("user", "hello")),
    message_line(TURNS[0]),
    answer_line("1", True, "done"),
    message_line(TURNS[1]),
    END,
]


def test_the_assistants_messages_come_again_in_order_whatever_is_said() -> None:
    model = RecordedModel(LINES)
    assert [model((), ()), model([Message("user", "something else")], ())] == list(TURNS)


def test_past_the_end_there_is_nothing_to_say() -> None:
    model = RecordedModel([LINES[0], END])
    with pytest.raises(ProviderError, match="recording ends"):
        model((), ())


def test_a_recording_says_whose_words_they_are() -> None:
    recording = read_recording(LINES)
    assert (recording.source, recording.model, recording.mission) == ("somebody", "large-1", "0" * 64)
    # Line 1 is the header, so the first message stands on line 2.
    assert [number for number, _ in recording.entries] == [2, 3, 4, 5]


@pytest.mark.parametrize("lines", [[], [""], ["7"], ["{}"], LINES[:1], [LINES[0], "[" * 100_000, END]])
def test_what_is_no_recording_is_refused(lines: list[str]) -> None:
    with pytest.raises(InputError):
        RecordedModel(lines)
