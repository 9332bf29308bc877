"""
Trees as columns in JSON, the form in which instances of allocation are passed on.

One mapping. ``kind`` (0 leaf, 1 AND, 2 XOR), ``parent`` (-1 for the root, else an earlier node), ``robot`` and ``utility`` are lists
with a number per node, and so are ``duration`` and ``consumption``, which may be left out; numbers other than kind and parent
belong to leaves and are 0 elsewhere. ``robots`` says how many there are. May be left out: ``budget``, what each robot may use;
``precedence``, pairs [before, after]; ``disjoint``, ANDs whose children are to be done by different robots; ``count``, how many equal
robots each ``robot`` stands for (one if it is left out).

Trees of a million nodes come through here, so all is looked at by column; a loop that names the culprit runs only where there is one.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import compress
from operator import lt
from pathlib import Path
from typing import Any

from missiontree.formats.fault import nearest
from missiontree.formats.importers.tree_order import refuse_impossible_order
from missiontree.formats.parsed import Parsed
from missiontree.formats.place import NOWHERE, found, quoted
from missiontree.formats.reader import parse
from missiontree.formats.source import load_text
from missiontree.mission.columns import AND, LEAF, XOR, TreeColumns
from missiontree.mission.fleet import MAX_ROBOTS

COLUMNS = ("kind", "parent", "robot", "utility", "duration", "consumption")
NEEDED = ("kind", "parent", "robot", "utility", "robots")
KEYS = (*COLUMNS, "precedence", "disjoint", "robots", "budget", "count")
MOST = 10**9
MOST_HELD = 10**15
"""Of a number at a leaf, and of a budget: below these, all sums that are shown are exact."""


def read_tree(path: Path) -> TreeColumns:
    """
    Read a file.

    Raises
    ------
    InputError
        If it cannot be read or is no such tree; says which field, what was found and what is accepted.
    """
    return columns_of(parse(load_text(path), str(path)))


def looks_like_tree(data: Any) -> bool:
    """Whether this is meant to be a tree of this form, rather than a document of ours."""
    return isinstance(data, dict) and "format" not in data and ("parent" in data or "kind" in data)


def columns_of(parsed: Parsed) -> TreeColumns:
    """
    The tree that plain data describes.

    Raises
    ------
    InputError
        As :func:`read_tree`.
    """
    data = parsed.data
    if not isinstance(data, dict):
        raise parsed.refusal(f"{found(data)} stands here", (), f"a mapping with {', '.join(NEEDED)}")
    for key in data:
        if key not in KEYS:
            raise parsed.refusal(f"{quoted(str(key))} is not known", (key,), ", ".join(KEYS), nearest(str(key), KEYS))
    for key in NEEDED:
        if key not in data:
            raise parsed.refusal(f"{key!r} is missing", (), f"a mapping with {', '.join(NEEDED)}")
    columns = {name: _column(parsed, name) for name in COLUMNS}
    _check_shape(parsed, columns["kind"], columns["parent"])
    robots = _robots(parsed)
    _check_leaves(parsed, columns, robots)
    disjoint = _whole_numbers(parsed, "disjoint", data.get("disjoint", []))
    kind = columns["kind"]
    tree = TreeColumns(
        kind=kind,
        parent=columns["parent"],
        robot=columns["robot"],
        utility=columns["utility"],
        duration=columns["duration"],
        consumption=columns["consumption"],
        precedence=data.get("precedence", []),
        disjoint=disjoint,
        robots=robots,
        budget=_per_robot(parsed, "budget", robots, 0, MOST_HELD),
        count=_count(parsed, robots),
    )
    _require(
        parsed, "disjoint", disjoint, lambda node: 0 <= node < len(kind) and kind[node] == AND, "the index of an AND"
    )
    refuse_impossible_order(parsed, tree)
    return tree


def _column(parsed: Parsed, name: str) -> list[int]:
    nodes = len(parsed.data["kind"]) if isinstance(parsed.data["kind"], list) else 0
    column = _whole_numbers(parsed, name, parsed.data.get(name, NOWHERE), nodes)
    if not column:
        raise parsed.refusal("the list is empty", (name,), "at least one node")
    if len(column) != nodes:
        message = f"the list has {len(column)} numbers, and there are {nodes} nodes"
        raise parsed.refusal(message, (name,), "a number per node, as many as in kind")
    return column


def _whole_numbers(parsed: Parsed, name: str, given: Any, absent: int = 0) -> list[int]:
    """The list that stands there; of that many zeros if none does."""
    if given is NOWHERE:
        return [0] * absent
    if not isinstance(given, list):
        raise parsed.refusal(f"{found(given)} stands here", (name,), "a list of whole numbers")
    if not set(map(type, given)) <= {int}:
        place = next(place for place, number in enumerate(given) if type(number) is not int)
        raise parsed.refusal(f"{found(given[place])} stands here", (name, place), "a whole number")
    return given


def _require(parsed: Parsed, name: str, numbers: Sequence[int], fits: Callable[[int], bool], accepted: str) -> None:
    for place, number in enumerate(numbers):
        if not fits(number):
            raise parsed.refusal(f"{found(number)} stands here", (name, place), accepted)


def _check_shape(parsed: Parsed, kind: list[int], parent: list[int]) -> None:
    _require_span(parsed, "kind", kind, LEAF, XOR, "0 (a leaf), 1 (an AND) or 2 (an XOR)")
    if parent[0] != -1:
        raise parsed.refusal(f"node 0 has parent {parent[0]}", ("parent", 0), "-1, for node 0 is the root")
    below_root = parent[1:]
    earlier = not below_root or (min(below_root) >= 0 and all(map(lt, below_root, range(1, len(parent)))))
    if earlier and LEAF not in set(map(kind.__getitem__, below_root)):
        return
    for node, above in enumerate(below_root, start=1):
        if not 0 <= above < node:
            if above == -1:
                message = f"node {node} is a second root"
            elif above < len(parent):
                message = f"node {node} has parent {above}, which does not stand before it"
            else:
                message = f"node {node} has parent {above}, and there are {len(parent)} nodes"
            raise parsed.refusal(
                message, ("parent", node), f"a node from 0 to {node - 1}", "Parents stand before children."
            )
        if kind[above] == LEAF:
            message = f"node {node} has parent {above}, which is a leaf"
            raise parsed.refusal(message, ("parent", node), "the index of an AND or an XOR")


def _require_span(parsed: Parsed, name: str, numbers: list[int], low: int, high: int, accepted: str) -> None:
    if numbers and not (min(numbers) >= low and max(numbers) <= high):
        _require(parsed, name, numbers, lambda number: low <= number <= high, accepted)


def _robots(parsed: Parsed) -> int:
    robots = parsed.data["robots"]
    if type(robots) is not int or not 1 <= robots <= MAX_ROBOTS:
        message = f"{found(robots)} stands here"
        raise parsed.refusal(message, ("robots",), f"a whole number of robots from 1 to {MAX_ROBOTS:,}")
    return robots


def _check_leaves(parsed: Parsed, columns: dict[str, list[int]], robots: int) -> None:
    spans = {"robot": (0, robots - 1), "utility": (-MOST, MOST), "duration": (0, MOST), "consumption": (0, MOST)}
    for name, (low, high) in spans.items():
        _require_span(parsed, name, columns[name], low, high, f"a whole number from {low:,} to {high:,}")
        if any(compress(columns[name], columns["kind"])):
            kinds = enumerate(zip(columns["kind"], columns[name], strict=True))
            node, kind, number = next((node, kind, number) for node, (kind, number) in kinds if kind and number)
            message = f"node {node} is {'an AND' if kind == AND else 'an XOR'} and has {name} {number}"
            raise parsed.refusal(message, (name, node), "0, for only leaves have one")


def _per_robot(parsed: Parsed, name: str, robots: int, low: int, high: int) -> list[int] | None:
    """The list with a number per robot that stands there; None if there is none."""
    given = parsed.data.get(name)
    if given is None:
        return None
    numbers = _whole_numbers(parsed, name, given)
    if len(numbers) != robots:
        raise parsed.refusal(
            f"the list has {len(numbers)} numbers, and there are {robots} robots", (name,), "a number per robot"
        )
    _require_span(parsed, name, numbers, low, high, f"a whole number from {low:,} to {high:,}")
    return numbers


def _count(parsed: Parsed, robots: int) -> list[int] | None:
    count = _per_robot(parsed, "count", robots, 1, MAX_ROBOTS)
    if count is not None and sum(count) > MAX_ROBOTS:
        raise parsed.refusal(
            f"there are {sum(count):,} robots in all", ("count",), f"at most {MAX_ROBOTS:,} robots in all"
        )
    return count
