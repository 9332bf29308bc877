from missiontree.llm.chat import Message
from missiontree.llm.scripted import ScriptedModel


def test_a_list_is_obeyed_turn_by_turn_and_then_there_is_silence() -> None:
    model = ScriptedModel([[("a", "{not json"), ("b", {"x": "ü"})], [("c", "")]])
    turns = [model((), ()) for _ in range(3)]
    assert [[(call.name, call.arguments) for call in turn.calls] for turn in turns] == [
        [("a", "{not json"), ("b", '{"x": "ü"}')],
        [("c", "")],
        [],
    ]
    assert {turn.speaker for turn in turns} == {"assistant"}


def test_calls_have_names_of_their_own() -> None:
    model = ScriptedModel([[("a", ""), ("a", "")], [("a", "")]])
    ids = [call.id for _ in range(2) for call in model((), ()).calls]
    assert len(set(ids)) == 3


def test_a_function_sees_the_dialogue() -> None:
    model = ScriptedModel(lambda messages, tools: [(messages[-1].text, "{}")])
    assert model([Message("user", "hello")], ()).calls[0].name == "hello"
