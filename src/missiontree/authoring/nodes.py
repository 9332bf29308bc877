"""How calls name the nodes of the tree: by id, by name, as ``SearchTree(cat)``, or by place in the call's own list."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Sequence

from missiontree.authoring.answer import RefusalError, refuse
from missiontree.authoring.entities import Cast
from missiontree.authoring.matching import did_you_mean, is_near, listed, quoted, same_name, without_articles
from missiontree.mission.reason import Reason
from missiontree.mission.routine import RoutineLibrary
from missiontree.mission.tree import MissionNode, MissionTree

_APPLIED = re.compile(r"\s*([A-Za-z][A-Za-z0-9_-]*)\s*\((.*)\)\s*", re.DOTALL)


def find_parent(tree: MissionTree, name: str) -> tuple[MissionNode, tuple[Reason, ...]]:
    """
    The task that a call names as parent, and a notice if the name was not exact.

    Raises
    ------
    RefusalError
        ``unknown_parent``, ``ambiguous_name``, or ``parent_is_routine``.
    """
    node = tree.root if name == tree.objective else tree.by_id.get(name)
    notices: tuple[Reason, ...] = ()
    if node is None:
        node, exact = _parent_by_name(tree, name)
        if not exact:
            message = f"Parent {quoted(name)} was taken to mean {node.label!r} ({node.id})."
            notices = (
                Reason(
                    rule="parent_matched",
                    message=message,
                    severity="notice",
                    node=node.id,
                    found=name,
                    needed=node.label,
                ),
            )
    if node.routine is not None:
        message = f"{node.label!r} is a routine; nothing can be put below it."
        hint = f"Tasks are: {listed(known.id for known in _tasks(tree))}."
        raise refuse("parent_is_routine", message, node=node.id, hint=hint)
    return node, notices


def _parent_by_name(tree: MissionTree, name: str) -> tuple[MissionNode, bool]:
    """The node of that name and whether the name was exact, going from exact names to near ones."""
    folded = without_articles(name)
    tests: tuple[Callable[[MissionNode], bool], ...] = (
        lambda node: node.label == name,
        lambda node: same_name(node.label) == same_name(name),
        lambda node: bool(folded) and without_articles(node.label) == folded,
    )
    for number, test in enumerate(tests):
        if matches := [node for node in tree.nodes if test(node)]:
            return _only(matches, name), number == 0
    if any(is_near(node.label, name) for node in tree.nodes):
        # A slip may have made it of a shorter word as well: "roosf" of "roofs" or of "roof".
        return _only([node for node in tree.nodes if is_near(node.label, name, 1)], name), False
    tasks = _tasks(tree)
    raise refuse(
        "unknown_parent",
        f"There is no task {quoted(name)}.",
        node=name[:200],
        hint=f"{did_you_mean(name, (node.label for node in tasks))} Tasks are: {listed(node.id for node in tasks)}.".strip(),
    )


def find_node(
    tree: MissionTree,
    reference: str | int,
    own: Sequence[MissionNode],
    names: Sequence[str],
    library: RoutineLibrary,
    cast: Cast,
) -> MissionNode:
    """
    The node that a pair names.

    Parameters
    ----------
    tree
        The tree, the call's own nodes included.
    reference
        An id, a name, ``SearchTree(cat)``, or an index into the call's list.
    own
        Nodes that the call makes; they go before others of the same name.
    names
        What the call called them.
    library, cast
        What ``SearchTree(cat)`` may refer to.

    Raises
    ------
    RefusalError
        ``unknown_node`` or ``ambiguous_name``.
    """
    if isinstance(reference, int):
        if 0 <= reference < len(own):
            return own[reference]
        span = f"Indices count from 0 to {len(own) - 1}." if own else "This call makes no nodes; use ids."
        raise refuse("unknown_node", f"There is no node number {reference} in this call.", hint=span)
    if reference in tree.by_id:
        return tree.by_id[reference]
    wanted = same_name(reference)
    in_call = [
        node for node, name in zip(own, names, strict=True) if wanted in {same_name(name), same_name(node.label)}
    ]
    applied = _applied(reference, library, cast)
    for group in (own, tree.nodes):
        called = [
            node
            for node in group
            if same_name(node.label) == wanted or (applied is not None and applied == _call_of(node))
        ]
        matches = list({node.id: node for node in (*called, *(in_call if group is own else []))}.values())
        if matches:
            return _only(matches, reference)
    labels = [node.label for node in tree.nodes]
    raise refuse(
        "unknown_node",
        f"There is no node {quoted(reference)}.",
        node=reference[:200],
        hint=f"{did_you_mean(reference, labels)} Nodes are: {listed(node.id for node in tree.nodes)}.".strip(),
    )


def _applied(reference: str, library: RoutineLibrary, cast: Cast) -> tuple[str, tuple[str, ...]] | None:
    """Routine and entities of ``SearchTree(cat)``; None if the reference is nothing of that form."""
    if (found := _APPLIED.fullmatch(reference)) is None or (routine := library.find(found[1])) is None:
        return None
    try:
        entities = [cast.find(part.strip()) for part in found[2].split(",")]
    except RefusalError:
        return None
    return routine.id, tuple(entity.id if entity is not None else "" for entity in entities)


def _call_of(node: MissionNode) -> tuple[str, tuple[str, ...]] | None:
    return None if node.routine is None else (node.routine, tuple(node.arguments.values()))


def _tasks(tree: MissionTree) -> list[MissionNode]:
    return [node for node in tree.nodes if node.routine is None]


def _only(matches: Sequence[MissionNode], name: str) -> MissionNode:
    if len(matches) > 1:
        raise refuse("ambiguous_name", f"{quoted(name)} may be any of {_ids(matches)}.", hint="Use one of these ids.")
    return matches[0]


def _ids(nodes: Iterable[MissionNode]) -> str:
    return listed(node.id for node in nodes)
