"""Families of small scheduling instances."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from hypothesis import strategies as st

from missiontree.mission.fleet import Fleet, Robot
from missiontree.mission.scene import Scene
from tests.scheduling.instances import Group, Instance, Part, at, mission, move, robots, scene, work

PLACES = ("p", "q", "r", "lost")
THINGS = ("box", "cat")


@st.composite
def fleets(draw: st.DrawFn, budgets: bool = False) -> Fleet:
    """Types ``a`` (one or two robots) and ``b`` (one, or two that stand apart); speeds and starts may be unknown."""
    positions = st.one_of(st.none(), st.integers(-4, 4).map(at))
    speeds = st.sampled_from([None, 1.0, 2.0, 3.0])
    more: dict[str, Any] = {}
    if budgets:
        more = {"uses_per_m": {"energy_j": 1.0}, "limits": {"energy_j": draw(st.integers(5, 60))}}
    a = robots("a", draw(st.integers(1, 2)), draw(speeds), position=draw(positions), **more)
    two = tuple(Robot(id=f"b{n}", position=draw(positions)) for n in range(draw(st.integers(1, 2))))
    return Fleet((a, robots("b", speed=draw(speeds), robots=two, total_limits={"coins": 4.0} if budgets else {})))


@st.composite
def actions(draw: st.DrawFn, things: bool) -> dict[str, Any]:
    """Work anywhere or somewhere, or a move, which may bring a thing."""
    places = PLACES + THINGS if things else PLACES
    where = draw(st.one_of(st.none(), st.sampled_from(places)))
    duration = draw(st.integers(1, 5))
    uses = {"energy_j": 2.0, "coins": 1.0} if things and draw(st.booleans()) else {}
    if where in PLACES and draw(st.booleans()):
        brought = draw(st.lists(st.sampled_from(THINGS), max_size=1)) if things else []
        return move(where, *brought, nominal_s=duration, uses=uses)
    return work(duration, at=where, uses=uses)


@st.composite
def instances(draw: st.DrawFn, max_parts: int = 4, things: bool = False) -> Instance:
    """Up to ``max_parts`` roles in nested groups with all kinds of links; many contradict themselves."""
    count = draw(st.integers(1, max_parts))
    parts: list[Part | Group] = []
    syncs = draw(st.lists(st.integers(0, count - 1), max_size=3)) if count > 1 else []
    for number in range(count):
        steps = draw(st.lists(actions(things), min_size=1, max_size=3))
        if number in syncs and not any("sync" in step for step in steps):
            steps[draw(st.integers(0, len(steps) - 1))]["sync"] = 0
        elif draw(st.integers(0, 5)) == 0 and not steps[-1].get("moves"):
            steps[-1]["open_ended"] = True
        team = draw(st.sampled_from([None, None, 0]))
        parts.append(Part(f"P{number}", draw(st.sampled_from("ab")), steps, team))
    names = [part.name for part in parts]
    if count > 2 and draw(st.booleans()):
        inner = Group("G", parts[:2], draw(st.sampled_from(["and", "and", "xor"])))
        parts, names = [inner, *parts[2:]], [*names, "G"]
    names += [f"{part.name}.0" for part in parts if isinstance(part, Part)]
    pairs = [
        (a, b)
        for a in names
        for b in names
        if a.split(".")[0] != b.split(".")[0] and not ({a[:2], b[:2]} & {"P0", "P1"} and "G" in {a, b})
    ]
    kinds = st.sampled_from(["precedence"] * 4 + ["same_robot", "different_robot", "until"])
    links = draw(st.lists(st.tuples(st.sampled_from(pairs), kinds), max_size=4)) if pairs else []
    return mission(parts, [(first, second, kind) for (first, second), kind in links])


def plane() -> Scene:
    """Three places, one that is lost, and two things, one of which can only be led slowly."""
    return scene({"cat": 0.5}, p=0, q=3, r=7, lost=None, box=2, cat=5)


@st.composite
def timed(draw: st.DrawFn, made: Instance) -> Instance:
    """An instance with times at up to three nodes, tight and loose ones."""
    names = draw(st.lists(st.sampled_from(sorted(made.node)), min_size=1, max_size=3, unique=True))
    times: dict[str, tuple[float, float | None]] = {}
    for name in names:
        release = draw(st.sampled_from([0, 0, 0, 2, 5, 7.5]))
        span = draw(st.sampled_from([None, 4, 6, 8, 10, 12, 15, 20]))
        times[name.replace(".", "_")] = release, None if span is None else release + span
    return made.timed(**times)


@st.composite
def shifts(draw: st.DrawFn, fleet: Fleet) -> Fleet:
    """A fleet of which types or robots come late or leave early."""
    since, until = st.sampled_from([None, None, 0, 2, 6.5]), st.sampled_from([None, 7, 9, 12, 20])
    types = [
        replace(
            kind,
            available_from_s=draw(since),
            available_until_s=draw(until),
            robots=tuple(
                replace(robot, available_from_s=draw(since), available_until_s=draw(until)) for robot in kind.robots
            ),
        )
        for kind in fleet.types
    ]
    return replace(fleet, types=tuple(types))
