"""A million nodes through the door: what ``missiontree rank`` takes to load, rank and report, in time and memory."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path
from time import perf_counter
from typing import Any

WITHOUT, WITH = ("--no-budgets",), ("--time-limit", "2")


@dataclass(frozen=True, slots=True)
class Ran:
    """
    One run of the command.

    Parameters
    ----------
    seconds
        From its start to its end, the start of Python included.
    peak_mb
        The most memory it held.
    told
        What it printed, as data.
    """

    seconds: float
    peak_mb: float
    told: dict[str, Any]


def ran(*arguments: str) -> Ran:
    """
    Run the command.

    Raises
    ------
    RuntimeError
        If it does not deliver.
    """
    started = perf_counter()
    with subprocess.Popen(
        [sys.executable, "-m", "missiontree", "rank", *arguments, "--json"], stdout=subprocess.PIPE
    ) as process:
        assert process.stdout is not None
        out = process.stdout.read()
        _, status, used = os.wait4(process.pid, 0)  # unlike wait, tells what this one process held
        process.returncode = os.waitstatus_to_exitcode(status)
    seconds = perf_counter() - started
    if process.returncode:
        raise RuntimeError(f"missiontree rank ended with {process.returncode}")
    return Ran(seconds, used.ru_maxrss / 1024, json.loads(out))


def million_table(file: Path) -> str:
    """Both runs as a Markdown table."""
    lines = [
        "| nodes | robots | options | status | listed | best value | worst gap | s, all in all | s, ranking | peak MB |",
        "|---|---|---|---|---|---|---|---|---|---|",
    ]
    for options in (WITHOUT, WITH):
        one = ran(str(file), "--k", "10", *options)
        found = one.told["alternatives"]
        gaps = [alternative["gap"] for alternative in found if alternative["gap"] is not None]
        cells = [
            f"{one.told['nodes']:,}",
            str(one.told["robots"]),
            " ".join(options),
            one.told["status"],
            str(len(found)),
            f"{found[0]['utility']:.0f}" if found else "-",
            f"{100 * max(gaps):.3f} %" if gaps else "-",
            f"{one.seconds:.1f}",
            f"{one.told['time_s']:.1f}",
            f"{one.peak_mb:.0f}",
        ]
        lines.append(f"| {' | '.join(cells)} |")
    return "\n".join(lines)
