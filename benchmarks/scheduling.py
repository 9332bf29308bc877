"""
How short schedules are, and what is proven of them, where choices are part of the problem: ours beside PyJobShop.

::

    python -m benchmarks.scheduling --data FOLDER                          everything; a quarter of an hour
    python -m benchmarks.scheduling --only mission-1000 mission-4000 mission-100000 chains
    python -m benchmarks.scheduling --data FOLDER --only mk06 --no-peers --bound-share 0.9

Mission trees (each leaf a role of its own; budgets, utility and ``disjoint`` do not count) and chains are generated
(:mod:`benchmarks.trees`, :mod:`benchmarks.chains`). A folder adds a row per instance found in it or below: flexible job shops
(``*.txt``, ``*.fjs``), missions of coalitions and trees in columns (``*.json``). PyJobShop is optional (``pip install
missiontree[bench]``), is asked about job shops, with 8 workers, and runs in a process of its own, by another Python if it is installed
there (``--peer-python``). Seconds run from columns to the checked
schedule, in a process that has loaded (and, with numba, compiled) everything; a gap is |value - bound| over max(1, |value|). Every schedule
of ours passes the independent checker, or the run stops.
"""

from __future__ import annotations

import argparse
import json
import subprocess
import sys
from collections.abc import Iterator
from importlib.util import find_spec
from pathlib import Path
from random import Random
from time import perf_counter
from typing import NamedTuple

from benchmarks.chains import chains
from benchmarks.machine import machine_line
from benchmarks.trees import instance, text_of
from missiontree.errors import InputError
from missiontree.formats.importers.fjsp import shop_of
from missiontree.formats.importers.tree_json import columns_of
from missiontree.formats.reader import parse
from missiontree.instances import Instance, read_instance, schedule_instance
from missiontree.mission.coalitions import CoalitionMission
from missiontree.mission.control import Control
from missiontree.scheduling.joint.compiled import can_compile, fast_engine

ROOT = Path(__file__).resolve().parents[1]
GRACE_S = 60.0
GENERATED = {
    "mission-1000": ("mission", 1_000, 10, 3, 1.0),
    "mission-4000": ("mission", 4_000, 20, 8, 10.0),
    "mission-100000": ("mission", 100_000, 1_000, 9, 10.0),
    "load-10000": ("mission", 10_000, 8, 0, 10.0),
    "load-100000": ("mission", 100_000, 100, 1, 20.0),
}
"""Family, leaves, robots, seed, and seconds of limit. In the first three the longest path binds, in the others the load."""
CHAINS = tuple(range(6))
CHAINS_LIMIT_S = 10.0
SHOP_LIMIT_S = 60.0
HEAD = (
    "| work | value | bound | gap | known | s | PyJobShop: value | bound | s |",
    "|---|---|---|---|---|---|---|---|---|",
)


class Row(NamedTuple):
    """A line of work: its name, the instance, seconds of limit, and the file of a job shop for the peer."""

    name: str
    instance: Instance
    limit_s: float
    shop: Path | None


def rows(data: Path | None, wanted: set[str] | None) -> Iterator[Row]:
    """The rows asked for, made one by one."""
    for name, (family, leaves, robots, seed, limit_s) in GENERATED.items():
        if wanted is None or name in wanted:
            text = text_of(instance(family, leaves, robots, seed))
            yield Row(name, columns_of(parse(text, f"{name}.json")), limit_s, None)
    if wanted is None or "chains" in wanted:
        for seed in CHAINS:
            text = json.dumps(chains(1_200, 4, 20, seed))
            yield Row(f"chains, seed {seed}", columns_of(parse(text, "chains.json")), CHAINS_LIMIT_S, None)
    for file in sorted(data.rglob("*")) if data is not None else ():
        if file.suffix in {".txt", ".fjs", ".json"} and (wanted is None or file.stem in wanted):
            try:
                found = read_instance(file)
            except InputError as error:
                print(f"left out: {error}", file=sys.stderr)
                continue
            yield Row(file.stem, found, SHOP_LIMIT_S, None if file.suffix == ".json" else file)


def warm() -> Instance:
    """A job shop that goes through all that loads and compiles: no bound is met by its lists."""
    luck = Random(1)  # noqa: S311 - luck for an instance, not for secrets
    lines = ["12 4"]
    for _ in range(12):
        ways = " ".join(f"2 {first} {luck.randint(2, 9)} {first + 2} {luck.randint(2, 9)}" for first in (0, 1, 0, 1))
        lines.append(f"4 {ways}")
    return shop_of("\n".join(lines))


def measured(row: Row, seed: int, limit_s: float, bound_share: float, *, peer: str | None) -> str:
    """A line of the table; ``peer`` is the Python that has PyJobShop, None if nobody has."""
    control = Control(time_limit_s=limit_s, seed=seed)
    started = perf_counter()
    schedule = schedule_instance(row.instance, control, bound_share=bound_share)
    seconds = perf_counter() - started
    bound = schedule.certificate.bound
    gap = None if bound is None else abs(schedule.makespan_s - bound) / max(1.0, schedule.makespan_s)
    word = "confirmed" if schedule.certificate.claim == "proven" else "by the solver's word"
    known = (
        f"optimal, {word}: {schedule.certificate.method}"
        if schedule.status == "optimal"
        else schedule.certificate.method
    )
    name = row.name
    if isinstance(row.instance, CoalitionMission) and row.instance.reference_s is not None:
        name += f" (published {row.instance.reference_s:.3f})"
    ours = [
        name,
        _number(schedule.makespan_s),
        _number(bound),
        "-" if gap is None else f"{100 * gap:.2f} %",
        known,
        f"{seconds:.2f}",
    ]
    return (
        f"| {' | '.join([*ours, *(_peer(peer, row.shop, limit_s, seed) if peer and row.shop else ('-', '-', '-'))])} |"
    )


def _number(value: float | None) -> str:
    return "-" if value is None else f"{value:.3f}".rstrip("0").rstrip(".")


def _peer(python: str, file: Path, limit_s: float, seed: int) -> tuple[str, str, str]:
    command = [python, "-m", "benchmarks.peer_pyjobshop", str(file.resolve()), str(limit_s), str(seed)]
    try:
        ran = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, timeout=limit_s + GRACE_S, check=False)
    except subprocess.TimeoutExpired:
        return ("did not stop", "-", "-")
    if ran.returncode:
        return ((ran.stderr.strip().splitlines() or ["failed"])[-1][:60], "-", "-")
    told = json.loads(ran.stdout.splitlines()[-1])
    return (_number(told["value"]), _number(told["bound"]), f"{told['seconds']:.2f}")


def main() -> None:
    """Measure and print the table."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument(
        "--data", type=Path, metavar="DIR", help="folder of instances, looked through with all below it"
    )
    parser.add_argument(
        "--only",
        nargs="+",
        metavar="NAME",
        help="rows by name: of generated ones, chains, or files without their ending",
    )
    parser.add_argument("--limit", type=float, metavar="S", help="seconds for each row (default: each row's own)")
    parser.add_argument("--no-peers", action="store_true", help="ours alone")
    parser.add_argument("--peer-python", metavar="PATH", help="Python that has PyJobShop (default: this one)")
    parser.add_argument(
        "--bound-share", type=float, default=0.0, metavar="S", help="of CP-SAT's time, to raise the bound (default 0)"
    )
    parser.add_argument("--seed", type=int, default=0, help="seed of every search (default 0)")
    given = parser.parse_args()
    here = find_spec("pyjobshop") is not None
    peer = None if given.no_peers else given.peer_python or (sys.executable if here else None)
    print(machine_line("ortools", *(["numba"] if find_spec("numba") else []), *(["pyjobshop"] if here else [])))
    print(f"Seed {given.seed}; limits of {'each row' if given.limit is None else f'{given.limit:g} s'}.\n")
    if can_compile():
        fast_engine()
    schedule_instance(warm(), Control(time_limit_s=30.0))
    print("\n".join(HEAD))
    count = 0
    for row in rows(given.data, set(given.only) if given.only else None):
        count += 1
        limit_s = row.limit_s if given.limit is None else given.limit
        print(measured(row, given.seed, limit_s, given.bound_share, peer=peer), flush=True)
    if not count:
        parser.error("no row of that name; files need --data")


if __name__ == "__main__":
    main()
