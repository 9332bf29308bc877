"""
How much shorter the schedules of large missions get: greedy, constraint programming alone, and large neighbourhood search before it.

::

    python -m benchmarks.neighbourhood                              missions of 25 to 400 goals, 10 s for each column
    python -m benchmarks.neighbourhood --goals 50 100 --seeds 0 1 2 --limit 5

Missions by chance on open ground (:mod:`benchmarks.random_missions`), with travel and holding; the best alternative of each is
scheduled. Every schedule is checked. A bound is missiontree's own, of paths and loads. Limits are seconds of the clock: nothing else
should work beside.
"""

from __future__ import annotations

import argparse
import tempfile
from collections.abc import Sequence
from dataclasses import replace
from functools import partial
from pathlib import Path

from benchmarks.machine import machine_line
from benchmarks.random_missions import write_mission
from missiontree.briefing import request_from
from missiontree.checking import check
from missiontree.mission.control import Control
from missiontree.mission.plan import Plan
from missiontree.planner import plan_request
from missiontree.scheduling import SCHEDULERS
from missiontree.scheduling.cpsat.engine import CPSAT, schedule_within

GOALS = (25, 50, 100, 200, 400)
ALONE = "cpsat alone"
COLUMNS = ("greedy", "auto", ALONE, "cpsat")


def planned(file: Path, scheduler: str, limit_s: float | None, seed: int) -> Plan:
    """The plan of a mission, by one scheduler."""
    request = request_from(file, scheduler="cpsat" if scheduler == ALONE else scheduler, k=1, seed=seed)
    if scheduler != ALONE:
        return plan_request(request, Control(time_limit_s=limit_s, seed=seed))
    kept = SCHEDULERS["cpsat"]
    SCHEDULERS["cpsat"] = partial(schedule_within, settings=replace(CPSAT, regrouping=0))
    try:
        return plan_request(request, Control(time_limit_s=limit_s, seed=seed))
    finally:
        SCHEDULERS["cpsat"] = kept


def row(folder: Path, goals: int, seed: int, limit_s: float, columns: Sequence[str]) -> str:
    """A line of the table."""
    file = write_mission(folder / f"{goals}-{seed}", goals, 3 + goals // 5, seed)
    cells, bound, roles = list[str](), 0.0, 0
    for name in columns:
        plan = planned(file, name, None if name == "greedy" else limit_s, seed)
        schedule = plan.schedules[0]
        if check(plan):
            raise SystemExit(f"the checker refuses a plan by {name}")
        cells.append(f"{schedule.makespan_s:.1f}" if schedule.actions else schedule.status)
        if name == columns[0] and schedule.certificate.bound is not None:
            bound, roles = schedule.certificate.bound, len(plan.ranking.alternatives[0].roles) if plan.ranking else 0
    return f"| {goals}, seed {seed} | {roles} | {bound:.1f} | {' | '.join(cells)} |"


def main() -> None:
    """Print the table."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--goals", type=int, nargs="+", default=list(GOALS))
    parser.add_argument("--seeds", type=int, nargs="+", default=[0])
    parser.add_argument(
        "--limit", type=float, default=10.0, metavar="S", help="seconds for each column but greedy (default 10)"
    )
    parser.add_argument("--columns", nargs="+", choices=COLUMNS, default=list(COLUMNS))
    given = parser.parse_args()
    print(machine_line("ortools"))
    print(f"\nMakespans in seconds; {given.limit:g} s.\n")
    print(f"| goals | roles | bound | {' | '.join(given.columns)} |")
    print("|---" * (3 + len(given.columns)) + "|")
    with tempfile.TemporaryDirectory() as folder:
        for goals in given.goals:
            for seed in given.seeds:
                print(row(Path(folder), goals, seed, given.limit, given.columns), flush=True)


if __name__ == "__main__":
    main()
