"""Plans round schedules written by hand or drawn at random, and Gantt charts taken apart again."""

from __future__ import annotations

import re
from dataclasses import replace
from typing import NamedTuple
from xml.etree import ElementTree

from hypothesis import strategies as st

from missiontree.mission.alternative import Ranking
from missiontree.mission.brief import MissionBrief
from missiontree.mission.certificate import Certificate
from missiontree.mission.control import Control
from missiontree.mission.fleet import Fleet
from missiontree.mission.grounded import Grounding
from missiontree.mission.plan import Plan, Provenance
from missiontree.mission.scene import Scene
from missiontree.mission.schedule import Schedule
from missiontree.mission.terms import NO_TERMS, Terms
from missiontree.reporting.text_box import text_width
from missiontree.routines.library import built_in
from missiontree.scheduling.greedy import greedy
from tests.scheduling.instances import Instance
from tests.scheduling.strategies import fleets, instances, plane

SVG = "{http://www.w3.org/2000/svg}"
TEXTS = (
    "Go",
    "Report detection of the lost child to the server",
    "Get to the far end of the long corridor",
    "母を見つける",
    "Donaudampfschifffahrtsgesellschaftskapitänspatent",
)


def plan_of(instance: Instance, schedule: Schedule, fleet: Fleet, words: str = "Test the chart") -> Plan:
    """A delivered plan with one alternative and its schedule."""
    return Plan(
        outcome="delivered",
        brief=MissionBrief(text=words, fleet=fleet, routines=built_in()),
        grounding=Grounding(tree=instance.tree),
        ranking=Ranking(
            alternatives=(instance.alternative,),
            status="partial",
            certificate=Certificate(claim="unproven", method="by_hand"),
        ),
        schedules=(schedule,),
        provenance=Provenance(author="given"),
    )


def planned(instance: Instance, fleet: Fleet, world: Scene | None = None, terms: Terms = NO_TERMS) -> Plan:
    """A plan with the greedy schedule of an instance."""
    schedule = greedy(instance.tree, instance.alternative, fleet, world or Scene(), Control(seed=1), terms)
    return plan_of(instance, schedule, fleet)


def worded(instance: Instance, texts: list[str]) -> Instance:
    """The instance with other words on its actions, in turn."""
    nodes = [
        node if node.action is None else replace(node, action=replace(node.action, text=texts[index % len(texts)]))
        for index, node in enumerate(instance.tree.nodes)
    ]
    return Instance(replace(instance.tree, nodes=tuple(nodes)), instance.alternative, instance.node)


@st.composite
def plans(draw: st.DrawFn, max_parts: int = 5) -> Plan:
    """Plans of small missions, most of them with a schedule; some with long words."""
    things = draw(st.booleans())
    instance = draw(instances(max_parts=max_parts, things=things))
    instance = worded(instance, draw(st.lists(st.sampled_from(TEXTS), min_size=1, max_size=4)))
    return planned(instance, draw(fleets()), plane())


class Words(NamedTuple):
    """A line of words and the room that it takes."""

    left: float
    top: float
    right: float
    bottom: float
    text: str


def parsed(svg: str) -> ElementTree.Element:
    """The picture, by a parser that forgives nothing."""
    return ElementTree.fromstring(svg)  # noqa: S314 - it is our own


def words_in(root: ElementTree.Element) -> list[Words]:
    """All words of a picture, from left to right; heights are those of capitals and descenders."""
    found = []
    for element in root.iter(f"{SVG}text"):
        size = float(element.get("font-size", ""))
        width = text_width(element.text or "", size) * (1.08 if element.get("font-weight") else 1.0)
        x, y = float(element.get("x", "")), float(element.get("y", ""))
        left = x - width * {"start": 0.0, "middle": 0.5, "end": 1.0}[element.get("text-anchor", "start")]
        found.append(Words(left, y - 0.75 * size, left + width, y + 0.22 * size, element.text or ""))
    return sorted(found)


def clashes(root: ElementTree.Element) -> list[str]:
    """Words that leave the picture, or stand on other words; half a pixel is forgiven, since numbers are rounded."""
    wide, high = (float(root.get(side, "")) for side in ("width", "height"))
    found, faults = words_in(root), []
    for index, one in enumerate(found):
        if one.left < -0.5 or one.top < -0.5 or one.right > wide + 0.5 or one.bottom > high + 0.5:
            faults.append(f"{one.text!r} leaves the picture")
        for other in found[index + 1 :]:
            if other.left >= one.right - 0.5:
                break
            if min(one.bottom, other.bottom) - max(one.top, other.top) > 0.5:
                faults.append(f"{one.text!r} stands on {other.text!r}")
    return faults


class Span(NamedTuple):
    """Left, right, top and bottom of a bar."""

    left: float
    right: float
    top: float
    bottom: float


def bars_in(root: ElementTree.Element) -> dict[int, Span]:
    """Bars of actions by leaf."""
    found = {}
    for rect in root.iter(f"{SVG}rect"):
        if (leaf := rect.get("data-leaf")) is not None:
            x, y, width, height = (float(rect.get(name, "")) for name in ("x", "y", "width", "height"))
            found[int(leaf)] = Span(x, x + width, y, y + height)
    return found


def axis_of(root: ElementTree.Element) -> tuple[float, float]:
    """Where time 0 and the makespan stand: the first hairline, and the line that ends with it."""
    upright = re.compile(r"M([\d.]+) ([\d.]+) V([\d.]+)")
    lines = [
        (found, path.get("class"))
        for path in root.iter(f"{SVG}path")
        if (found := upright.fullmatch(path.get("d") or ""))
    ]
    start = next(found for found, kind in lines if kind == "mt-hair")
    end = next(found for found, kind in lines if kind == "mt-line" and found[2] == start[2])
    return float(start[1]), float(end[1])


def titles_in(root: ElementTree.Element) -> list[str]:
    """Words that are shown when something is pointed at."""
    return [
        element.findtext(f"{SVG}title") or ""
        for element in root.iter()
        if element.tag != f"{SVG}svg" and element.find(f"{SVG}title") is not None
    ]
