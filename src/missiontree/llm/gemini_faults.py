"""What Gemini's SDK raises, as faults of ours."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from json import JSONDecodeError
from typing import Any

from missiontree.llm.chat import FaultKind, ProviderError
from missiontree.llm.gemini_answer import EmptyError, UnsignedError
from missiontree.llm.http_faults import kind_of_connection, kind_of_status, retry_after_s, seconds_of, unexpected
from missiontree.llm.wording import Wording

UNSIGNED_WORDS = "thought_signature"
"""What every complaint about a missing signature says."""

_STATUSES: Mapping[str, FaultKind] = {
    "UNAUTHENTICATED": "unauthorised",
    "PERMISSION_DENIED": "unauthorised",
    "NOT_FOUND": "no_such_model",
    "RESOURCE_EXHAUSTED": "rate_limited",
    "UNAVAILABLE": "overloaded",
    "INTERNAL": "overloaded",
    "DEADLINE_EXCEEDED": "timed_out",
    "INVALID_ARGUMENT": "bad_request",
    "FAILED_PRECONDITION": "bad_request",
}
_TOO_LONG = re.compile(
    r"token count.*exceeds the maximum|exceeds? the (context|maximum) (window|length|number of tokens)", re.I
)
_NO_KEY = re.compile(r"API key (not valid|expired|not found)", re.I)


def explained(error: Exception, wording: Wording) -> ProviderError:
    """The fault, in our words."""
    if isinstance(error, EmptyError):
        return wording.fault("empty", str(error))
    if isinstance(error, UnsignedError):
        return wording.fault("bad_request", f"a call lacks its {UNSIGNED_WORDS}")
    if kind := kind_of_connection(error):
        return wording.fault(kind)
    told = _told(getattr(error, "details", None))
    code = getattr(error, "code", None)
    if isinstance(code, int) or told:
        return _answered(told, code if isinstance(code, int) else None, error, wording)
    return wording.fault("cut_off") if _half_said(error) else wording.fault("failed", unexpected(error))


def _answered(told: Mapping[str, Any], code: int | None, error: Exception, wording: Wording) -> ProviderError:
    said = told.get("message") if str(told.get("status")) in _STATUSES or "details" in told else None
    words = said if isinstance(said, str) else ""
    kind = kind_of_status(code) if code is not None else _STATUSES.get(str(told.get("status")), "failed")
    reasons = {str(detail.get("reason")) for detail in _details(told)}
    if kind == "bad_request" and ("API_KEY_INVALID" in reasons or _NO_KEY.search(words)):
        kind = "unauthorised"
    elif kind == "bad_request" and _TOO_LONG.search(words):
        kind = "context_overflow"
    delays = [seconds_of(str(detail.get("retryDelay", "")).removesuffix("s")) for detail in _details(told)]
    headers = getattr(getattr(error, "response", None), "headers", {})
    wait = next((delay for delay in delays if delay is not None), retry_after_s(headers))
    return wording.fault(kind, words, code, wait)


def _told(body: object) -> Mapping[str, Any]:
    """What the body says of the error; empty if it is not of the API's form."""
    told = body.get("error", body) if isinstance(body, dict) else None
    return told if isinstance(told, dict) else {}


def _details(told: Mapping[str, Any]) -> Iterator[Mapping[str, Any]]:
    details = told.get("details")
    return (detail for detail in details if isinstance(detail, dict)) if isinstance(details, list) else iter(())


def _half_said(error: Exception) -> bool:
    """Whether what could not be read is an object that lacks its end: a stream that was closed in the middle of a chunk."""
    cause = error.__cause__ or error
    return isinstance(cause, JSONDecodeError) and cause.doc.lstrip().startswith("{")
