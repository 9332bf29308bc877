"""
The way to an endpoint and back: the SDK's client, with bounds on what comes back. Loads the SDK, so it is imported when a model is asked
for the first time.
"""

from __future__ import annotations

import ssl
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass
from typing import Any
from urllib.parse import parse_qsl, urlsplit
from urllib.request import getproxies, proxy_bypass

import httpx2
import openai

from missiontree.llm.chat import ProviderError
from missiontree.llm.openai_faults import Place
from missiontree.llm.patience import Patience

LARGEST = 64 * 2**20
"""Bytes of an answer, unpacked. A stream needs some 300 bytes for a token, so this is 200,000 tokens."""
_CONNECT_S = 10.0
_LOST = (openai.OpenAIError, httpx2.RequestError, httpx2.InvalidURL, ssl.SSLError, OSError, ValueError, ImportError)
_LOOPBACK = frozenset({"localhost", "::1"})


@dataclass(frozen=True, slots=True)
class Reply:
    """
    An answer of good status, its body still to be read.

    Parameters
    ----------
    content_type
        The header of that name.
    body
        The body in pieces; reading it may raise ``ProviderError``.
    """

    content_type: str
    body: Iterator[bytes]


class Wire:
    """
    A client for one endpoint.

    Parameters
    ----------
    url
        Base URL.
    key
        Key to send.
    place
        How faults are told.
    patience
        How long a sign of life, and a whole answer, are waited for.
    """

    def __init__(self, url: str, key: str, place: Place, patience: Patience) -> None:
        self._place, self._timeout_s = place, patience.timeout_s
        limit = httpx2.Timeout(patience.timeout_s, connect=min(patience.timeout_s, _CONNECT_S))
        with self._told():
            # No connection is kept: a dialogue pauses for seconds, and servers close what is idle just when the next request is sent.
            limits = httpx2.Limits(max_keepalive_connections=0)
            transport = httpx2.HTTPTransport(verify=_trust(url), proxy=_proxy(url), limits=limits)
            bounded = _Bounded(transport, place.host, patience.total_s, patience.clock)
            http = httpx2.Client(transport=bounded, timeout=limit, follow_redirects=False)
            base, _, query = url.partition("#")[0].partition("?")
            self._client = openai.OpenAI(
                api_key=key,
                base_url=base,
                default_query=dict(parse_qsl(query)),  # the SDK would put the rest of the path behind it
                timeout=limit,
                max_retries=0,
                http_client=http,
            )

    @contextmanager
    def post(self, body: dict[str, Any]) -> Iterator[Reply]:
        """
        Send a request; the body of the answer can be read inside the context.

        Raises
        ------
        ProviderError
            Whatever goes wrong, when the body is read, too.
        """
        sending = self._client.chat.completions.with_streaming_response.create(**body)
        with ExitStack() as stack:
            with self._told():
                response = stack.enter_context(sending)
            yield Reply(response.headers.get("content-type", ""), self._read(response.iter_bytes()))

    def _read(self, pieces: Iterator[bytes]) -> Iterator[bytes]:
        with self._told():
            yield from pieces

    @contextmanager
    def _told(self) -> Iterator[None]:
        """Make faults of ours of all faults, and not with the SDK's own as their cause, since that holds the request with its key."""
        try:
            yield
        except openai.APIStatusError as error:
            raise self._place.fault_of_status(error.status_code, error.response.headers, error.response.text) from None
        except _LOST as error:
            cause = error.__cause__ if isinstance(error, openai.OpenAIError) else None
            raise self._lost(cause or error) from None

    def _lost(self, cause: BaseException) -> ProviderError:
        """The fault of an answer that did not come, or not as a whole."""
        host, url = self._place.host, self._place.url
        said = self._place.words.clean(str(cause), 150)
        why = f": {said}" if said else ""
        if isinstance(cause, httpx2.ConnectError | httpx2.ConnectTimeout | httpx2.ProxyError):
            hint = f"Is the server running, and is {url} its base URL?"
            final = "CERTIFICATE_VERIFY_FAILED" in str(cause)
            return ProviderError(f"{url} cannot be reached{why}.", "failed" if final else "unreachable", hint)
        if isinstance(cause, httpx2.TimeoutException):
            hint = "Try again later, use a faster model, or wait longer."
            return ProviderError(f"{host} gave no sign of life for {self._timeout_s:g} s.", "timed_out", hint)
        if isinstance(cause, httpx2.NetworkError | httpx2.RemoteProtocolError | ssl.SSLError):
            return ProviderError(f"{host} broke the connection off{why}.", "cut_off", "Try again.")
        return ProviderError(
            f"{host} cannot be asked{why}.", "failed", f"Is {url} a base URL, and is the environment's proxy right?"
        )


class _Bounded(httpx2.BaseTransport):
    """A transport whose answers end in time and size. It also unpacks them, so that a small answer cannot unfold into a large one."""

    def __init__(self, inner: httpx2.BaseTransport, host: str, longest_s: float, clock: Callable[[], float]) -> None:
        self._inner, self._host, self._longest_s, self._clock = inner, host, longest_s, clock

    def handle_request(self, request: httpx2.Request) -> httpx2.Response:
        """Send a request."""
        until = self._clock() + self._longest_s
        response = self._inner.handle_request(request)
        headers = [(name, value) for name, value in response.headers.multi_items() if name != "content-encoding"]
        stream = _Stream(response, lambda size: self._check(size, until))
        return httpx2.Response(response.status_code, headers=headers, stream=stream, extensions=response.extensions)

    def close(self) -> None:
        """Close the connections."""
        self._inner.close()

    def _check(self, size: int, until: float) -> None:
        if size > LARGEST:
            raise ProviderError(f"The answer of {self._host} is larger than {LARGEST >> 20} MiB.", "failed")
        if self._clock() > until:
            message = f"The answer of {self._host} was not finished after {self._longest_s:g} s."
            raise ProviderError(message, "timed_out", "Use a faster model, or wait longer.")


class _Stream(httpx2.SyncByteStream):
    def __init__(self, response: httpx2.Response, check: Callable[[int], None]) -> None:
        self._response, self._check = response, check

    def __iter__(self) -> Iterator[bytes]:
        size = 0
        for piece in self._response.iter_bytes():
            size += len(piece)
            self._check(size)
            yield piece

    def close(self) -> None:
        self._response.close()


def _trust(url: str) -> ssl.SSLContext | bool:
    """Whom to trust. Loading the authorities takes a tenth of a second, so nobody is loaded where nothing is encrypted."""
    return True if urlsplit(url).scheme == "https" else ssl.SSLContext(ssl.PROTOCOL_TLS_CLIENT)


def _proxy(url: str) -> str | None:
    """The proxy that the environment names for an address. What runs on this machine is never asked through one."""
    parts = urlsplit(url)
    host = parts.hostname or ""
    if host in _LOOPBACK or host.startswith("127.") or proxy_bypass(host):
        return None
    known = getproxies()
    return known.get(parts.scheme) or known.get("all")
