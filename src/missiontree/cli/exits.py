"""Exit codes, and the guard that turns whatever ends a command into one of them and a few plain words."""

from __future__ import annotations

import sys
from collections.abc import Callable
from enum import IntEnum
from errno import EDQUOT, EFBIG, EIO, ENOSPC

from missiontree.errors import InputError


class Exit(IntEnum):
    """What a command came to; documented in the README."""

    DELIVERED = 0
    CANNOT_BE_DONE = 1
    BAD_INPUT = 2
    EXHAUSTED = 3
    FAILED = 4
    INCOMPLETE = 5
    FAULTS = 6
    INTERNAL = 70
    INTERRUPTED = 130


OUTCOMES = {
    "delivered": Exit.DELIVERED,
    "partial": Exit.CANNOT_BE_DONE,
    "cannot_be_done": Exit.CANNOT_BE_DONE,
    "incomplete": Exit.INCOMPLETE,
    "exhausted": Exit.EXHAUSTED,
    "provider_failed": Exit.FAILED,
}


UNWRITABLE = {ENOSPC, EDQUOT, EFBIG, EIO}
"""What a full or broken disk answers whoever writes to it."""


def guarded(command: Callable[[], int], debug: bool) -> int:
    """Run a command; bad input, an interruption and a fault of our own each end in words and a code, never in a traceback."""
    try:
        return command()
    except InputError as error:
        _say(f"bad input: {_harmless(str(error))}")
        return Exit.BAD_INPUT
    except KeyboardInterrupt:
        _say("interrupted; there is nothing to keep.")
        return Exit.INTERRUPTED
    except SystemExit as ended:  # all is said
        return ended.code if isinstance(ended.code, int) else Exit.DELIVERED
    except BrokenPipeError:
        sys.stderr.close()  # the reader has gone; Python would complain about the pipe once more on its way out
        return Exit.DELIVERED
    except Exception as error:
        if isinstance(error, OSError) and error.errno in UNWRITABLE:
            _say(f"the output cannot be written: {error.strerror}")
            return Exit.BAD_INPUT
        if debug:
            raise
        _say(_report(error))
        return Exit.INTERNAL


def _report(error: Exception) -> str:
    from platform import platform, python_version

    from missiontree import __version__

    last = error.__traceback__
    while last is not None and last.tb_next is not None:
        last = last.tb_next
    place = f"{last.tb_frame.f_code.co_filename.rpartition('missiontree/')[2]}:{last.tb_lineno}" if last else "?"
    return (
        "internal error: this is a fault of missiontree, not of your input. Please report these lines, and the command you typed:\n"
        f"  missiontree {__version__}, Python {python_version()}, {platform()}\n"
        f"  {type(error).__name__} at {place}: {_harmless(str(error))[:500]}\n"
        "  (--debug shows the whole traceback)"
    )


def _harmless(text: str) -> str:
    from missiontree.reporting.escape import terminal_safe

    return "\n".join(terminal_safe(line) for line in text.split("\n"))


def _say(text: str) -> None:
    print(text, file=sys.stderr)
