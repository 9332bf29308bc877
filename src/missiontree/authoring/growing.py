"""The nodes that a call adds: named once below their parent, each under an id of its own, and not too many."""

from __future__ import annotations

from collections.abc import Sequence

from missiontree.authoring.answer import refuse
from missiontree.authoring.edits import depth_of
from missiontree.authoring.findings import MAX_DEPTH, MAX_NODES
from missiontree.authoring.matching import quoted, same_name
from missiontree.authoring.naming import make_id
from missiontree.authoring.routine_calls import RoutineCall
from missiontree.authoring.texts import MAX_NAME, check_text
from missiontree.mission.tree import MissionNode, MissionTree


def task_nodes(tree: MissionTree, above: MissionNode, names: Sequence[str]) -> list[MissionNode]:
    """
    Tasks of those names, to stand below a node.

    Raises
    ------
    RefusalError
        ``duplicate``, if the node has a child of one of the names, or a name stands twice; ``malformed_arguments`` for what is no name.
    """
    _check_names(tree, above, names)
    taken = set(tree.by_id)
    nodes: list[MissionNode] = []
    for name in names:
        nodes.append(MissionNode(id=make_id(name, taken, "task"), label=name))
        taken.add(nodes[-1].id)
    return nodes


def routine_nodes(tree: MissionTree, above: MissionNode, calls: Sequence[RoutineCall]) -> list[MissionNode]:
    """
    Leaves for calls of routines, to stand below a node.

    Raises
    ------
    RefusalError
        ``duplicate``, if the node has the same call below it, or a call stands twice.
    """
    taken = set(tree.by_id)
    standing = {
        (child.routine, tuple(child.arguments.values()), child.resources)
        for child in (tree.by_id[child_id] for child_id in above.children)
    }
    nodes = []
    for call in calls:
        arguments = {name: entity.id for name, entity in call.entities.items()}
        same = (call.routine.id, tuple(arguments.values()), call.resources)
        if same in standing:
            message = f"{above.label!r} has {call.label} already, or the call names it twice."
            raise refuse("duplicate", message, node=call.label, hint="Leave it out.")
        standing.add(same)
        node_id = make_id(call.label, taken, "routine")
        taken.add(node_id)
        nodes.append(
            MissionNode(
                id=node_id, label=call.label, routine=call.routine.id, arguments=arguments, resources=call.resources
            )
        )
    return nodes


def check_size(tree: MissionTree, above: MissionNode, more: int) -> None:
    """
    Make sure that so many nodes fit below a node.

    Raises
    ------
    RefusalError
        ``size``.
    """
    if len(tree.nodes) + more > MAX_NODES:
        message = f"The tree would have {len(tree.nodes) + more} nodes; at most {MAX_NODES} are planned."
        raise refuse("size", message, node=above.id, needed=f"at most {MAX_NODES}", hint="Make the tree smaller.")
    if depth_of(tree, above.id) + 1 > MAX_DEPTH:
        message = f"The tree would have {MAX_DEPTH + 1} levels; at most {MAX_DEPTH} are planned."
        raise refuse("size", message, node=above.id, needed=f"at most {MAX_DEPTH}", hint="Put it higher up.")


def _check_names(tree: MissionTree, above: MissionNode, names: Sequence[str]) -> None:
    standing = {same_name(tree.by_id[child].label): child for child in above.children}
    for name in names:
        check_text(name, "a task name", MAX_NAME)
        form = same_name(name)
        if form in standing:
            message = f"{above.label!r} has a subtask {quoted(name)} already, or the call names it twice."
            raise refuse("duplicate", message, node=standing[form], hint="Give it another name, or leave it out.")
        standing[form] = name
