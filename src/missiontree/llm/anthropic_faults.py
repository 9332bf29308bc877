"""What Anthropic's SDK raises, as faults of ours."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Any

from missiontree.llm.chat import FaultKind, ProviderError
from missiontree.llm.http_faults import kind_of_connection, kind_of_status, retry_after_s, unexpected
from missiontree.llm.wording import Wording

# In a stream the status was 200 long ago, and only the type tells.
_TYPES: Mapping[str, FaultKind] = {
    "authentication_error": "unauthorised",
    "billing_error": "unauthorised",
    "permission_error": "unauthorised",
    "not_found_error": "no_such_model",
    "rate_limit_error": "rate_limited",
    "overloaded_error": "overloaded",
    "api_error": "overloaded",
    "timeout_error": "timed_out",
    "request_too_large": "context_overflow",
    "invalid_request_error": "bad_request",
}
_TOO_LONG = re.compile(
    r"prompt is too long|exceeds? (the )?(context|maximum) (limit|window|length)|too many tokens", re.I
)


def explained(error: Exception, wording: Wording) -> ProviderError:
    """The fault, in our words."""
    if kind := kind_of_connection(error):
        return wording.fault(kind)
    status = getattr(error, "status_code", None)
    if not isinstance(status, int):
        return wording.fault("failed", unexpected(error))
    told = _told(getattr(error, "body", None))
    said = told.get("message")
    kind = _TYPES.get(str(told.get("type"))) or kind_of_status(status)
    if kind == "bad_request" and isinstance(said, str) and _TOO_LONG.search(said):
        kind = "context_overflow"
    response = getattr(error, "response", None)
    wait = retry_after_s(getattr(response, "headers", {}))
    return wording.fault(kind, said, None if status == 200 else status, wait)


def _told(body: object) -> Mapping[str, Any]:
    """What the body says of the error; empty if it is not of the API's form."""
    told = body.get("error") if isinstance(body, dict) else None
    return told if isinstance(told, dict) else {}
