"""Who does which task in an alternative, and what that is worth; and what is done otherwise in another one."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from missiontree.mission.alternative import Alternative, selected_leaves, selected_nodes
from missiontree.mission.estimate import MICRO, Weights
from missiontree.mission.grounded import GroundedTree
from missiontree.mission.plan import Plan
from missiontree.mission.schedule import Schedule
from missiontree.mission.why_not import Moved


@dataclass(frozen=True, slots=True)
class Task:
    """
    A routine as an alternative does it.

    Parameters
    ----------
    label
        What it is called.
    who
        Robot types, or robots, one for each of its roles.
    way
        Name of the way that is taken; empty where there is one way only.
    micro
        What its actions are worth, in millionths.
    """

    label: str
    who: tuple[str, ...]
    way: str
    micro: int

    def shown(self, with_way: bool = False) -> str:
        """Who does it, and by which way if asked for."""
        crew = " and ".join(self.who)
        return f"{crew}, by {self.way}" if with_way and self.way else crew


def tasks_of(plan: Plan, alternative: Alternative, schedule: Schedule | None = None) -> dict[str, Task]:
    """Tasks by id of the routine node, in tree order; by robots where a schedule is given, else by robot types."""
    assert plan.grounding is not None
    tree, types = plan.grounding.tree, plan.brief.fleet.by_id
    labels = {kind.id: kind.label or kind.id for kind in types.values()}
    who = {filled.role: labels.get(filled.robot_type, filled.robot_type) for filled in alternative.roles}
    if schedule is not None:
        who |= {assigned.role: assigned.robot for assigned in schedule.assignments}
    roles: dict[str, dict[int, None]] = {}
    micro: dict[str, int] = {}
    for leaf in selected_leaves(tree, alternative.choices):
        source = tree.nodes[leaf].source
        if source is not None:
            roles.setdefault(source, {})[tree.action(leaf).role] = None
            micro[source] = micro.get(source, 0) + _worth(tree, leaf, plan.brief.weights)
    ways = _ways(tree, alternative)
    names = {node.id: node.label for node in plan.tree.nodes} if plan.tree is not None else {}
    return {
        source: Task(
            names.get(source, source), tuple(who[role] for role in filled), ways.get(source, ""), micro[source]
        )
        for source, filled in roles.items()
    }


def _worth(tree: GroundedTree, leaf: int, weights: Weights) -> int:
    return weights.utility_micro(tree.action(leaf).estimate)


def _ways(tree: GroundedTree, alternative: Alternative) -> dict[str, str]:
    """Name of the way taken for each routine that has several."""
    found: dict[str, str] = {}
    for node in selected_nodes(tree, alternative.choices):
        source, parent = tree.nodes[node].source, tree.nodes[node].parent
        if source is None or parent < 0 or tree.nodes[parent].source != source or source in found:
            continue
        siblings = {tree.nodes[child].label.partition(" by ")[0] for child in tree.children[parent]}
        found[source] = tree.nodes[node].label.partition(" by ")[0] if len(siblings) > 1 else ""
    return found


def moved_between(before: Mapping[str, Task], after: Mapping[str, Task]) -> tuple[Moved, ...]:
    """Tasks that are done by others, in another way, or not at all."""
    moved = []
    for node in dict.fromkeys((*before, *after)):
        one, other = before.get(node), after.get(node)
        if one is not None and other is not None and (one.who, one.way) == (other.who, other.way):
            continue
        known = one or other
        assert known is not None
        ways = one is not None and other is not None and one.way != other.way
        moved.append(
            Moved(
                node=node,
                task=known.label,
                before=one.shown(ways) if one is not None else "",
                after=other.shown(ways) if other is not None else "",
                utility_change=((other.micro if other is not None else 0) - (one.micro if one is not None else 0))
                / MICRO,
            )
        )
    return tuple(moved)
