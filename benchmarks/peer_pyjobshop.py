"""
PyJobShop on a flexible job shop. Runs as a process of its own and prints one line of JSON: value, bound, seconds.

It needs nothing of missiontree, so that PyJobShop may be installed elsewhere. The form of the file is that of
:mod:`missiontree.formats.importers.fjsp`.
"""

from __future__ import annotations

import json
import sys
from collections.abc import Iterator
from pathlib import Path
from time import perf_counter

Operation = list[tuple[int, int]]
"""Able machines, each with a time."""


def jobs_of(text: str) -> tuple[list[list[Operation]], int]:
    """The jobs, each a list of operations, and how many machines there are; machines are numbered as in the file."""
    lines = [line.split() for line in text.splitlines() if line.strip()]
    count, machines = int(lines[0][0]), int(lines[0][1])
    return [list(_operations(iter(map(int, line)))) for line in lines[1 : 1 + count]], machines


def _operations(numbers: Iterator[int]) -> Iterator[Operation]:
    for _ in range(next(numbers)):
        yield [(next(numbers), next(numbers)) for _ in range(next(numbers))]


def main() -> None:
    """Solve ``FILE SECONDS SEED``, with 8 workers."""
    from pyjobshop import Model  # noqa: PLC0415 - an optional install, in this process alone

    file, limit_s, seed = sys.argv[1:]
    jobs, count = jobs_of(Path(file).read_text(encoding="utf-8"))
    model = Model()
    machines = [model.add_machine() for _ in range(count + 1)]  # they may be numbered from 1
    for operations in jobs:
        before = None
        for ways in operations:
            task = model.add_task()
            for machine, takes in ways:
                model.add_mode(task, machines[machine], takes)
            if before is not None:
                model.add_end_before_start(before, task)
            before = task
    started = perf_counter()
    result = model.solve(time_limit=float(limit_s), display=False, num_workers=8, random_seed=int(seed))
    found = result.objective if result.best is not None else None
    print(json.dumps({"value": found, "bound": result.lower_bound, "seconds": perf_counter() - started}))


if __name__ == "__main__":
    main()
