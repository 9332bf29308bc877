"""What is still wrong or unfinished in a mission tree, worded so that a model can repair it; and the gate that a plan must pass."""

from __future__ import annotations

from collections.abc import Iterator

from missiontree.authoring.links import MAX_LINKS, circle_in_words, not_open_ended
from missiontree.authoring.matching import did_you_mean, listed
from missiontree.mission.brief import MissionBrief
from missiontree.mission.precedence import event_graph
from missiontree.mission.reason import Reason
from missiontree.mission.routine import RoutineLibrary
from missiontree.mission.scene import Scene
from missiontree.mission.tree import MissionNode, MissionTree
from missiontree.routines.open_ended import pointless_until

MAX_NODES = 10_000
MAX_DEPTH = 64


def findings(tree: MissionTree | None, brief: MissionBrief) -> tuple[Reason, ...]:
    """Everything that is wrong (severity ``error``) or odd (``warning``) in a tree, in the order of its nodes."""
    if tree is None:
        return (
            Reason(
                rule="no_tree", message="There is no tree yet.", hint="Begin with HierarchicalTree_init(objective)."
            ),
        )
    try:
        scene = brief.world.extended(tree.entities)
    except ValueError as error:
        hint = "Give the introduced entities ids and kinds that fit the scene."
        return (Reason(rule="entities_clash", message=f"The tree's entities do not fit the scene: {error}", hint=hint),)
    found = [*_of_size(tree)]
    for node in tree.nodes:
        found += _of_routine(node, brief, scene) if node.routine is not None else _of_task(node)
    return (*found, *_of_order(tree, brief.routines))


def gate(tree: MissionTree | None, brief: MissionBrief) -> tuple[Reason, ...]:
    """The finish gate: the findings that keep a tree from being a plan; empty if it passes."""
    return tuple(finding for finding in findings(tree, brief) if finding.severity == "error")


def _of_size(tree: MissionTree) -> Iterator[Reason]:
    level = {tree.root.id: 1}
    for node in tree.nodes:
        level |= dict.fromkeys(node.children, level[node.id] + 1)
    sizes = (
        ("nodes", len(tree.nodes), MAX_NODES),
        ("levels", max(level.values()), MAX_DEPTH),
        ("links", len(tree.links), MAX_LINKS),
    )
    for what, size, most in sizes:
        if size > most:
            message = f"The tree has {size} {what}; at most {most} are planned."
            yield Reason(
                rule="size", message=message, found=str(size), needed=f"at most {most}", hint="Make it smaller."
            )


def _of_task(node: MissionNode) -> Iterator[Reason]:
    if not node.children:
        yield Reason(
            rule="open_leaf",
            message=f"{node.label!r} ({node.id}) ends in no routine.",
            node=node.id,
            hint="Put subtasks or routines below it (attachMultiSubTrees), or remove it (removeSubtask).",
        )


def _of_routine(node: MissionNode, brief: MissionBrief, scene: Scene) -> Iterator[Reason]:
    routine = brief.routines.by_id.get(node.routine or "")
    if routine is None:
        names = [known.id for known in brief.routines.routines]
        message = f"{node.label!r} ({node.id}) names routine {node.routine!r}, which is not on offer."
        hint = f"{did_you_mean(node.routine or '', names)} Routines are: {listed(names)}.".strip()
        yield Reason(rule="unknown_routine", message=message, node=node.id, hint=hint)
        return
    if set(node.arguments) != set(routine.argument_kinds):
        message = f"{node.label!r} ({node.id}) has arguments {', '.join(node.arguments) or 'none'}."
        accepted = ", ".join(routine.argument_kinds)
        yield Reason(
            rule="wrong_arguments",
            message=message,
            node=node.id,
            needed=accepted,
            hint=f"{routine.id} takes {accepted}.",
        )
        return
    if len(set(node.arguments.values())) < len(node.arguments):
        message = f"{node.label!r} ({node.id}) gives {routine.id} the same entity twice."
        hint = "Name somebody or something else for one of its arguments."
        yield Reason(rule="same_entity_twice", message=message, node=node.id, hint=hint)
    for name, entity_id in node.arguments.items():
        entity = scene.by_id.get(entity_id)
        if entity is None:
            message = f"{node.label!r} ({node.id}) speaks of {entity_id!r}, which nobody knows."
            hint = f"{did_you_mean(entity_id, scene.by_id)} Or introduce it (introduceEntity).".strip()
            yield Reason(rule="unknown_entity", message=message, node=node.id, hint=hint)
        elif brief.check_kinds and not set(scene.lineage(entity.kind)) & set(routine.argument_kinds[name]):
            needed = " or ".join(routine.argument_kinds[name])
            message = f"{routine.id} takes as {name} {needed}; {entity.label} is of kind {entity.kind}."
            yield Reason(rule="wrong_kind", message=message, node=node.id, found=entity.kind, needed=needed)
    for name in node.resources or ():
        if name not in brief.fleet.by_id:
            message = f"{node.label!r} ({node.id}) allows robot type {name!r}, which the fleet does not have."
            hint = f"{did_you_mean(name, brief.fleet.by_id)} Robot types are: {listed(brief.fleet.by_id)}.".strip()
            yield Reason(rule="unknown_robot", message=message, node=node.id, hint=hint)


def _of_order(tree: MissionTree, library: RoutineLibrary) -> Iterator[Reason]:
    circle = event_graph(tree).cycle()
    if circle is not None:
        names = [tree.nodes[index].id for index in circle]
        message = f"The order is a cycle: {circle_in_words(names)}. None of them could ever be done."
        yield Reason(rule="cycle", message=message, node=names[0], hint="Drop one of the links (dropLink).")
    for link in tree.links:
        if pointless_until(tree, link, library):
            yield not_open_ended(link, library)
        fork = _parting(tree, link.first, link.second)
        if fork.gate == "xor" and link.kind != "different_robot":
            message = (
                f"The {link.kind} link from {link.first!r} to {link.second!r} never binds: "
                f"they stand below different children of {fork.id!r}, of which only one is done."
            )
            yield Reason(rule="link_never_binds", message=message, severity="warning", node=link.first, hint="Drop it.")


def _parting(tree: MissionTree, first: str, second: str) -> MissionNode:
    """The lowest node above both."""
    above = set(tree.ancestors(first))
    return tree.by_id[next(node for node in tree.ancestors(second) if node in above)]
