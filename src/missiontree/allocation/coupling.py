"""Whether anything at all couples the choices; if not, every way through the tree is feasible."""

from __future__ import annotations

from collections import Counter

from missiontree.allocation.flat import Flat


def couples(flat: Flat) -> bool:
    """
    Whether some rule might refuse a way through the tree.

    Rules are budgets that an action uses, links about robots, somebody who must take part, deadlines, teams that could want more robots
    of a type than may be in use, and roles whose actions could name two types at once. Without any of these one robot of each type, or
    one team of them, can do everything, so that a maximum in use refuses nothing. False is certain; true only means that somebody
    has to look.
    """
    simply = any(flat.uses) or flat.links or flat.required or flat.timing is not None
    return bool(simply or _crowded_team(flat) or _torn_role(flat))


def _crowded_team(flat: Flat) -> bool:
    if set(flat.team) <= {None}:
        return False
    filled = {(role, kind) for role, kind in zip(flat.role, flat.robot_type, strict=True) if role >= 0}
    sizes = Counter((flat.team[role], kind) for role, kind in filled if flat.team[role] is not None)
    return any(size > flat.stocks[kind].usable for (_, kind), size in sizes.items())


def _torn_role(flat: Flat) -> bool:
    """Whether one AND reaches the same role from two sides, with more than one type between them."""
    first: dict[int, str] = {}
    filled = zip(flat.role, flat.robot_type, strict=True)
    changing = {role for role, kind in filled if role >= 0 and first.setdefault(role, kind) != kind}
    if not changing:
        return False
    below: dict[int, dict[int, set[str]]] = {}
    for node in range(len(flat.kind) - 1, -1, -1):
        if flat.role[node] in changing:
            below[node] = {flat.role[node]: {flat.robot_type[node]}}
        parts = [below.pop(child) for child in flat.children[node] if child in below]
        if not parts:
            continue
        merged = max(parts, key=len)  # the smaller go into the larger, so that deep trees stay cheap
        for part in parts:
            if part is merged:
                continue
            for role, kinds in part.items():
                if role in merged and flat.kind[node] == "and" and len(merged[role] | kinds) > 1:
                    return True
                merged.setdefault(role, set()).update(kinds)
        below[node] = merged
    return False
