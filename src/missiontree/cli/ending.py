"""The end of the process."""

from __future__ import annotations

import atexit
import os
import sys
from contextlib import suppress
from typing import NoReturn

from missiontree.cli.interrupt import deaf
from missiontree.mission.aside import anyone_left


def end(code: int) -> NoReturn:
    """
    End the process with an exit code, when all is said.

    A compiler or a solver that was left behind must not see the interpreter taken down around it: it fails, and the process with it. So
    the process then ends at once, without that.
    """
    if anyone_left():
        deaf()
        for stream in (sys.stdout, sys.stderr):
            with suppress(OSError, ValueError):  # whoever read it is gone
                stream.flush()
        os._exit(code)
    atexit.register(deaf)  # a late signal must not make a failure of it
    sys.exit(code)
