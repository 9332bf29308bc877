"""A local model as the process around it sees it: imported late, open to Ctrl-C, quiet, and without a network."""

from __future__ import annotations

import os
import socket
import subprocess
import sys
from collections.abc import Iterator, Mapping
from contextlib import contextmanager, suppress
from pathlib import Path
from threading import Thread

import pytest

from tests.llm.tiny_gguf import write_tiny_gguf


@pytest.fixture(scope="module")
def file(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return write_tiny_gguf(tmp_path_factory.mktemp("model") / "tiny.gguf")


def in_a_process(code: str, argument: str, environment: Mapping[str, str] = os.environ) -> tuple[str, str, int]:
    """What Python prints, says aside and ends with, in a process of its own where nothing has been imported yet."""
    ended = subprocess.run(
        [sys.executable, "-c", code, argument],
        capture_output=True,
        text=True,
        timeout=120,
        check=False,
        env=environment,
    )
    return ended.stdout, ended.stderr, ended.returncode


IMPORTED = """
import sys
import missiontree.llm.local
missiontree.llm.local.LocalModel(sys.argv[1])
print("mistralrs" in sys.modules)
"""


def test_the_engine_is_imported_when_it_is_needed_and_no_earlier(file: Path) -> None:
    assert in_a_process(IMPORTED, str(file)) == ("False\n", "", 0)


INTERRUPTED = """
import os, signal, sys
from missiontree.llm.chat import Message
from missiontree.llm.local import LocalModel

signal.signal(signal.SIGINT, signal.default_int_handler)
heard = []

def listen(piece):
    heard.append(piece)
    if len(heard) == 3:
        os.kill(os.getpid(), signal.SIGINT)

model = LocalModel(sys.argv[1], listen=listen)
try:
    model([Message("user", "Hello.")], [])
except KeyboardInterrupt:
    print("interrupted after", len(heard))
print(model([Message("user", "Hello.")], []).finish)
"""


def test_ctrl_c_ends_a_turn_that_is_being_written_and_the_model_can_be_asked_again(file: Path) -> None:
    assert in_a_process(INTERRUPTED, str(file)) == ("interrupted after 3\nstop\n", "", 0)


@contextmanager
def proxy() -> Iterator[tuple[str, list[bytes]]]:
    """A proxy that notes who asks for what, and refuses."""
    asked: list[bytes] = []
    with socket.create_server(("127.0.0.1", 0)) as server:

        def serve() -> None:
            while True:
                try:
                    connection, _ = server.accept()
                except OSError:
                    return
                with connection:
                    asked.append(connection.recv(1_000))
                    connection.sendall(b"HTTP/1.1 502 Bad Gateway\r\nContent-Length: 0\r\n\r\n")

        Thread(target=serve, daemon=True).start()
        yield f"http://127.0.0.1:{server.getsockname()[1]}", asked
        with suppress(OSError):  # some systems know no shutdown of a socket that listens
            server.shutdown(socket.SHUT_RDWR)


def behind(url: str) -> dict[str, str]:
    """An environment that reaches nobody but through the proxy, with nothing said in it about hubs or logs."""
    unsaid = {"RUST_LOG", "HF_HUB_OFFLINE", "NO_PROXY", "no_proxy"}
    environment = {name: value for name, value in os.environ.items() if name not in unsaid}
    return environment | {"HTTPS_PROXY": url, "HTTP_PROXY": url, "ALL_PROXY": url}


ASKED = """
import os, sys
from missiontree.llm.chat import Message
from missiontree.llm.local import LocalModel

before = dict(os.environ)
said = LocalModel(sys.argv[1])([Message("user", "Hello.")], [])
assert said.finish == "stop", said
assert dict(os.environ) == before
"""
AT_A_HUB = """
import sys
from mistralrs import Runner, Which

Runner(Which.GGUF(quantized_model_id=sys.argv[1], quantized_filename="x.gguf"), token_source="none")
"""


def test_nothing_is_asked_of_any_hub_and_nothing_is_printed(tmp_path: Path) -> None:
    """Though the file names a model that it was made from, whose tokenizer could be fetched."""
    made_from = write_tiny_gguf(tmp_path / "tiny.gguf", base_model="https://huggingface.co/someone/something")
    with proxy() as (url, asked):
        assert in_a_process(ASKED, str(made_from), behind(url)) == ("", "", 0)
        assert asked == []
        # That the proxy would have seen it: the engine itself, told a name at a hub, asks.
        in_a_process(AT_A_HUB, "someone/something", behind(url))
        assert asked
        assert asked[0].startswith(b"CONNECT ")
