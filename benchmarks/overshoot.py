"""
Does ``missiontree`` end when it is told to, with the best that it had? Random time limits and signals for random work.

::

    python -m benchmarks.overshoot --count 300 --seed 0
    python -m benchmarks.overshoot --count 40 --seed 1 --only plan --slowest 5

Each run is a process: ``plan`` (schedulers cpsat and auto), ``schedule`` (job shops, trees and chains in columns, coalitions) or ``rank``
(exact, under budgets), on missions and instances made by chance. One of three things ends it: ``--time-limit`` of 0.2 to 10 s, or
SIGINT or SIGTERM 0.2 to 10 s after its clock started (with a time limit of a minute).

Counted is how much later than that the work was done (all found and checked, only printing is left), and the process gone (printing and
the interpreter's end included). What comes before the clock of the work starts is left out: starting Python, reading the input, and
building the mission tree; the process itself says when that was. Beside other work seconds of the clock tell little: where the system
says it (Linux), the processor's time from the end to the work being done is counted as well.

What must never be: an exit that is not documented, an output that cannot be read or that the checker refuses, a makespan above one that was
reported before, nothing where something was reported.
"""

from __future__ import annotations

import argparse
import json
import os
import signal
import subprocess
import sys
import tempfile
import threading
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from random import Random
from typing import Any, NamedTuple

from benchmarks.chains import chains
from benchmarks.machine import machine_line
from benchmarks.random_missions import write_mission
from benchmarks.trees import instance
from missiontree.checking import check
from missiontree.formats.document import read_text

LEAST_S, MOST_S = 0.2, 10.0
WHOLE_S = 60.0
HANGS_S = 90.0
ALLOWED_S, ALLOWED_SHARE = 0.1, 0.02
DOCUMENTED = (0, 1, 3, 130)
WAYS = ("limit", "SIGINT", "SIGTERM")
EPSILON = 1e-6
COLUMNS = (
    *("work", "ended by", "runs", "over before", "done: p50", "p90", "p99", "max", "p99 beyond 2 %", "gone: p99"),
    *("processor: p50", "p99", "faults"),
)


class Work(NamedTuple):
    """A command, without what ends it, and whether it is ``plan``, ``schedule`` or ``rank``."""

    kind: str
    name: str
    arguments: tuple[str, ...]


@dataclass
class Ran:
    """
    What a run came to.

    Parameters
    ----------
    work, way, after_s
        What was done, what ended it, and when that was, from the start of its clock.
    done_s, gone_s
        How much later the work was done and the process gone; negative if it was over before.
    cpu_s
        Seconds of the processor from the end to the work being done.
    faults
        What must not be.
    """

    work: Work
    way: str
    after_s: float
    done_s: float = 0.0
    gone_s: float = 0.0
    cpu_s: float = 0.0
    faults: list[str] = field(default_factory=list)

    @property
    def over(self) -> float:
        """What counts: beyond the share that is allowed."""
        return self.done_s - ALLOWED_SHARE * self.after_s


def works(folder: Path, luck: Random) -> list[Work]:
    """The pool that runs are drawn from, its inputs written into a folder."""
    pool: list[Work] = []
    for goals in (8, 20, 50, 120):
        file = str(write_mission(folder / f"goals-{goals}", goals, 3 + goals // 6, luck.randrange(1000)))
        for scheduler in ("cpsat", "auto"):
            for k in (1, 3):
                options = ("--scheduler", scheduler, "--alternatives", str(k))
                pool.append(Work("plan", f"{goals} goals, {scheduler}, k {k}", ("plan", file, *options)))
    texts = {
        "job shop 10 x 5": _shop(10, 6, luck),
        "job shop 20 x 10": _shop(20, 10, luck),
        "job shop 60 x 12": _shop(60, 12, luck),
        "mission 10000 8": json.dumps(instance("mission", 10_000, 8, luck.randrange(1000))),
        "chains": json.dumps(chains(1_200, 4, 20, 2)),
        "coalitions": json.dumps(_coalitions(16, 5, luck)),
    }
    for name, text in texts.items():
        file = _written(folder, name, text)
        pool.append(Work("schedule", name, ("schedule", file)))
        if name.startswith("job shop"):
            pool.append(Work("schedule", f"{name}, bounds", ("schedule", file, "--bound-share", "0.7")))
    for leaves in (1_000, 3_000, 10_000):
        name = f"mission {leaves} ranked"
        file = _written(folder, name, json.dumps(instance("mission", leaves, 8, luck.randrange(1000))))
        pool.append(Work("rank", name, ("rank", file, "--k", "10")))
    return pool


def _written(folder: Path, name: str, text: str) -> str:
    file = folder / f"{name.replace(' ', '-')}.{'json' if text.startswith('{') else 'txt'}"
    file.write_text(text, encoding="utf-8")
    return str(file)


def _shop(jobs: int, machines: int, luck: Random) -> str:
    lines = [f"{jobs} {machines}"]
    for _ in range(jobs):
        operations = []
        for _ in range(luck.randint(machines // 2, machines)):
            able = luck.sample(range(machines), luck.randint(1, 3))
            operations.append(" ".join([str(len(able)), *(f"{one} {luck.randint(1, 20)}" for one in able)]))
        lines.append(" ".join([str(len(operations)), *operations]))
    return "\n".join(lines) + "\n"


def _coalitions(tasks: int, robots: int, luck: Random) -> dict[str, Any]:
    needs = [[int(skill == luck.randrange(3) or luck.random() < 0.2) for skill in range(3)] for _ in range(tasks)]
    return {
        "Q": [[int(robot % 3 == skill or luck.random() < 0.3) for skill in range(3)] for robot in range(robots)],
        "R": [[0, 0, 0], *needs, [0, 0, 0]],
        "T_e": [0, *(luck.randint(40, 100) for _ in range(tasks)), 0],
        "task_locations": [[luck.randint(0, 100), luck.randint(0, 100)] for _ in range(tasks + 2)],
    }


def ran(work: Work, way: str, after_s: float, seed: int) -> Ran:
    """Run it and end it."""
    limit_s = after_s if way == "limit" else WHOLE_S
    reading, writing = os.pipe()
    command = [sys.executable, "-m", "benchmarks.overshoot_child", str(writing), *work.arguments]
    command += ["--time-limit", f"{limit_s:.3f}", "--seed", str(seed), "--json"]
    one = Ran(work, way, after_s)
    with tempfile.TemporaryFile() as told, tempfile.TemporaryFile() as said:
        child = subprocess.Popen(command, pass_fds=[writing], stdout=told, stderr=said)
        os.close(writing)
        lines, begun = list[list[str]](), threading.Event()
        listener = threading.Thread(target=_listen, args=(reading, lines, begun, child.pid), daemon=True)
        listener.start()
        ends_at = _ended(child, begun, lines, way, after_s)
        used_s = _processor_s(child.pid)
        try:
            child.wait(HANGS_S)
        except subprocess.TimeoutExpired:
            child.kill()
            child.wait()
            one.faults.append("hangs")
        gone = time.monotonic()
        listener.join()
        told.seek(0)
        said.seek(0)
        output, errors = told.read().decode(), said.read().decode()
    done = next((float(line[1]) for line in lines if line[0] == "done"), gone)
    one.done_s, one.gone_s = done - ends_at, gone - ends_at
    one.cpu_s = max(0.0, next((float(line[2]) for line in lines if line[0] == "done"), used_s) - used_s)
    one.faults += _faults(work, child.returncode, output, errors, lines)
    return one


def _processor_s(pid: int) -> float:
    """Seconds of the processor that a process has used; 0 where the system does not say."""
    try:
        columns = Path(f"/proc/{pid}/stat").read_text(encoding="utf-8").rpartition(")")[2].split()
    except OSError:
        return 0.0
    return (int(columns[11]) + int(columns[12])) / os.sysconf("SC_CLK_TCK")


def _listen(reading: int, lines: list[list[str]], begun: threading.Event, pid: int) -> None:
    with os.fdopen(reading) as pipe:
        for line in pipe:
            lines.append([*line.split(), *([str(_processor_s(pid))] if line.startswith("done") else [])])
            if line.startswith("begun"):
                begun.set()
    begun.set()


def _ended(
    child: subprocess.Popen[bytes], begun: threading.Event, lines: list[list[str]], way: str, after_s: float
) -> float:
    """When it was to end: by its limit, or since it was told so now."""
    begun.wait(HANGS_S)
    started = next((float(line[1]) for line in list(lines) if line[0] == "begun"), time.monotonic())
    try:
        child.wait(max(0.0, started + after_s - time.monotonic()))
    except subprocess.TimeoutExpired:
        if way == "limit":
            return started + after_s
        child.send_signal(getattr(signal, way))
        return time.monotonic()
    return started + after_s  # it was over before


def _faults(work: Work, code: int, output: str, errors: str, lines: list[list[str]]) -> Iterator[str]:
    """What must not be."""
    if code not in DOCUMENTED or "Traceback" in errors:
        yield f"exit {code}: {errors.strip()[-300:]}"
        return
    best: dict[str, float] = {}
    for line in lines:
        if line[0] == "best":
            best[line[1]] = min(best.get(line[1], float("inf")), float(line[2]))
    if code == 130:
        if best or output:
            yield "interrupted with nothing to keep, and yet something was found"
        return
    try:
        yield from READERS[work.kind](output, lines, best)
    except Exception as error:
        yield f"the output cannot be read: {type(error).__name__}: {error}"


def _of_plan(output: str, lines: list[list[str]], best: dict[str, float]) -> Iterator[str]:
    plan = read_text(output, "plan")
    for fault in check(plan):
        yield f"refused: {fault.rule}: {fault.message}"
    returned = {line[1]: line[2] for line in lines if line[0] == "piece"}
    for piece, value in best.items():
        if piece == "whole":
            continue
        if returned.get(piece) in {None, "None"} or float(returned[piece]) > value + EPSILON:
            yield f"{piece}: {value} was reported, {returned.get(piece)} returned"
    kept = {f"{schedule.makespan_s}" for schedule in plan.schedules if schedule.actions}
    lost = [value for value in returned.values() if value != "None" and value not in kept]
    if lost and plan.provenance.scheduler != "greedy":
        yield f"makespans {', '.join(lost)} were returned, and the plan has {', '.join(sorted(kept))}"


def _of_schedule(output: str, lines: list[list[str]], best: dict[str, float]) -> Iterator[str]:
    found = json.loads(output)
    makespan, busy = found["makespan_s"], dict[str, float]()
    if "whole" in best and makespan > best["whole"] + EPSILON:
        yield f"{best['whole']} was reported, {makespan} returned"
    for action in found["actions"]:
        if action["start_s"] < busy.get(action["robot"], 0.0) - EPSILON:
            yield f"{action['robot']} does two things at {action['start_s']} s"
        busy[action["robot"]] = max(busy.get(action["robot"], 0.0), action["end_s"])
    if abs(max(busy.values(), default=0.0) - makespan) > EPSILON:
        yield f"the last action ends at {max(busy.values())}, and not at {makespan}"


def _of_rank(output: str, lines: list[list[str]], best: dict[str, float]) -> Iterator[str]:
    found = json.loads(output)
    utilities = [one["utility"] for one in found["alternatives"]]
    if sorted(utilities, reverse=True) != utilities:
        yield f"out of order: {utilities}"
    most = max((int(line[2]) for line in lines if line[0] == "found"), default=0)
    if len(utilities) < min(most, found["k"]):
        yield f"{most} alternatives were reported, {len(utilities)} returned"


READERS: dict[str, Callable[[str, list[list[str]], dict[str, float]], Iterator[str]]] = {
    "plan": _of_plan,
    "schedule": _of_schedule,
    "rank": _of_rank,
}


def table(runs: list[Ran]) -> str:
    """As Markdown: how much later, by kind of work and by what ended it."""
    lines = [
        f"| {' | '.join(COLUMNS)} |",
        "|---" * len(COLUMNS) + "|",
    ]
    groups = {
        (kind, way): [one for one in runs if (one.work.kind, one.way) == (kind, way)]
        for kind in READERS
        for way in WAYS
    }
    groups["all", "all"] = runs
    for (kind, way), own in groups.items():
        late = [one for one in own if one.done_s > 0]
        if not own:
            continue
        done, gone = [one.done_s for one in late], [one.gone_s for one in late]
        cells = [*(_quantile(done, share) for share in (0.5, 0.9, 0.99, 1.0))]
        cells += [_quantile([one.over for one in late], 0.99), _quantile(gone, 0.99)]
        cells += [_quantile([one.cpu_s for one in late], share) for share in (0.5, 0.99)]
        faults = sum(bool(one.faults) for one in own)
        shown = " | ".join(f"{1000 * cell:.0f}" for cell in cells)
        lines.append(f"| {kind} | {way} | {len(own)} | {len(own) - len(late)} | {shown} | {faults} |")
    return "\n".join(lines)


def _quantile(values: list[float], share: float) -> float:
    ranked = sorted(values)
    return ranked[min(len(ranked) - 1, int(share * len(ranked)))] if ranked else 0.0


def main() -> None:
    """Run them all and print the table; fail if anything was seen that must never be."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--count", type=int, default=300, help="runs (default 300)")
    parser.add_argument("--seed", type=int, default=0, help="of everything (default 0)")
    parser.add_argument("--only", choices=tuple(READERS), help="one command alone")
    parser.add_argument(
        "--longest", type=float, default=MOST_S, metavar="S", help="latest limit or signal (default 10)"
    )
    parser.add_argument("--slowest", type=int, default=0, metavar="N", help="show the N that ended latest")
    given = parser.parse_args()
    runs: list[Ran] = []
    with tempfile.TemporaryDirectory() as folder:
        pool = works(Path(folder), Random(given.seed))  # noqa: S311 - luck for a campaign, not for secrets
        pool = [work for work in pool if given.only in {None, work.kind}]
        kinds = sorted({work.kind for work in pool})
        for number in range(given.count):
            luck = Random(f"{given.seed}:{number}")  # noqa: S311 - the same
            kind = luck.choice(kinds)
            work = luck.choice([work for work in pool if work.kind == kind])
            after_s = LEAST_S * (given.longest / LEAST_S) ** luck.random()
            runs.append(ran(work, luck.choice(WAYS), after_s, given.seed))
            for fault in runs[-1].faults:
                one = runs[-1]
                print(
                    f"run {number}: {one.work.name}, {one.way} {one.after_s:.3f} s: {fault}",
                    file=sys.stderr,
                    flush=True,
                )
    print(machine_line("ortools"))
    print(f"\nMilliseconds later than told; {given.count} runs, seed {given.seed}.\n")
    print(table(runs))
    for one in sorted(runs, key=lambda one: -one.over)[: given.slowest]:
        late_ms = ", ".join(f"{1000 * late:.0f}" for late in (one.done_s, one.gone_s, one.cpu_s))
        print(f"{one.work.name}, {one.way} {one.after_s:.3f} s: done, gone, processor {late_ms} ms")
    late = [one for one in runs if one.done_s > 0]
    if any(one.faults for one in runs) or _quantile([one.over for one in late], 0.99) > ALLOWED_S:
        raise SystemExit(1)


if __name__ == "__main__":
    main()
