"""
What is still asked of an endpoint. Endpoints lie about what they support, so everything is asked for at first, and what an endpoint
objects to is left out from then on.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass, fields, replace


@dataclass(frozen=True, slots=True, kw_only=True)
class Features:
    """
    Features of an OpenAI-compatible endpoint that are in use. The fields stand in the order in which they are given up when an endpoint
    objects without saying to what: the least loss first.

    Parameters
    ----------
    usage_in_stream
        Token counts at the end of a stream (``stream_options``).
    parallel_calls
        ``parallel_tool_calls``, said expressly.
    thoughts
        What a model thought is handed back to it with the message it led to.
    completion_tokens
        The limit of an answer is called ``max_completion_tokens``; without it, ``max_tokens``.
    temperature
        ``temperature``, if one was asked for.
    strict
        Arguments held to their schema by the endpoint (``strict``).
    named
        The one function that there is can be demanded by name (``tool_choice``).
    required
        Some call can be demanded (``tool_choice: required``).
    choice
        ``tool_choice: auto``, said expressly.
    rich_schema
        Schemas with all they say; without it, with what every endpoint understands.
    stream
        Answers come piece by piece.
    """

    usage_in_stream: bool = True
    parallel_calls: bool = True
    thoughts: bool = True
    completion_tokens: bool = True
    temperature: bool = True
    strict: bool = True
    named: bool = True
    required: bool = True
    choice: bool = True
    rich_schema: bool = True
    stream: bool = True

    @property
    def missing(self) -> tuple[str, ...]:
        """Names of the features that are no longer used."""
        return tuple(name for name in FEATURES if not getattr(self, name))

    def without(self, names: Iterable[str]) -> Features:
        """These, those of the names not used; names that are no feature's are passed over."""
        return replace(self, **{name: False for name in names if name in FEATURES})


FEATURES = tuple(field.name for field in fields(Features))

_SCHEMA = re.compile(r"\bstrict\b|additional_?properties|schema|grammar|any_?of|function\.parameters", re.I)
_NAMED_BY = (
    ("usage_in_stream", re.compile(r"stream_options|include_usage", re.I)),
    ("parallel_calls", re.compile(r"parallel", re.I)),
    ("completion_tokens", re.compile(r"max_completion_tokens|max_tokens", re.I)),
    ("temperature", re.compile(r"temperature", re.I)),
    ("thoughts", re.compile(r"reasoning|extra_content|thought", re.I)),
    ("named", re.compile(r"tool[_ ]?choice", re.I)),
    ("required", re.compile(r"tool[_ ]?choice|['\"`]required['\"`]", re.I)),
    ("choice", re.compile(r"tool[_ ]?choice", re.I)),
    ("strict", _SCHEMA),
    ("rich_schema", _SCHEMA),
    ("stream", re.compile(r"\bstream", re.I)),
)
_ABOUT_SOMETHING_ELSE = re.compile(
    r"\bmessages?\[|not support (\w+ )?(tools|functions?|function calling|tool use)\b", re.I
)


def to_blame(words: str, used: Iterable[str], *, if_unsaid: bool) -> str | None:
    """
    The feature that an endpoint's objection is about.

    Parameters
    ----------
    words
        What the endpoint says.
    used
        Features that the request made use of.
    if_unsaid
        Whether to suspect the one that is least missed if the words name none.

    Returns
    -------
    str | None
        Its name; None if the objection is about something else.
    """
    in_use = set(used)
    for name, pattern in _NAMED_BY:
        if name in in_use and pattern.search(words):
            return name
    if not if_unsaid or _ABOUT_SOMETHING_ELSE.search(words):
        return None
    return next((name for name in FEATURES if name in in_use), None)
