"""
Job shops as trees in columns: flexible ones in the form of Brandimarte's instances, and classic ones (:mod:`classic_shop`).

Line 1: how many jobs and how many machines; a third number, the machines per operation on average, may follow. Then a line per job: how
many operations, and for each operation how many machines are able, and a machine and a time for each of these. Machines are numbered
from 0 or from 1: from 1 if one has the number of machines as its number. Empty lines do not count, and neither does what follows a #.

A job becomes an AND of operations, each before the next; an operation an XOR over the machines able to do it; a machine a robot, which
does one thing at a time.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

from missiontree.errors import InputError
from missiontree.formats.importers.classic_shop import as_flexible, fault_of, is_classic
from missiontree.formats.place import quoted
from missiontree.formats.source import clean, load_text
from missiontree.mission.columns import AND, LEAF, XOR, TreeColumns
from missiontree.mission.fleet import MAX_ROBOTS

MOST = 10**9
MOST_WAYS = 1_000_000
"""Of pairs of a machine and a time in one file."""
FORM = "the number of operations, then for each: how many machines are able, and a machine and a time for each of them"
CLASSIC_FORM = "machine and time in turn, every machine once, numbered from 0 or from 1"
_NUMBER = re.compile(r"\d{1,18}").fullmatch
_DECIMAL = re.compile(r"\d{1,18}(\.\d*)?").fullmatch
_HEAD = re.compile(r"\ufeff?(\s*#[^\r\n]*[\r\n])*\s*-?\d").match
_LINE_END = re.compile(r"\r\n|\r|\n")


def looks_like_shop(text: str) -> bool:
    """Whether this is meant to be a file of this form: its first line that is no comment begins with a number."""
    return _HEAD(text) is not None


def read_shop(path: Path) -> TreeColumns:
    """
    Read a file.

    Raises
    ------
    InputError
        If it cannot be read or is no such file; says which line, what was found and what is accepted.
    """
    return shop_of(load_text(path), str(path))


def shop_of(text: str, source: str = "<text>") -> TreeColumns:
    """
    The tree that a text describes.

    Raises
    ------
    InputError
        As :func:`read_shop`.
    """
    lines = _lines(clean(text, source))
    line, words = next(lines, (0, []))
    if not words:
        raise InputError(
            "the file is empty", file=source, accepted="the numbers of jobs and of machines in its first line"
        )
    jobs, machines = _head(words, source, line)
    reading = _Reading(source, machines)
    found, rest = 0, [*lines]
    classic = is_classic([words for _, words in rest], machines)
    for line, words in rest:
        if found == jobs:
            raise InputError(
                f"a line follows the last of {jobs} jobs", file=source, line=line, accepted="no more lines than jobs"
            )
        found += 1
        if classic and (fault := fault_of(words, machines)):
            raise reading.refusal(line, f"{fault} in the line of job {found}", CLASSIC_FORM)
        reading.job(found, as_flexible(words) if classic else words, line)
    if found < jobs:
        message = f"the file ends after {found} of {jobs} jobs"
        raise InputError(message, file=source, line=line, accepted="a line per job")
    return reading.columns()


def _lines(text: str) -> Iterator[tuple[int, list[str]]]:
    for number, line in enumerate(_LINE_END.split(text), start=1):
        if words := line.partition("#")[0].split():
            yield number, words


def _head(words: list[str], source: str, line: int) -> tuple[int, int]:
    accepted = "the numbers of jobs and of machines, and perhaps the machines per operation on average"
    if len(words) not in {2, 3} or not all(map(_NUMBER, words[:2])) or not _DECIMAL(words[-1]):
        shown = quoted(" ".join(words[:4]))
        raise InputError(f"the first line reads {shown}", file=source, line=line, accepted=accepted)
    jobs, machines = int(words[0]), int(words[1])
    for count, most, what in ((jobs, MOST_WAYS, "jobs"), (machines, MAX_ROBOTS, "machines")):
        if not 1 <= count <= most:
            raise InputError(f"{count} {what}", file=source, line=line, accepted=f"1 to {most:,} {what}")
    return jobs, machines


class _Reading:
    """What was read so far."""

    def __init__(self, source: str, machines: int) -> None:
        self.source, self.machines = source, machines
        self.kind, self.parent, self.robot, self.duration = [AND], [-1], [0], [0]
        self.names = ["All jobs"]
        self.precedence: list[tuple[int, int]] = []
        self.highest: tuple[int, int] = (-1, 0)  # machine and line
        self.zero: int = 0  # line in which machine 0 was named
        self.ways = 0

    def refusal(self, line: int, message: str, accepted: str = FORM) -> InputError:
        return InputError(message, file=self.source, line=line, accepted=accepted)

    def node(self, kind: int, parent: int, name: str, robot: int = 0, duration: int = 0) -> int:
        self.kind.append(kind)
        self.parent.append(parent)
        self.robot.append(robot)
        self.duration.append(duration)
        self.names.append(name)
        return len(self.kind) - 1

    def job(self, number: int, words: list[str], line: int) -> None:
        """Read the line of a job."""
        rest = iter(self._numbers(words, line))
        job = self.node(AND, 0, f"Job {number}")
        operations = next(rest)
        if not operations:
            raise self.refusal(line, f"job {number} has no operation", "at least one operation")
        last = -1
        for place in range(1, operations + 1):
            operation = self.node(XOR, job, f"Operation {place} of job {number}")
            self._ways(operation, rest, line, f"operation {place} of job {number}")
            if last >= 0:
                self.precedence.append((last, operation))
            last = operation
        left = sum(1 for _ in rest)
        if left:
            several = f"{left} numbers follow" if left > 1 else "1 number follows"
            raise self.refusal(line, f"{several} the last of {operations} operations of job {number}")

    def _numbers(self, words: list[str], line: int) -> list[int]:
        wrong = next((word for word in words if not _NUMBER(word)), None)
        if wrong is not None:
            if wrong.isdecimal():
                raise self.refusal(line, f"{quoted(wrong)} is too large", f"whole numbers from 0 to {MOST:,}")
            negative = wrong.startswith("-") and wrong[1:].isdecimal()
            what = "is below 0" if negative else "is not a whole number"
            raise self.refusal(line, f"{quoted(wrong)} {what}", "whole numbers of at least 0")
        return list(map(int, words))

    def _ways(self, operation: int, rest: Iterator[int], line: int, what: str) -> None:
        able = next(rest, -1)
        if able < 0:
            raise self.refusal(line, f"the line ends before {what}")
        if not able:
            raise self.refusal(line, f"no machine is able to do {what}", "at least one machine")
        named: set[int] = set()
        for _ in range(able):
            machine, time = next(rest, -1), next(rest, -1)
            if time < 0:
                raise self.refusal(line, f"the line ends within {what}, for which it announces {able} machines")
            self._check_way(machine, time, line, what)
            if machine in named:
                raise self.refusal(line, f"machine {machine} is named twice for {what}", "each able machine once")
            named.add(machine)
            self.node(LEAF, operation, f"{what[0].upper()}{what[1:]}", machine, time)
        self.ways += able

    def _check_way(self, machine: int, time: int, line: int, what: str) -> None:
        if machine > self.machines:
            accepted = f"machines from 0 to {self.machines - 1}, or from 1 to {self.machines}"
            raise self.refusal(line, f"machine {machine} for {what}, and there are {self.machines}", accepted)
        if time > MOST:
            raise self.refusal(line, f"time {time} for {what}", f"times from 0 to {MOST:,}")
        if self.ways >= MOST_WAYS:
            raise self.refusal(
                line, f"more than {MOST_WAYS:,} ways", f"a file with at most {MOST_WAYS:,} pairs of machine and time"
            )
        if machine > self.highest[0]:
            self.highest = (machine, line)
        if not machine and not self.zero:
            self.zero = line

    def columns(self) -> TreeColumns:
        """The tree, machines numbered from 0."""
        base = int(self.highest[0] == self.machines)
        if base and self.zero:
            raise self.refusal(
                max(self.zero, self.highest[1]),
                f"both machine 0 (line {self.zero}) and machine {self.machines} (line {self.highest[1]}) are named",
                f"{self.machines} machines, numbered from 0 or from 1",
            )
        nothing = [0] * len(self.kind)
        return TreeColumns(
            kind=self.kind,
            parent=self.parent,
            robot=[robot - base if kind == LEAF else 0 for kind, robot in zip(self.kind, self.robot, strict=True)],
            utility=nothing,
            duration=self.duration,
            consumption=nothing,
            precedence=self.precedence,
            disjoint=[],
            robots=self.machines,
            budget=None,
            names=[
                f"{name} on machine {robot}" if kind == LEAF else name
                for kind, robot, name in zip(self.kind, self.robot, self.names, strict=True)
            ],
            robot_names=[f"machine-{number + base}" for number in range(self.machines)],
        )
