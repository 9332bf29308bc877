"""
How long a person waits: whole processes, from typing to the prompt.

usage: python -m benchmarks.startup [--runs 9]
"""

from __future__ import annotations

import argparse
import statistics
import subprocess
import sys
import time

from benchmarks.machine import machine_line

COMMANDS = {
    "missiontree --help": (["--help"], 0.4),
    'missiontree plan "Reunite mom with her lost child"': (["plan", "Reunite mom with her lost child"], 1.0),
    "missiontree plan --sample site": (["plan", "--sample", "site"], 1.0),
    "missiontree plan --sample restaurants": (["plan", "--sample", "restaurants"], 1.0),
}


def seconds(arguments: list[str]) -> float:
    """Wall time of one run of the command."""
    started = time.perf_counter()
    done = subprocess.run([sys.executable, "-m", "missiontree", *arguments], capture_output=True, check=False)
    elapsed = time.perf_counter() - started
    if done.returncode not in {0, 1}:
        raise SystemExit(done.stderr.decode())
    return elapsed


def main() -> None:
    """Measure and print the table."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--runs", type=int, default=9, help="runs of each command after one warm-up (default 9)")
    runs = parser.parse_args().runs
    print(machine_line("pydantic", "typer", "rich"))
    print(f"whole processes, {runs} runs after one warm-up\n")
    print("| command | median s | max s | bar s |\n|---|---|---|---|")
    for name, (arguments, bar) in COMMANDS.items():
        seconds(arguments)
        times = [seconds(arguments) for _ in range(runs)]
        print(f"| `{name}` | {statistics.median(times):.2f} | {max(times):.2f} | {bar} |")


if __name__ == "__main__":
    main()
