"""The line that lives while long work goes on: on a terminal alone, in words, and gone afterwards."""

from io import StringIO

import pytest

from missiontree.cli.live import LiveLine, line_of
from missiontree.mission.control import Progress


class Terminal(StringIO):
    """What is written to a terminal."""

    def isatty(self) -> bool:
        return True


class Clock:
    """Seconds that pass when they are told to."""

    def __init__(self) -> None:
        self.now = 0.0

    def __call__(self) -> float:
        return self.now


NEWS = Progress("scheduling", 3, 1, 36.0, 40.0)


@pytest.mark.parametrize(
    ("progress", "said"),
    [
        (NEWS, "scheduling: best 40 s, none below 36 s, gap 10 %"),
        (Progress("scheduling", 0, 0, 36.0), "scheduling: no schedule yet, none below 36 s"),
        (Progress("scheduling", 0, 1, None, 1246.0), "scheduling: best 20 min 46 s"),
        (Progress("allocation", 1204, 3, 8.5), "allocation: 1,204 looked at, 3 found, none better than 8.5"),
        (Progress("allocation", 7, 0), "allocation: 7 looked at, 0 found"),
    ],
)
def test_news_are_told_in_words(progress: Progress, said: str) -> None:
    assert line_of(progress) == said


def test_the_line_comes_after_a_while_is_not_written_too_often_and_goes() -> None:
    terminal, clock = Terminal(), Clock()
    with LiveLine(False, terminal, clock) as line:
        clock.now = 0.4
        line.report(NEWS)
        assert terminal.getvalue() == ""  # work that is over at once shows nothing
        clock.now = 2.0
        line.report(NEWS)
        assert "best 40 s, none below 36 s, gap 10 %, 2 s so far" in terminal.getvalue()
        before = terminal.getvalue()
        clock.now = 2.05
        line.report(Progress("scheduling", 4, 1, 36.0, 38.0))
        assert terminal.getvalue() == before
        clock.now = 2.2
        line.report(Progress("scheduling", 4, 1, 36.0, 38.0))
        assert "best 38 s" in terminal.getvalue()
    assert terminal.getvalue().rstrip().endswith("\x1b[2K")  # the last thing written clears the line
    after = terminal.getvalue()
    clock.now = 9.0
    line.report(NEWS)  # by a search that was left behind
    assert terminal.getvalue() == after


@pytest.mark.parametrize(("quiet", "stream"), [(True, Terminal()), (False, StringIO())])
def test_quiet_and_away_from_a_terminal_nothing_is_shown(quiet: bool, stream: StringIO) -> None:
    clock = Clock()
    with LiveLine(quiet, stream, clock) as line:
        clock.now = 5.0
        line.report(NEWS)
    assert stream.getvalue() == ""
