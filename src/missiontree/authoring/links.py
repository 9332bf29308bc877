"""Links between nodes: read from pairs, refused where they contradict the tree or each other."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from missiontree.authoring.answer import RefusalError, refuse
from missiontree.authoring.matching import did_you_mean, quoted, same_name
from missiontree.authoring.wire import RULE, kind_of_json
from missiontree.mission.precedence import EventGraph, event_graph
from missiontree.mission.reason import Reason
from missiontree.mission.routine import RoutineLibrary
from missiontree.mission.tree import MUTUAL, Link, LinkKind, MissionTree
from missiontree.routines.open_ended import is_open_ended, pointless_until

WIRE_KINDS: dict[str, LinkKind] = {
    "Precedence": "precedence",
    "SameRobot": "same_robot",
    "DifferentRobot": "different_robot",
    "Until": "until",
    "HandOver": "hand_over",
}
MAX_LINKS = 20_000
_LONGEST_CIRCLE = 20
Pair = tuple[str | int, str | int, LinkKind]
_OPPOSED = {
    ("same_robot", "different_robot"),
    ("different_robot", "same_robot"),
    ("same_robot", "hand_over"),
    ("hand_over", "same_robot"),
}
_FORM = 'Pairs are written [["a", "b"]] or [["a", "b", "Precedence"]]: a list of lists.'


def read_pairs(given: Any, what: str) -> tuple[Pair, ...]:
    """
    The pairs of a call; an empty object, an empty list and null mean none.

    Raises
    ------
    RefusalError
        ``malformed_arguments`` if it is anything but a list of pairs.
    """
    if given is None or given in ({}, []):
        return ()
    if not isinstance(given, list):
        raise refuse(RULE, f"{what} is {kind_of_json(given)} where a list of pairs is expected.", hint=_FORM)
    return tuple(_read_pair(pair, f"{what}[{number}]") for number, pair in enumerate(given))


def _read_pair(pair: Any, what: str) -> Pair:
    if not isinstance(pair, list):
        raise refuse(RULE, f"{what} is {kind_of_json(pair)} where a pair is expected.", hint=_FORM)
    if len(pair) not in {2, 3}:
        raise refuse(RULE, f"{what} has {len(pair)} entries; a pair has two, or three with its kind.", hint=_FORM)
    first, second = (_read_end(end, f"{what}[{number}]") for number, end in enumerate(pair[:2]))
    return first, second, read_kind(pair[2], f"{what}[2]") if len(pair) == 3 else "precedence"


def _read_end(end: Any, what: str) -> str | int:
    if isinstance(end, bool) or not isinstance(end, str | int):
        raise refuse(
            RULE, f"{what} is {kind_of_json(end)} where a node is expected.", hint="Name a node by id, name or index."
        )
    return end


def read_kind(given: Any, what: str) -> LinkKind:
    """
    The kind of a link, letter case aside.

    Raises
    ------
    RefusalError
        ``malformed_arguments`` with the kinds there are.
    """
    accepted = f"Kinds are {', '.join(WIRE_KINDS)}."
    if not isinstance(given, str):
        raise refuse(RULE, f"{what} is {kind_of_json(given)} where the kind of a link is expected.", hint=accepted)
    for name, kind in WIRE_KINDS.items():
        if same_name(given) in {same_name(name), kind}:
            return kind
    raise refuse(
        RULE,
        f"{what}: there is no kind of link {quoted(given)}.",
        hint=f"{did_you_mean(given, WIRE_KINDS)} {accepted}".strip(),
    )


def check_links(tree: MissionTree, links: Sequence[Link], library: RoutineLibrary) -> None:
    """
    Make sure that further links can stand beside the tree and its links.

    Raises
    ------
    RefusalError
        ``size``, ``duplicate``, ``contained``, ``link_conflict``, ``not_open_ended`` or ``cycle``.
    """
    if not links:
        return
    if len(tree.links) + len(links) > MAX_LINKS:
        raise refuse("size", f"The tree would have more than {MAX_LINKS} links.", hint="Link the tasks above instead.")
    standing = {(link.first, link.second, link.kind) for link in tree.links}
    for link in links:
        _check_one(tree, link, standing)
        if pointless_until(tree, link, library):
            raise RefusalError(not_open_ended(link, library))
        standing.add((link.first, link.second, link.kind))
    _check_cycles(tree, links)


def not_open_ended(link: Link, library: RoutineLibrary) -> Reason:
    """Why an until link means nothing."""
    lasting = [routine.id for routine in library.routines if is_open_ended(routine, library)]
    return Reason(
        rule="not_open_ended",
        message=f"Until from {link.first!r} to {link.second!r}: nothing in {link.first!r} goes on without an end of its own.",
        node=link.first,
        needed="a routine with an open-ended action",
        hint=f"Routines that go on until something else ends: {', '.join(lasting) or 'none'}. Precedence orders the others.",
    )


def _check_one(tree: MissionTree, link: Link, standing: set[tuple[str, str, LinkKind]]) -> None:
    said = f"{name_of_kind(link.kind)} from {link.first!r} to {link.second!r}"
    if tree.contains(link.first, link.second) or tree.contains(link.second, link.first):
        message = f"{said} joins a node with itself or with one above it."
        raise refuse("contained", message, node=link.first, hint="Link two nodes neither of which contains the other.")
    ways = [(link.first, link.second)] + ([(link.second, link.first)] if link.kind in MUTUAL else [])
    for first, second in ways:
        if (first, second, link.kind) in standing:
            raise refuse("duplicate", f"{said} stands already.", node=link.first, hint="Leave it out.")
    for first, second in [(link.first, link.second), (link.second, link.first)]:
        for kind, other in _OPPOSED:
            if link.kind == kind and (first, second, other) in standing:
                message = f"{said} contradicts {name_of_kind(other)} between the same nodes."  # type: ignore[arg-type]
                raise refuse("link_conflict", message, node=link.first, hint="Drop the other link first (dropLink).")


def _check_cycles(tree: MissionTree, links: Sequence[Link]) -> None:
    """Name the first link that closes a cycle; it is found by halving, so that thousands of links cost little more than one."""
    if _graph(tree, links).cycle() is None:
        return
    sound, faulty = 0, len(links)
    while faulty - sound > 1:
        middle = (sound + faulty) // 2
        if _graph(tree, links[:middle]).cycle() is None:
            sound = middle
        else:
            faulty = middle
    link, number = links[sound], _numbers(tree)
    circle = _graph(tree, links[:sound]).closing_cycle(number[link.first], number[link.second], link.kind) or []
    names = [tree.nodes[index].id for index in circle]
    message = (
        f"{name_of_kind(link.kind)} from {link.first!r} to {link.second!r} closes a cycle: "
        f"{circle_in_words(names)}. None of them could ever be done."
    )
    raise refuse(
        "cycle", message, node=link.first, hint="Turn the pair round, leave it out, or drop another link (dropLink)."
    )


def _graph(tree: MissionTree, links: Sequence[Link]) -> EventGraph:
    graph, number = event_graph(tree), _numbers(tree)
    for link in links:
        graph.add_link(number[link.first], number[link.second], link.kind)
    return graph


def _numbers(tree: MissionTree) -> dict[str, int]:
    return {node.id: index for index, node in enumerate(tree.nodes)}


def circle_in_words(names: Sequence[str]) -> str:
    """The nodes of a cycle in order, back to the first; the middle of a long one is left out, and said to be."""
    shown = [*names, *names[:1]]
    if len(shown) > _LONGEST_CIRCLE:
        half = _LONGEST_CIRCLE // 2
        shown = [*shown[:half], f"({len(shown) - 2 * half} more)", *shown[-half:]]
    return " > ".join(shown)


def name_of_kind(kind: LinkKind) -> str:
    """The kind as it is written on the wire."""
    return next(name for name, known in WIRE_KINDS.items() if known == kind)
