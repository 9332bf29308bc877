"""
How well trees are ranked: ours beside CP-SAT and HiGHS, on the same instances, in the same run, on the same machine.

::

    python -m benchmarks.allocation                                     everything; hours
    python -m benchmarks.allocation --only mission-300 million          some rows
    python -m benchmarks.allocation --data FOLDER --limit 60            trees of a folder instead of generated ones
    python -m benchmarks.allocation --only growth --plot growth.svg     cost as the work grows, as a picture

``exact``, ``arrays`` (the same for bare trees that nothing couples, compiled) and ``pruned`` (Algorithm 1 of the paper) are ours.
``cp_sat`` has 8 workers and is asked again with a no-good for every alternative it has named; ``highs`` likewise with a cut. Peers are
optional: ``pip install missiontree[bench]``. Each runs in a process of its own. Seconds run from arrays to the certified list, in a
process that has loaded everything. A gap is |bound - best| over max(1, |best|). A row ends with exit code 1 if two contenders prove
different lists.

Trees are those of :mod:`benchmarks.trees`. A folder's file named ``FAMILY_LEAVES_ROBOTS_SEED.json`` takes the place of the generated
one; files of other names make rows of their own.
"""

from __future__ import annotations

import argparse
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from importlib.util import find_spec
from pathlib import Path
from statistics import mean, median
from tempfile import TemporaryDirectory

from benchmarks.contenders import PEERS, Question, answer_of, installed
from benchmarks.growth import LIMIT_S as GROWTH_LIMIT_S
from benchmarks.growth import grown, growth_table
from benchmarks.growth_plot import growth_svg
from benchmarks.machine import machine_line
from benchmarks.million import million_table
from benchmarks.peer_model import Answer
from benchmarks.trees import instance, text_of

Named = tuple[str, int, int, int]
TINY = 1e-6
COMPILERS = ("numba",)
"""What makes ours quicker where it is installed."""


@dataclass(frozen=True, slots=True)
class Row:
    """
    A line of work.

    Parameters
    ----------
    name
        What ``--only`` calls it.
    instances
        Family, leaves, robots and seed of each, or a file.
    k
        How many alternatives.
    budgets
        Whether budgets limit the robots.
    limit_s
        Seconds for each contender and instance.
    contenders
        Who takes part.
    """

    name: str
    instances: tuple[Named | Path, ...]
    k: int = 10
    budgets: bool = True
    limit_s: float = 60.0
    contenders: tuple[str, ...] = ("exact", "pruned", "cp_sat", "highs")


LARGE: tuple[Named, ...] = (("mission", 100_000, 1_000, 0),)
UNIFORM: tuple[Named, ...] = (("uniform", 100_000, 1_000, 0),)
ROWS = (
    Row("free-100000", LARGE, budgets=False, contenders=("exact", "arrays", "pruned")),
    Row("free-uniform-100000", UNIFORM, budgets=False, contenders=("exact", "arrays", "pruned")),
    Row("mission-300", tuple(("mission", 300, 6, seed) for seed in range(10))),
    Row("mission-1000", tuple(("mission", 1_000, 8, seed) for seed in range(10))),
    Row("mission-10000", (("mission", 10_000, 8, 0),)),
    Row("mission-100000-10s", LARGE, k=1, limit_s=10.0),
    Row("mission-100000-60s", LARGE, k=1, limit_s=60.0),
)
OTHERS = ("million", "growth")
HEAD = (
    "| work | contender | instances | proven | with a list | mean s | median s | worst s | best value | bound | worst gap |",
    "|---|---|---|---|---|---|---|---|---|---|---|",
)


def main() -> None:
    """Measure and print the tables."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    names = [row.name for row in ROWS] + list(OTHERS)
    parser.add_argument("--data", type=Path, metavar="DIR", help="folder of trees (default: generated ones)")
    parser.add_argument("--only", nargs="+", metavar="NAME", help=f"some of: {', '.join(names)}, and rows of --data")
    parser.add_argument("--limit", type=float, metavar="S", help="seconds for each contender and instance")
    parser.add_argument("--no-peers", action="store_true", help="ours alone")
    parser.add_argument("--seed", type=int, default=0, help="seed of every search (default 0)")
    parser.add_argument("--plot", type=Path, metavar="FILE", help="draw how cost grows into this .svg file")
    given = parser.parse_args()
    rows = rows_of(given.data)
    known = {row.name for row in rows} | set(OTHERS)
    wanted = set(given.only or known)
    if unknown := wanted - known:
        parser.error(f"there is no row {', '.join(sorted(unknown))}; there are {', '.join(sorted(known))}")
    took_part = [package for name, package in PEERS.items() if not given.no_peers and installed(name)]
    took_part += [package for package in COMPILERS if find_spec(package) is not None]
    print(machine_line(*took_part))
    print(f"Seed {given.seed}; limits of {'each row' if given.limit is None else f'{given.limit:g} s'}.\n")
    agree = True
    with TemporaryDirectory() as folder:
        files = Files(given.data, Path(folder))
        if chosen := [row for row in rows if row.name in wanted]:
            print("\n".join(HEAD))
        for row in chosen:
            limited = row if given.limit is None else replace(row, limit_s=given.limit)
            agree &= _measured(limited, files, given.seed, peers=not given.no_peers)
        if "million" in wanted:
            print("\n" + million_table(files.file(("mission", 650_000, 1_000, 0))))
        if "growth" in wanted:
            points = grown(files.file, GROWTH_LIMIT_S if given.limit is None else given.limit, given.seed)
            print("\n" + growth_table(points))
            if given.plot is not None:
                given.plot.write_text(growth_svg(points), encoding="utf-8")
    if not agree:
        raise SystemExit(1)


def rows_of(data: Path | None) -> tuple[Row, ...]:
    """The rows, and one more for every file of the folder that no row names."""
    if data is None:
        return ROWS
    used = {name_of(named) for row in ROWS for named in row.instances}
    more = sorted(file for file in data.glob("*.json") if file.name not in used)
    return (*ROWS, *(Row(file.stem, (file,)) for file in more))


def name_of(named: Named | Path) -> str:
    """Name of the file of an instance."""
    return named.name if isinstance(named, Path) else "_".join(map(str, named)) + ".json"


@dataclass(frozen=True, slots=True)
class Files:
    """
    Where the instances are.

    Parameters
    ----------
    data
        A folder that is looked into first; None if there is none.
    made
        A folder to write generated ones into.
    """

    data: Path | None
    made: Path

    def file(self, named: Named | Path) -> Path:
        """The file of an instance, generated if need be."""
        if isinstance(named, Path):
            return named
        if self.data is not None and (given := self.data / name_of(named)).exists():
            return given
        file = self.made / name_of(named)
        if not file.exists():
            file.write_text(text_of(instance(*named)), encoding="utf-8")
        return file


def _measured(row: Row, files: Files, seed: int, *, peers: bool) -> bool:
    """Print the lines of a row; whether all who prove a list prove the same."""
    answers: dict[str, list[Answer]] = {}
    for name in row.contenders:
        if name in PEERS and not peers:
            continue
        if not installed(name):
            print(f"| {row.name} | {name} | not installed |", flush=True)
            continue
        asked = (Question(files.file(named), row.k, row.budgets, row.limit_s, seed) for named in row.instances)
        answers[name] = [answer_of(name, question) for question in asked]
        print(line(row.name, name, answers[name]), flush=True)
    disagreeing = list(disagreements(row, answers))
    print("\n".join(disagreeing) + "\n" if disagreeing else "", end="")
    return not disagreeing


def disagreements(row: Row, answers: dict[str, list[Answer]]) -> Iterator[str]:
    """Instances of which two contenders prove different values."""
    for place, named in enumerate(row.instances):
        proven = {name: given[place].values for name, given in answers.items() if given[place].proven}
        if any(not same(values, other) for values in proven.values() for other in proven.values()):
            yield f"DIFFERENT PROOFS for {name_of(named)}: {proven}"


def same(values: Sequence[float], other: Sequence[float]) -> bool:
    """Whether two lists of utilities are equal but for rounding."""
    return len(values) == len(other) and all(
        abs(a - b) <= TINY * max(1.0, abs(a)) for a, b in zip(values, other, strict=True)
    )


def gap(answer: Answer) -> float | None:
    """Of the best value; None if there is no value or no bound."""
    if not answer.values or answer.bound is None:
        return None
    return abs(answer.bound - answer.values[0]) / max(1.0, abs(answer.values[0]))


def line(work: str, name: str, answers: Sequence[Answer]) -> str:
    """A contender's line of a row; values and bounds are means over the instances that have them."""
    seconds = [answer.seconds for answer in answers]
    best = [answer.values[0] for answer in answers if answer.values]
    bounds = [answer.bound for answer in answers if answer.bound is not None]
    gaps = [known for answer in answers if (known := gap(answer)) is not None]
    cells = [
        work,
        name,
        str(len(answers)),
        str(sum(answer.proven for answer in answers)),
        str(len(best)),
        *(f"{statistic(seconds):.3f}" for statistic in (mean, median, max)),
        f"{mean(best):.1f}" if best else "-",
        f"{mean(bounds):.1f}" if bounds else "-",
        f"{100 * max(gaps):.3f} %" if gaps else "-",
    ]
    notes = sorted({answer.note for answer in answers if answer.note})
    return f"| {' | '.join(cells)} |" + "".join(f" {note}" for note in notes)


if __name__ == "__main__":
    main()
