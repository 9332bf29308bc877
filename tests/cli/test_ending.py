"""How the process ends: what is registered for the end is done, unless something was left behind that must not see it, and then at once."""

from __future__ import annotations

import os
import subprocess
import sys
from errno import EFBIG, ENOSPC

import pytest

from missiontree.cli.exits import Exit, guarded

PROGRAM = """
import atexit
from threading import Event
from missiontree.cli.ending import end
from missiontree.mission.aside import Aside
working = Aside(Event().wait) if {left} else Aside(Event)
if {left}:
    working.leave(whole=True)
atexit.register(print, "in order")
class Slow:
    def __del__(self):
        print("taken down")
slow = Slow()
print("all is said")
end(3)
"""


@pytest.mark.parametrize(("left", "said"), [(True, "all is said\n"), (False, "all is said\nin order\n")])
def test_the_process_ends_in_order_unless_something_was_left_behind(left: bool, said: str) -> None:
    ended = subprocess.run(
        [sys.executable, "-c", PROGRAM.format(left=left)], capture_output=True, text=True, check=False
    )
    assert (ended.returncode, ended.stdout, ended.stderr) == (3, said, "")


@pytest.mark.parametrize("number", [ENOSPC, EFBIG])
def test_a_full_disk_is_no_fault_of_ours(number: int, capsys: pytest.CaptureFixture[str]) -> None:
    def command() -> int:
        raise OSError(number, os.strerror(number))

    assert guarded(command, debug=False) == Exit.BAD_INPUT
    assert capsys.readouterr().err == f"the output cannot be written: {os.strerror(number)}\n"


@pytest.mark.skipif(os.name != "posix", reason="a shell closes streams")
def test_whoever_closed_the_streams_gets_the_exit_code() -> None:
    line = f'"{sys.executable}" -m missiontree plan "Reunite mom with her lost child"'
    assert subprocess.run(f"{line} >&- 2>&-", shell=True, check=False).returncode == Exit.DELIVERED  # noqa: S602 - our own words
