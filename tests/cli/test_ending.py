"""How the process ends: in order, or at once if something was left behind that must not see the interpreter taken down."""

from __future__ import annotations

import subprocess
import sys

import pytest

PROGRAM = """
import atexit
from threading import Event
from missiontree.cli.ending import end
from missiontree.mission.aside import Aside
working = Aside(Event().wait) if {left} else Aside(Event)
if {left}:
    working.leave(whole=True)
atexit.register(print, "in order")
print("all is said")
end(3)
"""


@pytest.mark.parametrize(("left", "said"), [(True, "all is said\n"), (False, "all is said\nin order\n")])
def test_the_process_ends_in_order_unless_something_was_left_behind(left: bool, said: str) -> None:
    ended = subprocess.run(
        [sys.executable, "-c", PROGRAM.format(left=left)], capture_output=True, text=True, check=False
    )
    assert (ended.returncode, ended.stdout, ended.stderr) == (3, said, "")
