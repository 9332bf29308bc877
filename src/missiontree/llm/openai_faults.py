"""What an endpoint says is wrong, as faults of ours."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass

from missiontree.llm.chat import FaultKind, ProviderError
from missiontree.llm.http_faults import retry_after_s
from missiontree.llm.openai_error import error_in, message_of, names_of, status_in, texts_of
from missiontree.llm.openai_words import Words, without_secrets

_TOO_LONG = re.compile(
    r"context[_ ](length|window|size|overflow)|exceed_context|maximum context|prompt is too long|input is too long|too many tokens"
    r"|input token count.*exceeds|reduce the length of",
    re.I,
)
_UNPAID = re.compile(r"insufficient[_ ](quota|balance|credits)|billing_(hard_limit|not_active)", re.I)
_ABOUT_A_FEATURE = re.compile(
    r"stream_options|parallel_tool_calls|tool_choice|grammar|json.?schema|tools with stream", re.I
)
"""Some servers die of what they do not know, with a status of 500."""
_FILTERS = frozenset({"content_filter", "content_policy_violation"})
_PLAIN_KINDS: dict[int, FaultKind] = {
    401: "unauthorised",
    403: "unauthorised",
    404: "no_such_model",
    408: "timed_out",
    409: "overloaded",
    425: "overloaded",
    429: "rate_limited",
}
_SAYS: dict[FaultKind, str] = {
    "unauthorised": "does not let us in",
    "no_such_model": "has no such model, or nothing at that address",
    "timed_out": "took too long by its own measure",
    "rate_limited": "is asked too often",
    "overloaded": "is overloaded or out of order",
    "context_overflow": "cannot take a dialogue of this length",
    "bad_request": "does not take the request",
    "failed": "cannot be used",
}


class RejectedError(ProviderError):
    """
    A request that the endpoint objects to: perhaps to a feature that it does not have.

    Parameters
    ----------
    fault
        The fault, if nothing can be left out.
    status
        Status of the answer.
    words
        All that the endpoint says about it.
    """

    def __init__(self, fault: ProviderError, status: int, words: str) -> None:
        super().__init__(str(fault), fault.kind, fault.hint, fault.retry_after_s)
        self.status, self.words = status, words


class FilteredError(ProviderError):
    """A content filter stopped the request or the answer."""


@dataclass(frozen=True, slots=True)
class Place:
    """
    Where a fault was met.

    Parameters
    ----------
    url
        Address of the endpoint, without anything secret.
    host
        Host and port of it.
    model
        Model that was asked.
    words
        Makes its words fit to be shown.
    """

    url: str
    host: str
    model: str
    words: Words

    def fault_of_status(self, status: int, headers: Mapping[str, str], body: str) -> ProviderError:
        """The fault that an answer with an error status stands for."""
        if 300 <= status < 400:
            return self._redirected(headers.get("location", ""))
        return self._fault(status, error_in(body), retry_after_s(headers), f" ({status})")

    def fault_of_error(self, error: object) -> ProviderError:
        """The fault that an error object in an answer of good status stands for."""
        return self._fault(status_in(error), error)

    def _fault(self, status: int, error: object, wait_s: float | None = None, shown: str = "") -> ProviderError:
        told = texts_of(error)
        if _FILTERS & set(names_of(error)):
            return FilteredError("The endpoint's content filter stopped it.", "bad_request")
        kind, hint = self._kind(status, told)
        said = self.words.clean(message_of(error) or told)
        message = f"{self.host} {_SAYS[kind]}{shown}" + (f": {said}" if said else ".")
        fault = ProviderError(message, kind, hint, wait_s)
        if kind in {"bad_request", "no_such_model"} or (status == 500 and _ABOUT_A_FEATURE.search(told)):
            return RejectedError(fault, status, told)
        return fault

    def _kind(self, status: int, told: str) -> tuple[FaultKind, str]:
        if status == 413 or (status not in {401, 403, 404, 429} and _TOO_LONG.search(told)):
            return (
                "context_overflow",
                "Use a model with a longer context, or a smaller fleet, scene or set of routines.",
            )
        if status == 402 or (status in {403, 429} and _UNPAID.search(told)):
            return "failed", f"Look at the plan and the bill of the account at {self.host}."
        kind = _PLAIN_KINDS.get(status, "overloaded" if status >= 500 and status != 501 else "bad_request")
        return kind, self._hint(kind)

    def _hint(self, kind: FaultKind) -> str:
        if kind == "unauthorised":
            return f"Set OPENAI_API_KEY to a key that {self.host} takes, and that may use the model {self.model}."
        if kind == "no_such_model":
            return (
                f"Is {self.words.clean(self.model, 100)!r} the model's name there, and {self.url} the base URL? It commonly ends in /v1. "
                "A local server has to have the model pulled or loaded first."
            )
        if kind == "bad_request":
            return (
                "If it is about functions or tools, use a model that can call them, and a server that is set up for it."
            )
        return "Wait a while and try again."

    def _redirected(self, location: str) -> ProviderError:
        target = self.words.clean(without_secrets(location), 200) or "nowhere"
        message = f"{self.host} sends the request on to {target}. It was not followed, since the key would go along."
        return ProviderError(message, "failed", "If you trust that address, make it the base URL.")
