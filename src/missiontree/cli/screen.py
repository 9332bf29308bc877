"""The two streams: answers go to standard output, remarks to standard error."""

from __future__ import annotations

import sys
from functools import cache
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from rich.console import Console


@cache
def answers(colour: bool | None = None) -> Console:
    """Standard output; colour as the terminal can, unless told."""
    return _console(to_errors=False, colour=colour)


@cache
def remarks(colour: bool | None = None) -> Console:
    """Standard error."""
    return _console(to_errors=True, colour=colour)


def _console(to_errors: bool, colour: bool | None) -> Console:
    from rich.console import Console

    stream = sys.stderr if to_errors else sys.stdout
    width = None if stream.isatty() else 100
    return Console(
        stderr=to_errors,
        no_color=colour is False or None,
        force_terminal=True if colour else None,
        width=width,
        highlight=False,
    )
