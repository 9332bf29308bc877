"""
Robots that visit places: how short the tours get, what is proven of them, and what the routing solver of OR-Tools finds in the time.

::

    python -m benchmarks.tours                                places x robots as in the docs, 20 s for each column
    python -m benchmarks.tours --sizes 12x2 20x1h --limit 5   12 places, 2 robots; 20 places, 1 robot that returns home

Places lie by chance in a square of 100 m, robots start in its middle and go 1 m/s, and a goal (``Reach``) takes 5 s where its robot is
and then the way. Every plan is checked. The peer gets the same milliseconds between places, makes the longest tour as short as it
can (span cost 1,000, guided local search), and proves nothing. Limits are seconds of the clock: nothing else should work beside.
"""

from __future__ import annotations

import argparse
import json
import math
import tempfile
from collections.abc import Sequence
from pathlib import Path
from random import Random
from time import perf_counter
from typing import Any, NamedTuple

from benchmarks.machine import machine_line
from missiontree.briefing import request_from
from missiontree.checking import check
from missiontree.mission.control import Control
from missiontree.planner import plan_request
from missiontree.reporting.known import known_of

SIZES = ("10x1h", "14x2", "20x1h", "20x2h", "30x2", "51x1h", "51x3h", "100x4")
SCHEDULERS = ("greedy", "auto", "cpsat")
HALF_M = 50
FIRST_MS = 5_000
"""What a goal takes before the way, in milliseconds."""


class Size(NamedTuple):
    """Places, robots, and whether they return home."""

    places: int
    robots: int
    home: bool

    @classmethod
    def parse(cls, text: str) -> Size:
        """
        From ``20x2`` or, with the way home, ``20x2h``.

        Raises
        ------
        ArgumentTypeError
            If it is something else, or there is no place or no robot.
        """
        places, _, robots = text.removesuffix("h").partition("x")
        if not (places.isdecimal() and robots.isdecimal() and int(places) and int(robots)):
            raise argparse.ArgumentTypeError(
                f"found {text!r}; places x robots are wanted, such as 20x2, or 20x2h if they return home"
            )
        return cls(int(places), int(robots), text.endswith("h"))


def spots(size: Size, seed: int) -> list[tuple[float, float]]:
    """Where the places are, in metres; the start is at 0, 0."""
    luck = Random(f"{seed} {size.places}")  # noqa: S311 - luck for instances, not for secrets
    return [
        (round(luck.uniform(-HALF_M, HALF_M), 1), round(luck.uniform(-HALF_M, HALF_M), 1)) for _ in range(size.places)
    ]


def write_mission(folder: Path, size: Size, seed: int) -> Path:
    """The mission with its fleet and scene as files; the mission's file."""
    things: list[dict[str, Any]] = [
        {"id": f"p{number}", "kind": "object", "position": {"x_m": x, "y_m": y}}
        for number, (x, y) in enumerate(spots(size, seed))
    ]
    rover = {
        "id": "rover",
        "count": size.robots,
        "place": "start",
        "capabilities": {"reach": 1.0},
        "limits": {"max_speed_mps": 1.0},
    }
    files: dict[str, dict[str, Any]] = {
        "fleet": {"format": "fleet/1", "types": [rover]},
        "scene": {
            "format": "scene/1",
            "places": [{"id": "start", "position": {"x_m": 0.0, "y_m": 0.0}}],
            "entities": things,
        },
        "mission": {
            "format": "mission/1",
            "mission": f"{size.places} places",
            "fleet": "fleet.json",
            "scene": "scene.json",
            "return_home": size.home,
            "goals": [{"do": f"Reach({thing['id']})"} for thing in things],
        },
    }
    for name, data in files.items():
        (folder / f"{name}.json").write_text(json.dumps(data), encoding="utf-8")
    return folder / "mission.json"


def routed(size: Size, seed: int, limit_s: float) -> float:
    """The longest tour that the routing solver comes to, in seconds."""
    from ortools.constraint_solver import pywrapcp, routing_enums_pb2  # noqa: PLC0415 - heavy, and the peer's alone

    where = [(0.0, 0.0), *spots(size, seed)]
    ways = [
        [_ms(one, other) + FIRST_MS if number else _ms(one, other) for number, other in enumerate(where)]
        for one in where
    ]
    if not size.home:
        for way in ways:
            way[0] = 0
    manager = pywrapcp.RoutingIndexManager(len(where), size.robots, 0)
    routing = pywrapcp.RoutingModel(manager)
    transit = routing.RegisterTransitMatrix(ways)
    routing.SetArcCostEvaluatorOfAllVehicles(transit)
    routing.AddDimension(transit, 0, 10**9, True, "time")
    time = routing.GetDimensionOrDie("time")
    time.SetGlobalSpanCostCoefficient(1_000)
    parameters = pywrapcp.DefaultRoutingSearchParameters()
    parameters.local_search_metaheuristic = routing_enums_pb2.LocalSearchMetaheuristic.GUIDED_LOCAL_SEARCH
    parameters.time_limit.FromMilliseconds(round(1000 * limit_s))
    found = routing.SolveWithParameters(parameters)
    ends: list[int] = [found.Value(time.CumulVar(routing.End(robot))) for robot in range(size.robots)]
    return max(ends) / 1000


def _ms(one: tuple[float, float], other: tuple[float, float]) -> int:
    return math.ceil(math.dist(one, other) * 1000 - 1e-6)


def row(size: Size, seed: int, limit_s: float, schedulers: Sequence[str]) -> str:
    """A line of the table."""
    cells = [f"{size.places}", f"{size.robots}{', home' if size.home else ''}"]
    with tempfile.TemporaryDirectory() as folder:
        file = write_mission(Path(folder), size, seed)
        for name in schedulers:
            begun = perf_counter()
            plan = plan_request(
                request_from(file, scheduler=name, k=1, seed=seed), Control(time_limit_s=limit_s, seed=seed)
            )
            if check(plan):
                raise SystemExit(f"the checker refuses a plan by {name}")
            cells += [f"{plan.schedules[0].makespan_s:.1f}", f"{perf_counter() - begun:.1f}"]
        known = known_of(plan.schedules[0])
    return f"| {' | '.join([*cells, known, f'{routed(size, seed, limit_s):.1f}'])} |"


def main() -> None:
    """Print the table."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--sizes", nargs="+", type=Size.parse, default=[Size.parse(text) for text in SIZES])
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--limit", type=float, default=20.0, metavar="S", help="seconds for each column (default 20)")
    parser.add_argument("--schedulers", nargs="+", choices=SCHEDULERS, default=list(SCHEDULERS))
    given = parser.parse_args()
    print(machine_line("ortools"))
    print(f"\nMakespans in seconds; {given.limit:g} s each, seed {given.seed}.\n")
    head = ["places", "robots", *(column for name in given.schedulers for column in (name, "seconds"))]
    print(f"| {' | '.join([*head, 'known of the last', 'OR-Tools routing'])} |")
    print("|---" * (len(head) + 2) + "|")
    for size in given.sizes:
        print(row(size, given.seed, given.limit, given.schedulers), flush=True)


if __name__ == "__main__":
    main()
