"""Trees to be shown, written as nested calls, and pictures taken apart again."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from xml.etree import ElementTree

from missiontree.mission.tree import LinkKind
from missiontree.reporting.text_box import text_width
from missiontree.reporting.tree.shape import Shape, ShapeNode
from tests.reporting.tree_geometry import Box

SVG = "{http://www.w3.org/2000/svg}"
_NUMBER = re.compile(r"-?\d+(?:\.\d+)?")


@dataclass(frozen=True)
class Sprout:
    """A node to be shown with what is below it, not yet numbered."""

    node: ShapeNode
    children: tuple[Sprout, ...] = ()


def task(label: str, *children: Sprout, gate: str = "and", **fields: object) -> Sprout:
    """A task over its parts."""
    node = ShapeNode(label, label, "", "task", ("xor" if gate == "xor" else "and") if children else None)
    return Sprout(replace(node, **fields), children)  # type: ignore[arg-type]


def routine(label: str, **fields: object) -> Sprout:
    """A routine that is not expanded."""
    return Sprout(replace(ShapeNode(label, label, "", "routine", None), **fields))  # type: ignore[arg-type]


def step(label: str, role: int = 0, **fields: object) -> Sprout:
    """An action of a role."""
    return Sprout(replace(ShapeNode(label, label, "", "action", None, role), **fields))  # type: ignore[arg-type]


def shape(root: Sprout, links: Iterable[tuple[str, str, LinkKind]] = (), frames: Iterable[str] = ()) -> Shape:
    """Number a tree in preorder; links and frames go by labels, which must then stand once."""
    nodes: list[ShapeNode] = []
    children: list[list[int]] = []
    stack = [(root, -1)]
    while stack:
        sprout, parent = stack.pop()
        if parent >= 0:
            children[parent].append(len(nodes))
        stack += [(child, len(nodes)) for child in reversed(sprout.children)]
        nodes.append(sprout.node)
        children.append([])
    at = {node.label: index for index, node in enumerate(nodes)}
    return Shape(
        tuple(nodes),
        tuple(map(tuple, children)),
        tuple((at[first], at[second], kind) for first, second, kind in links),
        tuple(at[label] for label in frames),
    )


def parsed(svg: str) -> ElementTree.Element:
    """The document, by a strict parser."""
    return ElementTree.fromstring(svg)  # noqa: S314 - it is our own


def group(root: ElementTree.Element, name: str) -> list[ElementTree.Element]:
    """Content of a layer of the picture; empty if it has none such."""
    return [child for layer in root.findall(f"{SVG}g") if layer.get("class") == name for child in layer]


def classes(element: ElementTree.Element) -> set[str]:
    """Classes of an element."""
    return set((element.get("class") or "").split())


def words(root: ElementTree.Element) -> list[str]:
    """Everything written, line by line."""
    return [text.text or "" for text in root.iter(f"{SVG}text")]


def extents(
    root: ElementTree.Element, size: float = 13.0, anchor: str = "start"
) -> Iterator[tuple[ElementTree.Element, Box]]:
    """What every element takes of the page, words as wide as we think they are; size and anchor are those of the layer around it."""
    for element, font, side_of in _walk(root, size, anchor):
        name = element.tag.removeprefix(SVG)
        if name == "rect":
            x, y, width, high = (float(element.get(side, 0)) for side in ("x", "y", "width", "height"))
            if "rotate(-90" in element.get("transform", ""):  # about its middle
                x, y, width, high = x + width / 2 - high / 2, y + high / 2 - width / 2, high, width
            yield element, Box(x, y, x + width, y + high)
        elif name in {"ellipse", "circle"}:
            x, y = float(element.get("cx", 0)), float(element.get("cy", 0))
            across, down = (float(element.get(side, element.get("r", 0))) for side in ("rx", "ry"))
            yield element, Box(x - across, y - down, x + across, y + down)
        elif name == "path" and (numbers := [float(found) for found in _NUMBER.findall(_points(element.get("d", "")))]):
            yield element, Box(min(numbers[::2]), min(numbers[1::2]), max(numbers[::2]), max(numbers[1::2]))
        elif name == "text":
            yield element, _text_box(element, font, side_of)


def _points(path: str) -> str:
    """A path without the radii and flags of its arcs."""
    return re.sub(r"A\S+ \S+ \S+ \S+ \S+", "L", path)


def _text_box(element: ElementTree.Element, size: float, anchor: str) -> Box:
    x, y, width = float(element.get("x", 0)), float(element.get("y", 0)), text_width(element.text or "", size)
    if "rotate(-90" in element.get("transform", ""):
        return Box(x - size, y - width / 2, x + size, y + width / 2)
    left = x - width / 2 if anchor == "middle" else x
    return Box(left, y - 0.8 * size, left + width, y + 0.25 * size)


def _walk(element: ElementTree.Element, size: float, anchor: str) -> Iterator[tuple[ElementTree.Element, float, str]]:
    """All elements that are drawn, with the font size and the anchor that they inherit."""
    if element.tag == f"{SVG}defs":
        return
    size, anchor = float(element.get("font-size", size)), element.get("text-anchor", anchor)
    yield element, size, anchor
    for child in element:
        yield from _walk(child, size, anchor)
