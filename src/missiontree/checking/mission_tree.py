"""Is the mission tree complete: no open leaf, and every routine, argument and entity known?"""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from missiontree.checking.case import Case
from missiontree.checking.fault import Fault
from missiontree.mission.precedence import event_graph


def tree_missing(case: Case) -> Iterator[Fault]:
    """A tree over the fleet names nodes of a mission tree that the plan does not hold; or a delivered plan has none of both."""
    if case.tree is None:
        if case.plan.outcome == "delivered" or case.plan.ranking is not None:
            yield Fault("the plan has no tree over the fleet, which alternatives and schedules speak of.")
    elif case.mission_tree is None and any(node.source is not None for node in case.tree.nodes):
        yield Fault("the plan has no mission tree, and its tree over the fleet names nodes of one.")


def leaf_open(case: Case) -> Iterator[Fault]:
    """A task of a tree that was planned with has no children and no routine."""
    for node in case.mission_tree.open_leaves if case.mission_tree is not None and case.tree is not None else ():
        yield Fault(f"the task {node.label} ends in no routine.", node=node.id)


def routine_unknown(case: Case) -> Iterator[Fault]:
    """A node names a routine that the library does not have."""
    for node in case.routine_nodes:
        if case.plan.brief.routines.find(node.routine or "") is None:
            yield Fault(
                f"{node.label} names routine {node.routine!r}, which is not in the library.",
                node=node.id,
                found=f"{node.routine}",
            )


def argument_wrong(case: Case) -> Iterator[Fault]:
    """A routine lacks an argument, or is given one that it does not have."""
    for node in case.routine_nodes:
        routine = case.plan.brief.routines.find(node.routine or "")
        needed = set(routine.argument_kinds) if routine is not None else set(node.arguments)
        if set(node.arguments) != needed:
            yield Fault(
                f"{node.label} gives {routine.id if routine else ''} the arguments {_list(node.arguments)}; it takes {_list(needed)}.",
                node=node.id,
                found=_list(node.arguments),
                needed=_list(needed),
            )


def entity_unknown(case: Case) -> Iterator[Fault]:
    """An argument names an entity that neither the scene nor the tree has."""
    for node in case.routine_nodes:
        for argument, entity in node.arguments.items():
            if entity not in case.scene.by_id:
                yield Fault(
                    f"{node.label} names {entity!r} as {argument}, which neither scene nor tree has.",
                    node=node.id,
                    found=entity,
                )


def entity_clash(case: Case) -> Iterator[Fault]:
    """The entities that the tree introduces do not fit into the scene."""
    if case.clash:
        yield Fault(f"the entities of the tree do not fit into the scene: {case.clash}")


def resource_unknown(case: Case) -> Iterator[Fault]:
    """A node allows a robot type that the fleet does not have."""
    for node in case.routine_nodes:
        for type_id in node.resources or ():
            if type_id not in case.fleet.by_id:
                yield Fault(
                    f"{node.label} allows robot type {type_id!r}, which the fleet does not have.",
                    node=node.id,
                    robot=type_id,
                )


def precedence_circular(case: Case) -> Iterator[Fault]:
    """Links and containment ask for an order that bites its own tail."""
    cycle = event_graph(case.mission_tree).cycle() if case.mission_tree is not None else None
    if case.mission_tree is not None and cycle is not None:
        names = [case.mission_tree.nodes[node].label for node in cycle]
        yield Fault(f"the order is circular: {' > '.join(names)}.", node=case.mission_tree.nodes[cycle[0]].id)


def _list(names: Iterable[str]) -> str:
    return ", ".join(sorted(names)) or "none"
