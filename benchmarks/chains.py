"""
Seeded chains of tasks for equal robots, as trees in columns.

::

    python -m benchmarks.chains 1200 4 20 0 > chains_1200_4_20_0.json
    python -m benchmarks.chains TASKS TYPES ROBOTS SEED

An AND of chains of 4 to 8 tasks; a task is one action of 1 to 22 s for a robot of a type drawn by chance; there are ROBOTS equal robots
of each of TYPES types. With many robots per type, one no-overlap for each is what a solver drowns in.
"""

from __future__ import annotations

import argparse
import json
import sys
from itertools import pairwise
from random import Random
from typing import Any

from benchmarks.trees import AND, LEAF


def chains(tasks: int, types: int, robots: int, seed: int) -> dict[str, Any]:
    """A tree in its JSON form, as plain data."""
    luck = Random(seed)  # noqa: S311 - luck for instances, not for secrets
    kind, parent, robot, duration = [AND], [-1], [0], [0]
    precedence: list[list[int]] = []
    left = tasks
    while left:
        length = min(left, luck.randint(4, 8))
        chain = len(kind)
        kind.append(AND)
        parent.append(0)
        robot.append(0)
        duration.append(0)
        leaves = range(chain + 1, chain + 1 + length)
        for _ in leaves:
            kind.append(LEAF)
            parent.append(chain)
            robot.append(luck.randrange(types))
            duration.append(luck.randint(1, 22))
        precedence += [list(pair) for pair in pairwise(leaves)]
        left -= length
    return {
        "kind": kind,
        "parent": parent,
        "robot": robot,
        "utility": [0] * len(kind),
        "duration": duration,
        "precedence": precedence,
        "robots": types,
        "count": [robots] * types,
    }


def main() -> None:
    """Write one instance."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    for name in ("tasks", "types", "robots", "seed"):
        parser.add_argument(name, type=int)
    given = parser.parse_args()
    if min(given.tasks, given.types, given.robots) < 1:
        parser.error("there is at least one task, one type and one robot")
    sys.stdout.write(json.dumps(chains(given.tasks, given.types, given.robots, given.seed)))


if __name__ == "__main__":
    main()
