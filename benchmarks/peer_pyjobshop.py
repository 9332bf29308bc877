"""PyJobShop on a flexible job shop. Runs as a process of its own and prints one line of JSON: value, bound, seconds."""

from __future__ import annotations

import json
import sys
from pathlib import Path
from time import perf_counter

from missiontree.formats.importers.fjsp import read_shop
from missiontree.mission.columns import LEAF, XOR


def main() -> None:
    """Solve ``FILE SECONDS SEED``, with 8 workers."""
    from pyjobshop import Model  # noqa: PLC0415 - an optional install, in this process alone

    file, limit_s, seed = sys.argv[1:]
    tree = read_shop(Path(file))
    model = Model()
    machines = [model.add_machine() for _ in range(tree.robots)]
    tasks = {node: model.add_task() for node, kind in enumerate(tree.kind) if kind == XOR}
    for node, kind in enumerate(tree.kind):
        if kind == LEAF:
            model.add_mode(tasks[tree.parent[node]], machines[tree.robot[node]], tree.duration[node])
    for before, after in tree.precedence:
        model.add_end_before_start(tasks[before], tasks[after])
    started = perf_counter()
    result = model.solve(time_limit=float(limit_s), display=False, num_workers=8, random_seed=int(seed))
    found = result.objective if result.best is not None else None
    print(json.dumps({"value": found, "bound": result.lower_bound, "seconds": perf_counter() - started}))


if __name__ == "__main__":
    main()
