"""A limit as a phrase, and what it takes to loosen it."""

from __future__ import annotations

from missiontree.allocation.flat import AMOUNT_SCALE, Flat
from missiontree.allocation.limits import Limit


def phrase(flat: Flat, limit: Limit) -> str:
    """A limit as a phrase: ``energy_j of type rover (600 each, 2 robots)``."""
    match limit.kind:
        case "robots":
            return f"{limit.name} of type {limit.who} ({_each(flat, limit)})"
        case "type":
            most = _number(flat.stocks[limit.who].totals[limit.name])
            return f"{limit.name} of all robots of type {limit.who} together ({most})"
        case "mission":
            shared = flat.shared[limit.name]
            whose = "in the stock of the scene" if shared.source == "scene" else "of all robots of the mission together"
            return f"{limit.name} {whose} ({_number(shared.limit)})"
        case "max_in_use":
            most_in_use = flat.stocks[limit.who].max_in_use or 0
            return f"at most {most_in_use} robot{'s' if most_in_use > 1 else ''} of type {limit.who} in use"
        case "required":
            return f"{_named(limit)} must take part"
        case "left_out":
            return f"{limit.name} takes no part"
        case "same_robot":
            return f"one robot for {_ends(flat, limit)}"
        case "different_robot":
            why = ", for a hand-over" if limit.nodes in flat.hand_overs else ""
            return f"different robots for {_ends(flat, limit)}{why}"
        case "team":
            return f'different robots for the joint roles of "{_task_of_team(flat, limit.team)}"'


def remedy(flat: Flat, limit: Limit) -> str:
    """What to do to loosen a limit, as a phrase: ``raise energy_j of type rover``."""
    match limit.kind:
        case "robots":
            return f"raise {limit.name} of type {limit.who}"
        case "type":
            return f"raise {limit.name} in the total_limits of type {limit.who}"
        case "mission":
            scene = flat.shared[limit.name].source == "scene"
            return f"raise {limit.name} in the {'stock of the scene' if scene else 'total_limits of the fleet'}"
        case "max_in_use":
            return f"raise max_in_use of type {limit.who}"
        case "required":
            return f"take {_named(limit)} off 'require'"
        case "left_out":
            return f"take {limit.name} off 'without'"
        case "same_robot" | "different_robot":
            link = "hand-over" if limit.nodes in flat.hand_overs else f"{limit.kind} link"
            return f"drop the {link} between {_ends(flat, limit)}"
        case "team":
            return f'have "{_task_of_team(flat, limit.team)}" done with fewer robots at once'


def _named(limit: Limit) -> str:
    return f"type {limit.name}" if limit.name == limit.who else limit.name


def _each(flat: Flat, limit: Limit) -> str:
    each = [budget[limit.name] for budget in flat.stocks[limit.who].budgets if limit.name in budget]
    if not each:
        return "no robot"
    least, most = _number(min(each)), _number(max(each))
    if len(each) == 1:
        return f"{most}, 1 robot"
    return f"{most if least == most else f'{least} to {most}'} each, {len(each)} robots"


def _ends(flat: Flat, limit: Limit) -> str:
    return " and ".join(f'"{flat.label[node]}"' for node in limit.nodes)


def _task_of_team(flat: Flat, team: int) -> str:
    """Label of the lowest node that holds all actions of a team."""
    common: list[int] = []
    for leaf, role in enumerate(flat.role):
        if role >= 0 and flat.team[role] == team:
            above = _from_root(flat, leaf)
            common = [node for node, other in zip(common, above, strict=False) if node == other] if common else above
    return flat.label[common[-1]]


def _from_root(flat: Flat, node: int) -> list[int]:
    way = [node]
    while node > 0:
        node = flat.parent[node]
        way.append(node)
    return way[::-1]


def _number(amount: int) -> str:
    return f"{amount / AMOUNT_SCALE:g}"
