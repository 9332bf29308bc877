"""What goes wrong between here and a provider: statuses, connections that fail, answers that break off or are none."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping
from email.utils import parsedate_to_datetime
from json import JSONDecodeError
from typing import TypeVar

from missiontree.llm.chat import FaultKind, ProviderError

T = TypeVar("T")
Explain = Callable[[Exception], ProviderError]
"""Makes a fault of what an SDK raised."""


class MalformedError(ValueError):
    """An answer that has not the form of the API. Its text is ours and can be shown."""


class BrokenOffError(Exception):
    """An answer that ended before its end: the end of a call may be missing, and nobody would see it."""


_STATUSES: Mapping[int, FaultKind] = {
    401: "unauthorised",
    402: "unauthorised",
    403: "unauthorised",
    404: "no_such_model",
    408: "timed_out",
    413: "context_overflow",
    429: "rate_limited",
    501: "failed",
    504: "timed_out",
}
# By name, for SDKs may bring HTTP libraries that differ in nothing but the module; the first that is met along the causes decides.
_EXCEPTIONS: Mapping[str, FaultKind] = {
    "ConnectError": "unreachable",
    "ConnectTimeout": "unreachable",
    "ProxyError": "unreachable",
    "UnsupportedProtocol": "unreachable",
    "InvalidURL": "unreachable",
    "TimeoutException": "timed_out",
    "ReadError": "cut_off",
    "WriteError": "cut_off",
    "CloseError": "cut_off",
    "RemoteProtocolError": "cut_off",
}


def kind_of_status(status: int) -> FaultKind:
    """What sort of fault an HTTP status means."""
    if status in _STATUSES:
        return _STATUSES[status]
    if 400 <= status < 500:
        return "bad_request"
    return "overloaded" if 500 <= status < 600 else "failed"


def kind_of_connection(error: BaseException) -> FaultKind | None:
    """What sort of fault a connection that failed is; None if it was none that failed."""
    if isinstance(error, BrokenOffError):
        return "cut_off"
    cause: BaseException | None = error
    seen: set[int] = set()
    while cause is not None and id(cause) not in seen:
        seen.add(id(cause))
        for ancestor in type(cause).__mro__:
            if kind := _EXCEPTIONS.get(ancestor.__name__):
                return kind
        cause = cause.__cause__
    return None


def retry_after_s(headers: Mapping[str, str]) -> float | None:
    """
    Seconds that ``Retry-After`` asks for, or None.

    A date in it is read against the ``Date`` of the same answer: the provider's clock, and none of ours.
    """
    given = {name.lower(): value for name, value in headers.items()}
    if (milliseconds := seconds_of(given.get("retry-after-ms", ""))) is not None:
        return milliseconds / 1000
    if (seconds := seconds_of(given.get("retry-after", ""))) is not None:
        return seconds
    try:
        later = parsedate_to_datetime(given["retry-after"]) - parsedate_to_datetime(given["date"])
    except (KeyError, ValueError, TypeError):
        return None
    return max(0.0, later.total_seconds())


def seconds_of(text: str) -> float | None:
    """The text as a number of seconds that can be waited; None if it is none."""
    try:
        seconds = float(text)
    except ValueError:
        return None
    return seconds if math.isfinite(seconds) and seconds >= 0 else None


def guarded(ask: Callable[[], T], explain: Explain) -> T:
    """
    What an SDK gives, or the fault made of what it raised.

    The fault is raised outside of the ``except``, so that it does not carry the SDK's exception, which holds the request with its key.
    """
    try:
        return ask()
    except ProviderError:
        raise
    except Exception as error:
        fault = explain(error)
    raise fault


def each_guarded(stream: Iterator[T], explain: Explain) -> Iterator[T]:
    """The pieces of an SDK's stream. Only its own faults are explained; whoever takes the pieces may raise what they will."""
    end = object()
    while (piece := guarded(lambda: next(stream, end), explain)) is not end:
        yield piece  # type: ignore[misc]  # only `end` is no piece


def unexpected(error: Exception) -> str:
    """What can be said of an exception that nobody foresaw: what it is, and not its text, which may hold anything."""
    if isinstance(error, MalformedError):
        return str(error)
    return "It is not JSON." if isinstance(error, JSONDecodeError) else type(error).__name__
