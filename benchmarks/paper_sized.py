"""
How long missions of the paper's size take from the tree to a checked plan, scene and travel included.

::

    python -m benchmarks.paper_sized                      schedulers greedy, auto and cpsat
    python -m benchmarks.paper_sized --schedulers auto --times 9

Every sample that comes with a scene. Counted is what follows when the mission tree is there: grounding over fleet and scene, the best
alternatives and their schedules, and the check of the plan; reading the files and building the tree are not. *cold*: for the first time
in a process of its own, what is imported on the way (the solver included, where it is asked) counted in and shown apart; *warm*: the
median of further times in the same process. Both as seconds of the clock and of the processor, which may be more where the solver's
threads work.
"""

from __future__ import annotations

import argparse
import json
import subprocess
import sys
import time
from collections.abc import Sequence
from pathlib import Path
from statistics import median

from benchmarks.machine import machine_line
from missiontree.briefing import request_from
from missiontree.mission.control import Control
from missiontree.planner import author, plan_authored
from missiontree.samples.catalogue import SAMPLES, sample_file

ROOT = Path(__file__).resolve().parents[1]
BAR_S = 0.3
SCHEDULERS = ("greedy", "auto", "cpsat")
HEAD = (
    "sample",
    "scheduler",
    "actions",
    "makespan s",
    "known",
    "cold s",
    "of it imports",
    "warm s",
    "warm, processor",
    "solver loaded",
)


def with_scene() -> list[str]:
    """Samples whose mission has a scene."""
    return [name for name in SAMPLES if request_from(sample_file(name)).brief.scene is not None]


def measured(name: str, scheduler: str, times: int) -> dict[str, object]:
    """One sample in this process, which should be a fresh one."""
    seconds, processor, imports = [], [], 0.0
    for number in range(times + 1):
        request = request_from(
            sample_file(name), scheduler=scheduler
        )  # anew, since scenes keep the ways found through them
        tree = author(request)
        before, started, used = set(sys.modules), time.perf_counter(), time.process_time()
        plan = plan_authored(request, tree, Control())
        seconds.append(time.perf_counter() - started)
        processor.append(time.process_time() - used)
        if not number:
            imports = _importing(sorted(set(sys.modules) - before))
    schedule = next((one for one in plan.schedules if one.actions), None)
    return {
        "actions": len(schedule.actions) if schedule else 0,
        "makespan_s": schedule.makespan_s if schedule else None,
        "known": f"{schedule.status}, {schedule.certificate.method}" if schedule else plan.outcome,
        "cold_s": seconds[0],
        "imports_s": imports,
        "warm_s": median(seconds[1:]),
        "processor_s": median(processor[1:]),
        "solver": "ortools" in sys.modules,
    }


def _importing(modules: Sequence[str]) -> float:
    """How long these modules take to be imported, in a process that has all others."""
    if not modules:
        return 0.0
    command = (
        "import sys, time\nfrom importlib import import_module\nimport missiontree.planner, benchmarks.paper_sized\n"
        "started = time.perf_counter()\n"
        "for name in sys.argv[1:]:\n    try:\n        import_module(name)\n    except Exception:\n        pass\n"
        "print(time.perf_counter() - started)"
    )
    ran = subprocess.run(
        [sys.executable, "-c", command, *modules], cwd=ROOT, capture_output=True, text=True, check=True
    )
    return float(ran.stdout)


def main() -> None:
    """Print the table; fail if something takes longer than the bar when warm."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--schedulers", nargs="+", choices=SCHEDULERS, default=list(SCHEDULERS))
    parser.add_argument("--times", type=int, default=5, help="warm runs of each (default 5)")
    parser.add_argument("--one", nargs=2, metavar=("SAMPLE", "SCHEDULER"), help=argparse.SUPPRESS)
    given = parser.parse_args()
    if given.one:
        name, scheduler = given.one
        print(json.dumps(measured(name, scheduler, given.times)))
        return
    print(machine_line("pydantic"))
    print(f"\nFrom the tree to the checked plan, 4 alternatives; bar {BAR_S:g} s.\n")
    print(f"| {' | '.join(HEAD)} |")
    print("|---" * len(HEAD) + "|")
    slow = []
    for scheduler in given.schedulers:
        for name in with_scene():
            command = [
                sys.executable,
                "-m",
                "benchmarks.paper_sized",
                "--one",
                name,
                scheduler,
                "--times",
                str(given.times),
            ]
            ran = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=True)
            told = json.loads(ran.stdout.splitlines()[-1])
            cells = [f"{told[key]:.3f}" for key in ("cold_s", "imports_s", "warm_s", "processor_s")]
            row = [
                name,
                scheduler,
                told["actions"],
                told["makespan_s"],
                told["known"],
                *cells,
                "yes" if told["solver"] else "no",
            ]
            print(f"| {' | '.join(map(str, row))} |", flush=True)
            slow += [f"{name} by {scheduler}"] if min(told["warm_s"], told["processor_s"]) > BAR_S else []
    if slow:
        raise SystemExit(f"longer than {BAR_S:g} s: {', '.join(slow)}")


if __name__ == "__main__":
    main()
