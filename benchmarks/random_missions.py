"""
Seeded missions with a scene, of any size, as files.

::

    python -m benchmarks.random_missions GOALS ROBOTS SEED FOLDER && missiontree plan FOLDER/mission.json

On a square are things, places, and robots of three types. Goals, stated formally, bring things to places, look at things or search for
them; some wait for others. Streets are straight lines.
"""

from __future__ import annotations

import argparse
import json
from pathlib import Path
from random import Random
from typing import Any

PLACES = 12
SIDE_M = 120


def write_mission(folder: Path, goals: int, robots: int, seed: int) -> Path:
    """Write a mission, its fleet and its scene into a folder; the mission's file."""
    folder.mkdir(parents=True, exist_ok=True)
    for name, data in random_mission(goals, robots, seed).items():
        (folder / f"{name}.json").write_text(json.dumps(data), encoding="utf-8")
    return folder / "mission.json"


def random_mission(goals: int, robots: int, seed: int) -> dict[str, dict[str, Any]]:
    """The three files as plain data, by name."""
    luck = Random(seed)  # noqa: S311 - luck for instances, not for secrets

    def spot() -> dict[str, float]:
        return {"x_m": float(luck.randint(0, SIDE_M)), "y_m": float(luck.randint(0, SIDE_M))}

    places = [{"id": f"place{number}", "label": f"place {number}", "position": spot()} for number in range(PLACES)]
    things = [
        {"id": f"thing{number}", "kind": "object", "label": f"thing {number}", "position": spot()}
        for number in range(goals)
    ]
    stated: list[dict[str, Any]] = []
    for number in range(goals):
        kind = luck.choice(("carry", "carry", "carry", "reach", "search"))
        words = {
            "carry": f"ReachAndTransport(thing{number}, place{luck.randrange(PLACES)})",
            "reach": f"Reach(thing{number})",
            "search": f"Search(thing{number})",
        }[kind]
        goal: dict[str, Any] = {"do": words, "name": f"g{number}"}
        if number and luck.random() < 0.3:
            goal["after"] = [f"g{luck.randrange(number)}"]
        stated.append(goal)
    carriers, couriers = max(1, robots // 2), max(1, robots // 3)
    types = [
        _type("carrier", carriers, {"reach": 0.8, "carry": 1.0}, 1.0, luck),
        _type("courier", couriers, {"reach": 1.0, "carry": 0.9}, 2.0, luck),
        _type("scout", max(1, robots - carriers - couriers), {"search": 1.0, "reach": 0.7}, 3.0, luck),
    ]
    mission = {
        "format": "mission/1",
        "mission": f"{goals} goals by chance, seed {seed}",
        "fleet": "fleet.json",
        "scene": "scene.json",
        "goals": stated,
    }
    fleet = {"format": "fleet/1", "label": "by chance", "types": types}
    scene = {"format": "scene/1", "label": "a square", "places": places, "entities": things}
    return {"mission": mission, "fleet": fleet, "scene": scene}


def _type(name: str, count: int, can: dict[str, float], speed_mps: float, luck: Random) -> dict[str, Any]:
    place = f"place{luck.randrange(PLACES)}"
    return {"id": name, "count": count, "place": place, "capabilities": can, "limits": {"max_speed_mps": speed_mps}}


def main() -> None:
    """Write one."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    for name in ("goals", "robots", "seed"):
        parser.add_argument(name, type=int)
    parser.add_argument("folder", type=Path)
    given = parser.parse_args()
    if given.goals < 1 or given.robots < 3:
        parser.error("there is at least one goal, and there are three robots")
    write_mission(given.folder, given.goals, given.robots, given.seed)


if __name__ == "__main__":
    main()
