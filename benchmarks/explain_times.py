"""
How long it takes to say why a mission of the paper's size cannot be done, and what would make it possible.

::

    python -m benchmarks.explain_times

The samples as they are, those that can be done also once for each type of their fleet without it, as far as that makes them impossible,
and the ten missions in ``examples/failures``. Counted is what ``missiontree explain`` does once the files are read: authoring, planning,
causes, and repairs with their plans. Warm: the median of three runs after a first one. The bar is a median of half a second.
"""

from __future__ import annotations

import argparse
import time
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from statistics import median

from benchmarks.machine import machine_line
from missiontree.briefing import Request, request_from
from missiontree.explaining.explain import MOST_REPAIRS, Explained, explained
from missiontree.mission.control import Control
from missiontree.planner import author, plan_authored
from missiontree.samples.catalogue import SAMPLES, sample_file

FAILURES = Path(__file__).resolve().parents[1] / "examples" / "failures"
BAR_S = 0.5
RUNS = 3


def missions() -> Iterator[tuple[str, Request]]:
    """Samples as they are, those that can be done with a type less, and the everyday failures; not all of them are impossible."""
    for name in SAMPLES:
        request = request_from(sample_file(name))
        yield name, request
        if explanation(request) is not None:
            continue
        for kind in request.brief.fleet.types:
            brief = request.brief
            less = replace(brief, without=(*brief.without, kind.id))
            yield f"{name} without {kind.id}", replace(request, brief=less)
    for folder in sorted(FAILURES.iterdir()):
        if folder.is_dir():
            yield f"failures/{folder.name}", request_from(folder / "mission.yaml")


def explanation(request: Request) -> Explained | None:
    """The explanation of a mission that cannot be done; None of one that can."""
    plan = plan_authored(request, author(request), Control())
    return None if plan.outcome == "delivered" else explained(plan, request, Control(), MOST_REPAIRS)


def main() -> None:
    """Print the table and the median."""
    argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter).parse_args()
    print(machine_line("pydantic"))
    print("\n| mission | causes | repairs | seconds | of the processor |\n|---|---|---|---|---|")
    seconds, processor = [], []
    for name, request in missions():
        if (found := explanation(request)) is None:
            continue
        took, used = [], []
        for _ in range(RUNS):
            began, before = time.perf_counter(), time.process_time()
            explanation(request)
            took.append(time.perf_counter() - began)
            used.append(time.process_time() - before)
        seconds.append(median(took))
        processor.append(median(used))
        cells = [name, str(len(found.told.causes)), str(len(found.told.repairs))]
        print(f"| {' | '.join(cells)} | {seconds[-1]:.3f} | {processor[-1]:.3f} |", flush=True)
    print(f"\n{len(seconds)} missions: median {median(seconds):.3f} s, longest {max(seconds):.3f} s.")
    print(f"Of the processor: median {median(processor):.3f} s, longest {max(processor):.3f} s.")
    if median(seconds) > BAR_S:
        raise SystemExit(f"the median is above {BAR_S:g} s")


if __name__ == "__main__":
    main()
