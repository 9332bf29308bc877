"""The file of results: a line of JSON per run, only ever added to, so that nothing done is lost and nothing is done twice."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any, get_args

from missiontree.authoring.outcome import AuthoringStatus
from missiontree.errors import InputError
from missiontree.evaluation.run import Key, Run
from missiontree.evaluation.suite import Setting
from missiontree.evaluation.suite_file import SuiteMission
from missiontree.evaluation.verdict import VERDICTS
from missiontree.formats.plain import to_plain
from missiontree.mission.spent import Spent

FORMAT = "run/1"
_ACCEPTED = "a file that `missiontree evaluate --results` wrote, or none yet"
_START = b'{"di'  # of every line: its first key is differences or digest


@dataclass(frozen=True, slots=True)
class Ledger:
    """
    The runs of a file.

    Parameters
    ----------
    path
        The file.
    runs
        What it holds, by what tells runs apart; of several lines with one key the last counts.
    length
        Bytes of the file up to the end of its last whole line; what stands behind was cut off in the middle and is ignored.
    ended
        Whether that line has its end.
    """

    path: Path
    runs: dict[Key, Run]
    length: int = 0
    ended: bool = True

    @contextmanager
    def opened(self) -> Iterator[Callable[[Run], None]]:
        """
        Open the file to add runs; a last line that was cut off is taken away first.

        Yields
        ------
        function
            Adds a line and hands it to the operating system at once.

        Raises
        ------
        InputError
            If the file cannot be written.
        """
        try:
            file = self.path.open("ab")
        except OSError as error:
            raise InputError("the file cannot be written", file=str(self.path), hint=error.strerror or "") from error
        with file:
            file.truncate(self.length)
            file.write(b"" if self.ended else b"\n")
            file.flush()

            def add(run: Run) -> None:
                file.write(f"{line_of(run)}\n".encode())
                file.flush()

            yield add

    def changed(self, missions: Iterable[tuple[Setting, SuiteMission]], whole: bool = False) -> tuple[str, ...]:
        """
        Ids of the missions of which there are runs, though none of what they are now.

        Parameters
        ----------
        missions
            The missions.
        whole
            Whether trees are planned to their end before they are judged.
        """
        kept: dict[str, set[str]] = {}
        for run in self.runs.values():
            kept.setdefault(run.mission, set()).add(run.digest)
        digests = {mission.id: setting.digest(mission, whole) for setting, mission in missions if mission.id in kept}
        return tuple(name for name, digest in digests.items() if digest not in kept[name])


def line_of(run: Run) -> str:
    """A run as one line of JSON, ASCII throughout."""
    return json.dumps({"format": FORMAT, **to_plain(run)}, sort_keys=True, separators=(",", ":"), allow_nan=False)


def read_ledger(path: Path) -> Ledger:
    """
    The runs of a file; none if there is no such file.

    Raises
    ------
    InputError
        If it cannot be read, or a line other than a cut last one is no run; with the line.
    """
    try:
        content = path.read_bytes() if path.exists() else b""
    except OSError as error:
        raise InputError("the file cannot be read", file=str(path), hint=error.strerror or "") from error
    whole, _, rest = content.rpartition(b"\n")
    lines = whole.split(b"\n") if whole else []
    runs: dict[Key, Run] = {}
    for number, line in enumerate(lines, start=1):
        run = _run(line, path, number)
        runs[run.key] = run
    length = len(whole) + 1 if lines else 0
    if _is_cut(rest, alone=not lines):
        return Ledger(path, runs, length)
    last = _run(rest, path, len(lines) + 1)
    return Ledger(path, {**runs, last.key: last}, len(content), ended=False)


def _is_cut(rest: bytes, alone: bool) -> bool:
    """Whether what stands behind the last line end was cut in the middle; if nothing stands before it, it must begin as our lines do."""
    if alone and rest[: len(_START)] != _START[: len(rest)]:
        return False
    try:
        json.loads(rest)
    except (ValueError, RecursionError):
        return True
    return False


def _run(line: bytes, path: Path, number: int) -> Run:
    try:
        plain = json.loads(line)
    except (ValueError, RecursionError) as error:
        raise InputError("this line is not JSON", file=str(path), line=number, accepted=_ACCEPTED) from error
    if not isinstance(plain, dict) or plain.pop("format", None) != FORMAT:
        raise InputError(f"this line is not of the format {FORMAT}", file=str(path), line=number, accepted=_ACCEPTED)
    try:
        return _from_plain(plain)
    except (TypeError, ValueError) as error:
        raise InputError(f"this line is no run: {error}", file=str(path), line=number, accepted=_ACCEPTED) from error


def _from_plain(plain: dict[str, Any]) -> Run:
    spent = plain.pop("spent", None)
    run = Run(**plain, spent=None if spent is None else Spent(**spent))
    if run.kind not in VERDICTS or run.status not in get_args(AuthoringStatus):
        raise ValueError(f"there is no verdict {run.kind!r} with {run.status!r}.")
    return run
