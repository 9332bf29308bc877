"""An HTTP server on loopback that answers from a script, so that SDKs are tested against real connections."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, field
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from threading import Event, Thread
from typing import Any


@dataclass(frozen=True)
class Reply:
    """
    What one request is answered with.

    Parameters
    ----------
    status, headers, body
        As on the wire.
    chunks
        The body in chunks; sent instead of ``body`` if there are any.
    cut
        Close the connection where the body should go on.
    held
        Say nothing until the server closes.
    mute
        Close the connection without a word.
    """

    status: int = 200
    headers: Mapping[str, str] = field(default_factory=dict)
    body: bytes = b""
    chunks: tuple[bytes, ...] = ()
    cut: bool = False
    held: bool = False
    mute: bool = False

    @classmethod
    def of_json(cls, plain: Any, status: int = 200, **headers: str) -> Reply:
        named = {name.replace("_", "-"): value for name, value in headers.items()}
        return cls(status, {"content-type": "application/json", **named}, json.dumps(plain).encode())

    @classmethod
    def of_events(cls, events: Iterable[bytes], cut: bool = False) -> Reply:
        return cls(200, {"content-type": "text/event-stream; charset=utf-8"}, chunks=tuple(events), cut=cut)


@dataclass(frozen=True)
class Request:
    """What was asked."""

    path: str
    headers: Mapping[str, str]
    body: Any


Respond = Callable[[Request], Reply]


class Loopback(ThreadingHTTPServer):
    """The server; hands every request to ``respond`` and keeps it."""

    def __init__(self, respond: Respond) -> None:
        super().__init__(("127.0.0.1", 0), _Handler)
        self.respond, self.released, self.requests = respond, Event(), list[Request]()

    @property
    def url(self) -> str:
        return f"http://127.0.0.1:{self.server_address[1]}"


@contextmanager
def serving(respond: Respond) -> Iterator[Loopback]:
    """A server that answers while the block runs."""
    server = Loopback(respond)
    thread = Thread(target=server.serve_forever, kwargs={"poll_interval": 0.01})
    thread.start()
    try:
        yield server
    finally:
        server.released.set()
        server.shutdown()
        thread.join()
        server.server_close()


class _Handler(BaseHTTPRequestHandler):
    protocol_version = "HTTP/1.1"
    server: Loopback

    def do_POST(self) -> None:
        body = self.rfile.read(int(self.headers["content-length"]))
        request = Request(self.path, {name.lower(): value for name, value in self.headers.items()}, json.loads(body))
        self.server.requests.append(request)
        reply = self.server.respond(request)
        self.close_connection = True
        if reply.held:
            self.server.released.wait()
        if reply.held or reply.mute:
            return
        self.send_response(reply.status)
        for name, value in {**reply.headers, "connection": "close"}.items():
            self.send_header(name, value)
        if reply.chunks:
            self._send_chunks(reply)
        else:
            self._send_body(reply)

    def _send_chunks(self, reply: Reply) -> None:
        self.send_header("transfer-encoding", "chunked")
        self.end_headers()
        for chunk in reply.chunks:
            self.wfile.write(b"%x\r\n%b\r\n" % (len(chunk), chunk))
            self.wfile.flush()
        if not reply.cut:
            self.wfile.write(b"0\r\n\r\n")

    def _send_body(self, reply: Reply) -> None:
        self.send_header("content-length", str(len(reply.body)))
        self.end_headers()
        self.wfile.write(reply.body[: len(reply.body) // 2] if reply.cut else reply.body)

    def log_message(self, format: str, *args: Any) -> None:
        """Keep quiet."""


def closed_port() -> int:
    """A port on which nobody listens."""
    with serving(lambda request: Reply()) as server:
        return int(server.server_address[1])
