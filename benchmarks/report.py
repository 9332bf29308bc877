"""
How large a report is, how long it takes to be made, and how long a browser takes to open it.

usage: python -m benchmarks.report [--nodes 500] [--runs 7] [--browser /usr/bin/chromium]

The large mission has that many nodes in its mission tree, a scene with roads, and 24 robots of 8 types. A browser opens the file from
disk, each time in a context of its own: first contentful paint, and the load event after which the script has run.
"""

from __future__ import annotations

import argparse
import shutil
import statistics
import tempfile
import time
from pathlib import Path

from benchmarks.machine import machine_line
from missiontree import plan
from missiontree.formats.document import write_text
from missiontree.mission.entity import Entity
from missiontree.mission.fleet import Fleet, RobotType
from missiontree.mission.plan import Plan
from missiontree.mission.position import Position
from missiontree.mission.scene import Scene
from missiontree.mission.tree import Link, MissionNode, MissionTree
from missiontree.mission.ways import Road, RoadGraph
from missiontree.reporting.html.report import report_html
from missiontree.samples.catalogue import SAMPLES, sample_file

PER_TASK = 9
BAR_KB, BAR_MS = 400, 1000
PAINTED = "performance.getEntriesByName('first-contentful-paint').length > 0"
TIMES = """() => {
  const [page] = performance.getEntriesByType("navigation");
  const [paint] = performance.getEntriesByName("first-contentful-paint");
  return [paint.startTime, page.loadEventEnd, document.getElementsByTagName("*").length];
}"""


def large_plan(nodes: int) -> Plan:
    """A plan for a mission tree of so many nodes: tasks of nine routines each, some of which wait for others."""
    tasks: list[MissionNode] = []
    leaves: list[MissionNode] = []
    links: list[Link] = []
    things: list[Entity] = []
    while 1 + len(tasks) + len(leaves) < nodes:
        number = len(tasks) + 1
        room = min(PER_TASK, nodes - 2 - len(tasks) - len(leaves))
        own = [_leaf(number, place) for place in range(room)]
        things += [_thing(number, place) for place in range(room)]
        tasks.append(
            MissionNode(
                id=f"task{number}",
                label=f"Clear section {number}",
                gate="and" if own else None,
                children=tuple(leaf.id for leaf in own),
            )
        )
        leaves += own
        links += [Link(first.id, second.id) for first, second in zip(own[:1], own[2:3], strict=False)]
        if number % 4 == 0:
            links.append(Link(f"task{number - 1}", f"task{number}"))
    root = MissionNode(id="root", label="Clear the yard", gate="and", children=tuple(task.id for task in tasks))
    of_task = {task.id: [leaf for leaf in leaves if leaf.id in task.children] for task in tasks}
    ordered = [node for task in tasks for node in (task, *of_task[task.id])]
    tree = MissionTree(objective="Clear the yard", nodes=(root, *ordered), links=tuple(links))
    with tempfile.TemporaryDirectory() as folder:
        for kind, value in (("tree", tree), ("scene", _scene(things)), ("fleet", _fleet())):
            Path(folder, f"{kind}.json").write_text(write_text(value, kind), encoding="utf-8")
        mission = Path(folder, "mission.yaml")
        mission.write_text(
            "format: mission/1\nmission: Clear the yard\ntree: tree.json\nfleet: fleet.json\nscene: scene.json\n"
        )
        return plan(mission)


def _leaf(task: int, place: int) -> MissionNode:
    thing = f"crate{task}_{place}"
    routine, arguments = (
        ("Search", {"agent": thing}),
        ("Reach", {"agent": thing}),
        ("ReachAndTransport", {"agent": thing, "location": f"bay{task % 6}"}),
    )[place % 3]
    label = f"{routine}({', '.join(arguments.values())})"
    return MissionNode(id=f"do{task}_{place}", label=label, routine=routine, arguments=arguments)


def _thing(task: int, place: int) -> Entity:
    spot = Position(float(task * 37 % 200), float((task * 53 + place * 17) % 120))
    return Entity(id=f"crate{task}_{place}", position=spot, mass_kg=5.0 + place)


def _scene(things: list[Entity]) -> Scene:
    bays = tuple(
        Entity(id=f"bay{number}", position=Position(40.0 * number, 60.0 * (number % 2))) for number in range(6)
    )
    roads = tuple(Road(ends=(f"bay{number}", f"bay{(number + 1) % 6}")) for number in range(6))
    return Scene(places=bays, entities=tuple(things), roads=RoadGraph(roads=roads))


def _fleet() -> Fleet:
    types = []
    for number in range(8):
        abilities = {"search": 0.5 + 0.05 * number, "reach": 0.6, "carry": 0.9 - 0.05 * number}
        limits = {"max_speed_mps": 1.0 + 0.1 * number, "payload_kg": 20.0, "energy_j": 1e9}
        types.append(
            RobotType(
                id=f"type{number}",
                label=f"Type {number}",
                capabilities=abilities,
                limits=limits,
                uses_per_m={"energy_j": 50.0},
                count=3,
                place=f"bay{number % 6}",
            )
        )
    return Fleet(tuple(types))


def opened(file: Path, browser: str, runs: int) -> tuple[float, float, int]:
    """Median milliseconds to the first contentful paint and to the end of the load event, and how many elements the page has."""
    from playwright.sync_api import sync_playwright  # noqa: PLC0415 - only this measurement needs it

    found = []
    with sync_playwright() as driver:
        chromium = driver.chromium.launch(executable_path=browser, args=["--no-sandbox"])
        for _ in range(runs + 1):  # the first one warms the browser up
            context = chromium.new_context(viewport={"width": 1400, "height": 900})
            page = context.new_page()
            page.goto(file.as_uri(), wait_until="load")
            page.wait_for_function(PAINTED)  # the paint is reported a little later
            found.append(page.evaluate(TIMES))
            context.close()
        chromium.close()
    paint, load, elements = zip(*found[1:], strict=True)
    return statistics.median(paint), statistics.median(load), int(elements[0])


def main() -> None:
    """Measure and print the table."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--nodes", type=int, default=500, help="nodes of the large mission tree (default 500)")
    parser.add_argument(
        "--runs", type=int, default=7, help="times that each file is opened after one warm-up (default 7)"
    )
    parser.add_argument("--browser", default=shutil.which("chromium") or "chromium", help="Chromium to open it with")
    parser.add_argument("--keep", type=Path, help="folder in which the reports are kept")
    options = parser.parse_args()
    print(machine_line("jinja2", "playwright"))
    print(
        f"each file opened {options.runs} times after one warm-up; bars: {BAR_KB} kB for a sample, {BAR_MS} ms for the large one\n"
    )
    print("| mission | nodes | kB | made in s | elements | first paint ms | loaded ms |\n|---|---|---|---|---|---|---|")
    with tempfile.TemporaryDirectory() as scratch:
        folder = options.keep or Path(scratch)
        plans = {name: plan(sample_file(name)) for name in SAMPLES} | {"large": large_plan(options.nodes)}
        for name, made in plans.items():
            started = time.perf_counter()
            html = report_html(made)
            took = time.perf_counter() - started
            file = folder / f"{name}.html"
            file.write_text(html, encoding="utf-8")
            paint, load, elements = opened(file, options.browser, options.runs)
            nodes = len(made.tree.nodes) if made.tree is not None else 0
            size = len(html.encode()) / 1000
            print(f"| {name} | {nodes} | {size:.0f} | {took:.2f} | {elements:,} | {paint:.0f} | {load:.0f} |")


if __name__ == "__main__":
    main()
