"""Who does what in an alternative, a line per role."""

from __future__ import annotations

from missiontree.mission.alternative import Alternative
from missiontree.mission.grounded import GroundedTree
from missiontree.mission.plan import Plan

MAX_TEAM = 24
LONG_TEAM = 6


def team_lines(tree: GroundedTree, alternative: Alternative, plan: Plan, best: Alternative | None = None) -> list[str]:
    """Who does what, a line per reached role; of a long list, what sets it apart from the best alternative."""
    filled = {entry.role: entry.robot_type for entry in alternative.roles}
    types = plan.brief.fleet.by_id
    line = {
        role: f"{tree.roles[role].label}: {types[who].label if who in types else who}" for role, who in filled.items()
    }
    if best is None or best is alternative or len(line) <= LONG_TEAM:
        lines = list(line.values())
    else:
        usual = {entry.role: entry.robot_type for entry in best.roles}
        other = [text for role, text in line.items() if usual.get(role) != filled[role]]
        without = [f"without {tree.roles[role].label}" for role in usual if role not in filled]
        lines = [
            f"as {best.rank}, but" if other or without else f"as {best.rank}, done in another way",
            *other,
            *without,
        ]
    if len(lines) > MAX_TEAM + 1:
        lines = [*lines[:MAX_TEAM], f"… and {len(lines) - MAX_TEAM} more roles"]
    return lines
