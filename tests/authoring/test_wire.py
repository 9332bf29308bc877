import json

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from missiontree.authoring.answer import RefusalError
from missiontree.authoring.tools import TOOLS, ToolBox
from missiontree.authoring.wire import parse_arguments

VALID = json.dumps(
    {
        "parentString": "Bring",
        "treeNames": ["ReachAndTransportTree", "SearchTree"],
        "treeArguments": [["Child", "Mom"], {"agent": "Mom", "resources": ["tele_robot"]}],
        "LogicalConstraint": "AND",
        "constraintPairs": [["SearchTree(mom)", 0, "Precedence"]],
    }
)


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        ('{"taskName": Locate the Lost Child}', "Expecting value at character 14"),
        ("{'taskName': 'x'}", "double quotes"),
        ('{"a": 1, "a": 2}', "'a' stands twice"),
        ('{"a": {"b": 1, "b": 1}}', "'b' stands twice"),
        ('{"a": NaN}', "NaN is not a number of JSON"),
        ('{"a": [-Infinity]}', "-Infinity is not a number of JSON"),
        ('{"a": 1e999}', "too large a number"),
        ('{"a": "\\ud800"}', "half a character"),
        ('{"\\udfff": 1}', "half a character"),
        ("[]", "a list, not an object"),
        ("null", "null, not an object"),
        ('"text"', "a text, not an object"),
        ("7", "a number, not an object"),
        ("true", "true or false, not an object"),
        ("{} {}", "Extra data"),
        ('{"a": ' + "9" * 5000 + "}", "not JSON"),
        ("[" * 100_000, "more than 32 levels deep"),
        ('{"a":' * 100_000, "more than 32 levels deep"),
        ("{" + " " * 1_000_000, "at most 1000000 are read"),
    ],
)
def test_what_is_not_one_plain_object_is_refused(arguments: str, said: str) -> None:
    with pytest.raises(RefusalError) as refused:
        parse_arguments(arguments)
    (reason,) = refused.value.reasons
    assert reason.rule == "malformed_arguments"
    assert said in f"{reason.message} {reason.hint}"
    assert reason.hint


def test_brackets_within_texts_are_no_nesting() -> None:
    text = '\\"[{' * 100
    assert parse_arguments('{"a": "' + text + '"}') == {"a": '"[{' * 100}


def test_no_arguments_may_be_written_as_nothing() -> None:
    assert parse_arguments("") == {}


def test_a_mapping_is_taken_as_if_it_came_over_the_wire() -> None:
    assert parse_arguments({"a": ("b", 1)}) == {"a": ["b", 1]}


@pytest.mark.parametrize("given", [{"a": float("nan")}, {"a": object()}, {"a": {1, 2}}])
def test_a_mapping_that_is_not_json_is_refused(given: dict[str, object]) -> None:
    with pytest.raises(RefusalError, match="cannot be written as JSON"):
        parse_arguments(given)


def test_a_mapping_that_contains_itself_is_refused() -> None:
    given: dict[str, object] = {}
    given["a"] = given
    with pytest.raises(RefusalError, match="cannot be written as JSON"):
        parse_arguments(given)


def test_a_valid_call_cut_off_anywhere_is_refused_and_changes_nothing(box: ToolBox) -> None:
    before = box.builder.state
    for end in range(1, len(VALID)):
        answer = box.call("attachMultiSubTrees", VALID[:end])
        assert not answer.ok
        assert answer.reasons
        assert answer.reasons[0].rule == "malformed_arguments"
        assert box.builder.state is before
    assert box.call("attachMultiSubTrees", VALID).ok, "the whole call is sound, so the cuts were what was wrong"


@settings(max_examples=200)
@given(st.integers(min_value=0, max_value=len(VALID) - 1), st.characters())
def test_a_valid_call_with_one_letter_changed_never_raises(box_of: ToolBox, place: int, letter: str) -> None:
    answer = box_of.call("attachMultiSubTrees", VALID[:place] + letter + VALID[place + 1 :])
    assert answer.ok or answer.reasons
    json.loads(answer.text)


@settings(max_examples=200)
@given(st.sampled_from([tool.name for tool in TOOLS]), st.text(max_size=60))
def test_any_text_is_answered(box_of: ToolBox, name: str, arguments: str) -> None:
    """No argument-taking function applies text that is not JSON, and none raises."""
    before = box_of.builder.state
    answer = box_of.call(name, arguments)
    assert answer.ok or box_of.builder.state is before


@pytest.fixture(scope="module")
def box_of(brief: object) -> ToolBox:
    """One set of functions for many examples; what holds must hold in whatever state they leave it."""
    from missiontree.mission.brief import MissionBrief
    from tests.authoring.conftest import begun

    assert isinstance(brief, MissionBrief)
    return begun(brief)
