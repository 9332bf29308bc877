"""
What every campaign shares: numbered runs, a state file to resume from, and a table of what was seen.

A campaign is a function from a seed and a number to a :class:`Verdict`. Runs depend on nothing else, so it does not matter in how
many processes or sittings they are made. The state belongs to one state of the code that the campaign uses; with another, the figures
would belong to none.
"""

from __future__ import annotations

import argparse
import json
import os
import time
import traceback
from collections import Counter, deque
from collections.abc import Callable, Iterator, Mapping
from concurrent.futures import Future, ProcessPoolExecutor
from dataclasses import dataclass, field
from inspect import getfile
from multiprocessing import get_context, parent_process
from pathlib import Path
from random import Random
from threading import Thread
from typing import Any

from benchmarks.campaign_source import source_digest
from benchmarks.machine import machine_line

CHUNK = 100
AHEAD = 3
"""Pieces begun or waiting for each process beyond those that the state waits for: one slow piece keeps nobody from working."""
CRASH = "crashes"
_SHOWN = 5


@dataclass(frozen=True, slots=True)
class Verdict:
    """
    What one run came to.

    Parameters
    ----------
    row
        The kind of run, a row of the table.
    counts
        What to add to the columns of that row.
    violations
        What must never be: kind and message.
    """

    row: str
    counts: Mapping[str, int] = field(default_factory=dict)
    violations: tuple[tuple[str, str], ...] = ()


Judge = Callable[[int, int], Verdict]
"""Makes the run of a seed and a number. It may raise: that is a crash, and counted."""


Rows = Mapping[str, Mapping[str, int]]
"""What was counted so far, by row and column."""


def _no_facts(seed: int, done: int) -> Mapping[str, object]:
    return {}


def _nothing_told(rows: Rows) -> Mapping[str, object]:
    return {}


@dataclass(frozen=True, slots=True)
class Campaign:
    """
    A campaign.

    Parameters
    ----------
    name
        Its name, for the state file.
    about
        What it asks, for the help.
    count
        How many runs the full one has.
    judge
        Makes a run; a function of a module, so that other processes find it.
    never
        Kinds of violation, each shown even if there is none of it. Crashes are added.
    unit
        What a run is called.
    facts
        Further lines of the table, by seed and number of runs done.
    told
        Further lines of the table, by what was counted.
    chunk
        How many runs that follow each other are made in one process, and between two savings of the state. Default 100.
    """

    name: str
    about: str
    count: int
    judge: Judge
    never: tuple[str, ...]
    unit: str = "runs"
    facts: Callable[[int, int], Mapping[str, object]] = _no_facts
    told: Callable[[Rows], Mapping[str, object]] = _nothing_told
    chunk: int = CHUNK


@dataclass
class State:
    """What was seen so far."""

    campaign: str
    seed: int
    source: str
    done: int = 0
    seconds: float = 0.0
    slowest_s: float = 0.0
    slowest: int = -1  # its number
    rows: dict[str, dict[str, int]] = field(default_factory=dict)
    violations: dict[str, list[str]] = field(default_factory=dict)

    def add(self, other: State) -> None:
        """Take in what further runs came to."""
        self.done += other.done
        self.slowest_s, self.slowest = max((self.slowest_s, self.slowest), (other.slowest_s, other.slowest))
        for row, counts in other.rows.items():
            self.rows[row] = dict(Counter(self.rows.get(row, {})) + Counter(counts))
        for kind, messages in other.violations.items():
            self.violations.setdefault(kind, []).extend(messages)


def luck(seed: int, index: int) -> Random:
    """The source of all luck of a run."""
    return Random(f"{seed}:{index}")  # noqa: S311 - luck for tests, not for secrets


def made(campaign: Campaign, seed: int, start: int, stop: int) -> State:
    """Make the runs of those numbers, here and now."""
    state = State(campaign.name, seed, "")
    for index in range(start, stop):
        began = time.perf_counter()
        try:
            verdict = campaign.judge(seed, index)
        except Exception:
            verdict = Verdict("crashed", violations=((CRASH, traceback.format_exc(limit=-3)),))
        seconds = time.perf_counter() - began
        one = State(campaign.name, seed, "", done=1, slowest_s=seconds, slowest=index)
        one.rows[verdict.row] = {campaign.unit: 1, **verdict.counts}
        for kind, message in verdict.violations:
            one.violations.setdefault(kind, []).append(f"{index}: {message}")
        state.add(one)
    return state


def run(campaign: Campaign) -> None:
    """The command: run or resume the campaign, print its table, and fail if anything was seen that must never be."""
    parser = argparse.ArgumentParser(description=campaign.about, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--count", type=int, default=campaign.count, help=f"{campaign.unit} (default {campaign.count})")
    parser.add_argument("--seed", type=int, default=1, help="seed of the campaign (default 1)")
    parser.add_argument("--state", type=Path, default=None, help="file to keep the state in and to resume from")
    parser.add_argument("--jobs", type=int, default=1, help="processes (default 1)")
    given = parser.parse_args()
    state = _resumed(given.state, campaign, given.seed)
    began = time.perf_counter() - state.seconds
    for piece in _pieces(campaign, given.seed, state.done, given.count, given.jobs):
        state.add(piece)
        state.seconds = time.perf_counter() - began
        if given.state is not None:
            _save(given.state, state)
    print(table(campaign, state))
    if any(state.violations.values()):
        raise SystemExit(1)


def table(campaign: Campaign, state: State) -> str:
    """The result as Markdown: what must never be, then what was seen of each kind."""
    facts: dict[str, object] = {campaign.unit: state.done}
    facts |= {kind: len(state.violations.get(kind, ())) for kind in (*campaign.never, CRASH)}
    facts |= campaign.facts(state.seed, state.done)
    facts |= campaign.told(state.rows)
    rate = state.done / state.seconds if state.seconds else 0.0
    facts |= {"seconds": f"{state.seconds:.0f}", f"{campaign.unit} per second": f"{rate:.0f}"}
    facts |= {
        "slowest of them, seconds": f"{state.slowest_s:.2f} (number {state.slowest})",
        "seed": state.seed,
        "source": state.source,
    }
    lines = [machine_line("pydantic"), "", "| what | value |", "|---|---|"]
    lines += [f"| {what} | {value} |" for what, value in facts.items()]
    columns = list(dict.fromkeys([campaign.unit, *sorted(name for row in state.rows.values() for name in row)]))
    lines += ["", f"| kind | {' | '.join(columns)} |", f"|---|{'---|' * len(columns)}"]
    for row in sorted(state.rows):
        lines.append(f"| {row} | {' | '.join(str(state.rows[row].get(name, 0)) for name in columns)} |")
    totals = [sum(row.get(name, 0) for row in state.rows.values()) for name in columns]
    lines.append(f"| all | {' | '.join(map(str, totals))} |")
    for kind, messages in state.violations.items():
        lines += ["", f"{kind}:", *messages[:_SHOWN]]
    return "\n".join(lines)


def _pieces(campaign: Campaign, seed: int, start: int, stop: int, jobs: int) -> Iterator[State]:
    """What is left to do, piece by piece, in order."""
    size = campaign.chunk
    spans = ((first, min(first + size, stop)) for first in range(start, stop, size))
    if jobs == 1:
        for first, last in spans:
            yield made(campaign, seed, first, last)
        return
    with ProcessPoolExecutor(jobs, get_context("spawn"), leave_with_parent) as pool:
        running = deque[Future[State]]()
        for first, last in spans:
            running.append(pool.submit(made, campaign, seed, first, last))
            if len(running) > AHEAD * jobs:
                yield running.popleft().result()
        while running:
            yield running.popleft().result()


def leave_with_parent() -> None:
    """Let this process end as soon as the one that started it has: a worker of one that was killed would wait for ever."""
    parent = parent_process()
    assert parent is not None

    def wait() -> None:
        parent.join()
        os._exit(1)

    Thread(target=wait, daemon=True).start()


def _resumed(path: Path | None, campaign: Campaign, seed: int) -> State:
    source = source_digest(Path(getfile(campaign.judge)))
    if path is None or not path.exists():
        return State(campaign.name, seed, source)
    kept: dict[str, Any] = json.loads(path.read_text(encoding="utf-8"))
    state = State(**kept)
    if (state.campaign, state.seed, state.source) != (campaign.name, seed, source):
        raise SystemExit(
            f"{path} belongs to {state.campaign}, seed {state.seed}, source {state.source}; "
            f"this is {campaign.name}, seed {seed}, source {source}. Take another file, or delete it."
        )
    return state


def _save(path: Path, state: State) -> None:
    beside = path.with_name(path.name + ".new")
    beside.write_text(json.dumps(vars(state)), encoding="utf-8")
    os.replace(beside, path)
