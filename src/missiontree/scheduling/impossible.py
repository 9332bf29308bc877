"""Proofs that an alternative cannot be scheduled, whatever robots are taken and in whatever order."""

from __future__ import annotations

from collections.abc import Collection, Iterator

from missiontree.estimation.travel import Blocked
from missiontree.mission.fleet import Fleet, RobotType
from missiontree.mission.grounded import Action
from missiontree.mission.reason import Reason
from missiontree.scheduling.chargers import NO_CHARGERS, Chargers
from missiontree.scheduling.places import Places
from missiontree.scheduling.precedence import TaskGraph
from missiontree.scheduling.staffing import Staffing
from missiontree.scheduling.trips import Trips

TOLERANCE = 1e-9


def cycle_reason(graph: TaskGraph, *, rule: str, why: str) -> Reason:
    """The cycle that a task graph has, its nodes named in order."""
    names = [graph.name(node) for node in graph.cycle() or ()]
    way = " → ".join([*names, *names[:1]])
    return Reason(rule=rule, message=f"{why}: {way}.", node=names[0] if names else "", found=way)


def unreachable_places(graph: TaskGraph, places: Places, fleet: Fleet, trips: Trips) -> list[Reason]:
    """Actions at places that no robot of the chosen type can get to from where it starts."""
    reasons: dict[tuple[str, str], Reason] = {}
    for leaves in graph.roles.values():
        for leaf in leaves:
            action = graph.tree.action(leaf)
            key = (action.robot_type, action.at or "")
            if (
                action.at is not None
                and key not in reasons
                and (reason := _unreachable(action, leaf, places, fleet, trips))
            ):
                reasons[key] = reason
    return list(reasons.values())


def _unreachable(action: Action, leaf: int, places: Places, fleet: Fleet, trips: Trips) -> Reason | None:
    kind = fleet.by_id[action.robot_type]
    blocked: Blocked | None = None
    for start in dict.fromkeys(trips.starts(kind.id)):
        for spot in places.of[leaf]:
            if start is None or spot is None:
                return None
            trip = trips.approach(kind.id, start, spot)
            if not isinstance(trip, Blocked):
                return None
            blocked = trip
    if blocked is None:
        return None
    return Reason(
        rule="unreachable",
        message=f"No robot of type {kind.label!r} can get to {action.at} for {action.text!r}: {blocked.reason.message}",
        node=action.text,
        robot=kind.id,
        found=blocked.reason.found,
        needed=action.at or "",
        hint=blocked.reason.hint,
    )


def least_use(action: Action) -> dict[str, float]:
    """What an action uses of each budget whatever happens."""
    use = dict(action.uses)
    for name, amount in action.uses_at_least.items():
        use[name] = max(use.get(name, 0.0), amount)
    return use


def group_needs(graph: TaskGraph, staffing: Staffing) -> dict[int, dict[str, float]]:
    """What the robot of each group of roles uses of each budget whatever happens."""
    needs: dict[int, dict[str, float]] = {}
    for role, leaves in graph.roles.items():
        need = needs.setdefault(staffing.group_of[role], {})
        for leaf in leaves:
            for name, amount in least_use(graph.tree.action(leaf)).items():
                need[name] = need.get(name, 0.0) + amount
    return needs


def budgets_exceeded(
    graph: TaskGraph, staffing: Staffing, fleet: Fleet, chargers: Chargers = NO_CHARGERS
) -> list[Reason]:
    """Budgets that are too small even if every approach costs nothing; what robots refill is none."""
    needs = group_needs(graph, staffing)
    by_type: dict[str, list[tuple[str, dict[str, float]]]] = {}
    for group, need in needs.items():
        by_type.setdefault(staffing.type_of[group], []).append((graph.tree.roles[group].label, need))
    return [
        reason
        for type_id, groups in by_type.items()
        for reason in _over(fleet.by_id[type_id], groups, chargers.of(fleet.by_id[type_id]))
    ]


def _over(kind: RobotType, groups: list[tuple[str, dict[str, float]]], refilled: Collection[str]) -> Iterator[Reason]:
    total: dict[str, float] = {}
    for label, need in groups:
        for name, amount in need.items():
            total[name] = total.get(name, 0.0) + amount
            budgets = None if name in refilled else _budgets(kind, name)
            if budgets is not None and amount > max(budgets) + TOLERANCE:
                yield _budget_reason(kind, name, amount, max(budgets), label, f"{label!r} needs at least")
    for name, amount in total.items():
        budgets = None if name in refilled else _budgets(kind, name)
        if budgets is not None and amount > sum(budgets) + TOLERANCE:
            yield _budget_reason(kind, name, amount, sum(budgets), "", "Their roles together need at least")
        limit = kind.total_limits.get(name)
        if limit is not None and amount > limit + TOLERANCE:
            yield _budget_reason(kind, name, amount, limit, "", "Their roles together need at least")


def _budgets(kind: RobotType, name: str) -> list[float] | None:
    """Budgets of all robots of a type; None if one of them is not limited."""
    budgets = [kind.budget(robot, name) for robot in kind.members]
    known = [budget for budget in budgets if budget is not None]
    return known if len(known) == len(budgets) else None


def _budget_reason(kind: RobotType, name: str, needed: float, there: float, node: str, what: str) -> Reason:
    return Reason(
        rule="budget_exceeded",
        message=f"{what} {needed:g} of {name}; robots of type {kind.label!r} have {there:g}.",
        node=node,
        robot=kind.id,
        found=f"{name} {there:g}",
        needed=f"{name} {needed:g}",
    )
