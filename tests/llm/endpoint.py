"""
A real HTTP server on loopback that speaks Chat Completions, says a script, breaks down where it is told to, and takes no request that
the strictest provider would refuse.
"""

from __future__ import annotations

import contextlib
import json
import os
import socket
import struct
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from threading import Event, Lock, Thread
from typing import Any, Self

from tests.llm.endpoint_replies import Reply, Turn, answered, error
from tests.llm.endpoint_rules import violations

Fault = Callable[[Turn, bool], Reply]
"""Makes what goes wrong of the turn that was due, and whether a stream was asked for."""
Objection = Callable[[Mapping[str, Any]], Reply | None]
"""What an endpoint objects to in a request; None if it takes it."""

KEY = "sk-test-0123456789abcdef"


class Endpoint:
    """
    The server.

    Parameters
    ----------
    turns
        What the model says; the last one again and again.
    faults
        By turn, counted from 1, what goes wrong before it is said: a fault for each request, until there are no more.
    objection
        Asked about each request before it is answered.
    """

    def __init__(
        self,
        turns: Sequence[Turn],
        faults: Mapping[int, Iterable[Fault]] | None = None,
        objection: Objection = lambda body: None,
    ) -> None:
        self.requests: list[dict[str, Any]] = []
        self.headers: list[dict[str, str]] = []
        self.violations: list[str] = []
        self.turn = 1
        self.released = Event()
        self._turns = list(turns)
        self._faults = {turn: iter(due) for turn, due in (faults or {}).items()}
        self._objection = objection
        self._lock = Lock()
        self._server = _Server(self)
        self._thread = Thread(target=self._server.serve_forever, kwargs={"poll_interval": 0.01})

    @property
    def url(self) -> str:
        """Base URL."""
        return f"http://127.0.0.1:{self._server.server_address[1]}/v1"

    def __enter__(self) -> Self:
        self._thread.start()
        return self

    def __exit__(self, *raised: object) -> None:
        self.released.set()
        self._server.shutdown()
        self._thread.join()
        self._server.server_close()

    def reply(self, path: str, headers: Mapping[str, str], body: Any) -> Reply:
        """Judge a request, keep it, and say what is due."""
        with self._lock:
            self.requests.append(body)
            self.headers.append({**headers, ":path": path})
            if path.partition("?")[0] != "/v1/chat/completions":
                return error(404, f"nothing at {path}")
            if wrong := violations(body):
                self.violations += wrong
                return error(400, "; ".join(wrong), "invalid_history")
            if (objected := self._objection(body)) is not None:
                return objected
            due = self._turns[min(self.turn, len(self._turns)) - 1]
            fault = next(self._faults.get(self.turn, iter(())), None)
            if fault is not None:
                broken = fault(due, bool(body.get("stream")))
                if broken.then is not None:
                    self._turns[min(self.turn, len(self._turns)) - 1] = broken.then
                return broken
            self.turn += 1
            return answered(due, body, self.turn)


class _Server(ThreadingHTTPServer):
    daemon_threads = False

    def __init__(self, endpoint: Endpoint) -> None:
        self.endpoint = endpoint
        super().__init__(("127.0.0.1", 0), _Handler)


class _Handler(BaseHTTPRequestHandler):
    protocol_version = "HTTP/1.1"
    server: _Server

    def do_POST(self) -> None:
        body = json.loads(self.rfile.read(int(self.headers["content-length"])))
        headers = {name.lower(): value for name, value in self.headers.items()}
        reply = self.server.endpoint.reply(self.path, headers, body)
        self.close_connection = True
        with contextlib.suppress(ConnectionError):  # the client may have given up by now
            self._send(reply)

    def _send(self, reply: Reply) -> None:
        if reply.pieces or reply.ending == "whole":
            self._send_head(reply)
        for piece in reply.pieces:
            self.wfile.write(piece if reply.ending == "whole" and len(reply.pieces) == 1 else _chunk(piece))
            self.wfile.flush()
        if reply.ending == "hold":
            self.server.endpoint.released.wait()
        elif reply.ending == "reset":
            self.connection.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, struct.pack("ii", 1, 0))
            os.close(self.connection.detach())
        elif reply.ending == "whole" and len(reply.pieces) > 1:
            self.wfile.write(b"0\r\n\r\n")

    def _send_head(self, reply: Reply) -> None:
        self.send_response_only(reply.status)  # without a date of today
        for name, value in {**reply.headers, "connection": "close"}.items():
            self.send_header(name, value)
        if reply.ending == "whole" and len(reply.pieces) <= 1:
            self.send_header("content-length", str(sum(map(len, reply.pieces))))
        else:
            self.send_header("transfer-encoding", "chunked")
        self.end_headers()

    def log_message(self, format: str, *args: Any) -> None:
        """Keep quiet."""


def _chunk(piece: bytes) -> bytes:
    return b"%x\r\n%b\r\n" % (len(piece), piece)


@contextlib.contextmanager
def nobody_listening() -> Iterator[str]:
    """Base URL of a port that is taken and on which nobody answers a call."""
    with socket.socket() as taken:
        taken.bind(("127.0.0.1", 0))
        yield f"http://127.0.0.1:{taken.getsockname()[1]}/v1"
