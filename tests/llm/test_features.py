"""Which feature an objection is about, in the words of the servers that are in use."""

from __future__ import annotations

import pytest

from missiontree.llm.features import FEATURES, Features, to_blame

USED = frozenset(FEATURES)


@pytest.mark.parametrize(
    ("words", "feature"),
    [
        ("Unknown parameter: 'stream_options'.", "usage_in_stream"),
        ("body stream_options Extra inputs are not permitted", "usage_in_stream"),
        ("extra_forbidden body parallel_tool_calls Extra inputs are not permitted", "parallel_calls"),
        ("Unsupported parameter: 'max_completion_tokens'. Use 'max_tokens' instead.", "completion_tokens"),
        ("Unsupported value: 'temperature' does not support 0 with this model.", "temperature"),
        ("Unknown parameter: 'messages[2].reasoning_content'", "thoughts"),
        ("Invalid value: 'tool_choice'", "named"),
        ("tool_choice must be one of auto, none", "named"),
        ("additionalProperties is not supported", "strict"),
        ("Invalid schema for function 'ping'", "strict"),
        ("JSON schema conversion failed: Unrecognized schema", "strict"),
        ("streaming is not supported with tools", "stream"),
    ],
)
def test_an_objection_names_its_feature(words: str, feature: str) -> None:
    assert to_blame(words, USED, if_unsaid=False) == feature


def test_what_is_named_and_not_used_any_more_is_not_blamed() -> None:
    """A demand is given up in steps, from the one function to any, and then to none; a schema from strict to simple."""
    words, used, given_up = "tool_choice is not supported", set(USED), []
    while (blamed := to_blame(words, used, if_unsaid=False)) is not None:
        given_up.append(blamed)
        used.remove(blamed)
    assert given_up == ["named", "required", "choice"]
    assert to_blame("invalid schema", USED - {"strict"}, if_unsaid=False) == "rich_schema"


def test_an_objection_without_a_name_is_laid_to_what_is_least_missed() -> None:
    assert to_blame("Bad request.", USED, if_unsaid=True) == "usage_in_stream"
    assert to_blame("Bad request.", {"stream", "strict"}, if_unsaid=True) == "strict"
    assert to_blame("Bad request.", USED, if_unsaid=False) is None
    assert to_blame("Bad request.", (), if_unsaid=True) is None


@pytest.mark.parametrize(
    "words",
    [
        "registry.ollama.ai/library/gemma:2b does not support tools",
        "This model does not support function calling.",
        "Invalid 'messages[3].tool_calls[0].id'",
    ],
)
def test_an_objection_to_something_else_is_laid_to_no_feature(words: str) -> None:
    assert to_blame(words, USED, if_unsaid=True) is None


def test_features_that_are_left_out_are_known_by_name() -> None:
    fewer = Features().without(["strict", "stream", "no such feature"])
    assert fewer.missing == ("strict", "stream")
    assert Features().missing == ()
