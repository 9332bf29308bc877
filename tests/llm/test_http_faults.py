"""Statuses, headers and exceptions, read without a provider."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from missiontree.llm.chat import FaultKind, ProviderError
from missiontree.llm.http_faults import (
    BrokenOffError,
    each_guarded,
    guarded,
    kind_of_connection,
    kind_of_status,
    retry_after_s,
)


@pytest.mark.parametrize(
    ("status", "kind"),
    [
        (302, "failed"),
        (400, "bad_request"),
        (401, "unauthorised"),
        (403, "unauthorised"),
        (404, "no_such_model"),
        (408, "timed_out"),
        (409, "bad_request"),
        (413, "context_overflow"),
        (422, "bad_request"),
        (429, "rate_limited"),
        (500, "overloaded"),
        (501, "failed"),
        (502, "overloaded"),
        (503, "overloaded"),
        (504, "timed_out"),
        (529, "overloaded"),
        (600, "failed"),
    ],
)
def test_every_status_has_its_kind(status: int, kind: FaultKind) -> None:
    assert kind_of_status(status) == kind


def test_the_date_to_wait_for_is_read_against_the_providers_clock() -> None:
    """From 10:00:00 to 10:01:30 are 90 s, whatever our clock says."""
    headers = {"Retry-After": "Mon, 05 Jan 2026 10:01:30 GMT", "Date": "Mon, 05 Jan 2026 10:00:00 GMT"}
    assert retry_after_s(headers) == 90
    assert retry_after_s({"Retry-After": headers["Retry-After"]}) is None
    assert retry_after_s({"Retry-After": headers["Date"], "Date": headers["Retry-After"]}) == 0


@pytest.mark.parametrize("headers", [{}, {"retry-after": "soon", "date": "now"}, {"retry-after": "inf"}])
def test_headers_that_say_nothing_say_nothing(headers: dict[str, str]) -> None:
    assert retry_after_s(headers) is None


def named(name: str, base: type[Exception] = Exception) -> type[Exception]:
    """An exception of that name; whose library it comes from does not matter."""
    return type(name, (base,), {})


TIMEOUT = named("TimeoutException")


def caused(error: Exception, cause: Exception) -> Exception:
    error.__cause__ = cause
    return error


@pytest.mark.parametrize(
    ("error", "kind"),
    [
        (named("ReadTimeout", TIMEOUT)(), "timed_out"),
        (named("PoolTimeout", TIMEOUT)(), "timed_out"),
        (named("ConnectTimeout", TIMEOUT)(), "unreachable"),
        (named("ConnectError")(), "unreachable"),
        (named("ProxyError")(), "unreachable"),
        (named("UnsupportedProtocol")(), "unreachable"),
        (named("InvalidURL")(), "unreachable"),
        (named("ReadError")(), "cut_off"),
        (named("WriteError")(), "cut_off"),
        (named("CloseError")(), "cut_off"),
        (named("RemoteProtocolError")(), "cut_off"),
        (BrokenOffError(), "cut_off"),
        (caused(ValueError(), caused(KeyError(), named("ConnectError")())), "unreachable"),
        (ValueError(), None),
    ],
)
def test_connections_that_fail_are_known_by_name(error: Exception, kind: FaultKind | None) -> None:
    assert kind_of_connection(error) == kind


def test_causes_in_a_circle_end() -> None:
    error = ValueError()
    assert kind_of_connection(caused(error, caused(KeyError(), error))) is None


def explain(error: Exception) -> ProviderError:
    return ProviderError("explained", "failed")


def test_a_fault_does_not_carry_the_exception_that_it_was_made_of() -> None:
    """The SDK's exception holds the request, and the request the key."""

    def ask() -> None:
        raise ValueError("key")

    with pytest.raises(ProviderError, match="explained") as fault:
        guarded(ask, explain)
    assert fault.value.__cause__ is None
    assert fault.value.__context__ is None


def test_a_fault_of_ours_needs_no_explanation() -> None:
    def ask() -> None:
        raise ProviderError("mine", "empty")

    with pytest.raises(ProviderError, match="mine"):
        guarded(ask, explain)


def test_pieces_come_until_the_stream_fails() -> None:
    def stream() -> Iterator[int]:
        yield 1
        yield 2
        raise ValueError("broken")

    got: list[int] = []
    with pytest.raises(ProviderError, match="explained"):
        got.extend(each_guarded(stream(), explain))
    assert got == [1, 2]


def test_what_the_taker_of_pieces_raises_is_not_explained() -> None:
    def take() -> None:
        for piece in each_guarded(iter([1]), explain):
            raise KeyError(piece)

    with pytest.raises(KeyError):
        take()
