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

    What was registered for the end is done, but the interpreter is not taken down: that takes a tenth of a second once solvers are
    loaded, and half a second where large trees were. A compiler or a solver that was left behind must not even see what is registered
    done around it: it fails, and the process with it.
    """
    deaf()  # a late signal must not make a failure of it
    if not anyone_left():
        atexit._run_exitfuncs()  # the one public way to have them done is to take the interpreter down
    for stream in (sys.stdout, sys.stderr):
        with suppress(OSError, ValueError):  # whoever read it is gone
            stream.flush()
    os._exit(code)
