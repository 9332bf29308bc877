"""A line that lives while long work goes on: what was found so far, what is known of the best there can be, and the gap."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable
from types import TracebackType
from typing import TYPE_CHECKING, TextIO

if TYPE_CHECKING:
    from rich.live import Live

    from missiontree.mission.control import Progress

PATIENCE_S = 0.5
"""Work that is over sooner shows nothing."""
EVERY_S = 0.1
"""The line is not written more often."""


class LiveLine:
    """
    A context in which progress is shown on standard error, in a line that is gone afterwards.

    Parameters
    ----------
    quiet
        Show nothing. Nothing is shown either where nobody looks: in a pipe or a file.
    stream
        Where it is shown. Default: standard error.
    clock
        Monotonic seconds.
    """

    def __init__(self, quiet: bool, stream: TextIO | None = None, clock: Callable[[], float] = time.monotonic) -> None:
        self._stream = stream if stream is not None else sys.stderr
        self._shown = not quiet and self._stream.isatty()
        self._clock = clock
        self._begun = self._last = clock()  # again when the work begins
        self._live: Live | None = None

    def __enter__(self) -> LiveLine:
        """Begin to wait for news."""
        self._begun = self._last = self._clock()
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        """Take the line away; news that come later are not shown."""
        self._shown = False
        if self._live is not None:
            self._live.stop()
            self._live = None

    def report(self, progress: Progress) -> None:
        """Show news, unless there were some a moment ago."""
        now = self._clock()
        if not self._shown or now - self._begun < PATIENCE_S or now - self._last < EVERY_S:
            return
        self._last = now
        from rich.text import Text

        line = Text(
            f"{line_of(progress)}, {now - self._begun:.0f} s so far", style="dim", no_wrap=True, overflow="ellipsis"
        )
        if self._live is None:
            from rich.console import Console
            from rich.live import Live

            console = Console(file=self._stream, highlight=False)
            self._live = Live(line, console=console, auto_refresh=False, transient=True)
            self._live.start()
        self._live.update(line, refresh=True)


def line_of(progress: Progress) -> str:
    """News in words: ``scheduling: best 40 s, none below 36 s, gap 10 %``."""
    if progress.stage != "scheduling":
        bound = "" if progress.bound is None else f", none better than {progress.bound:g}"
        return f"{progress.stage}: {progress.done:,} looked at, {progress.found:,} found{bound}"
    from missiontree.reporting.gantt.time import in_words
    from missiontree.reporting.known import gap_in_words

    parts = ["no schedule yet" if progress.best is None else f"best {in_words(progress.best)}"]
    if progress.bound is not None:
        parts.append(f"none below {in_words(progress.bound)}")
    if progress.best is not None and progress.bound is not None:
        parts.append(f"gap {gap_in_words(progress.bound, progress.best)}")
    return f"scheduling: {', '.join(parts)}"
