"""Which routines have actions without an end of their own, and which until links therefore mean something."""

from __future__ import annotations

from missiontree.mission.routine import Routine, RoutineLibrary
from missiontree.mission.tree import Link, MissionTree


def is_open_ended(routine: Routine, library: RoutineLibrary) -> bool:
    """Whether some way of a routine has an open-ended action; the parts of a composed one count."""
    waiting, seen = [routine], {routine.id}
    while waiting:
        one = waiting.pop()
        if any(step.open_ended for branch in one.branches for role in branch.roles for step in role.actions):
            return True
        for part in one.parts:
            if part.routine in library.by_id and part.routine not in seen:
                seen.add(part.routine)
                waiting.append(library.by_id[part.routine])
    return False


def pointless_until(tree: MissionTree, link: Link, library: RoutineLibrary) -> bool:
    """Whether nothing below the first node of an until link could last until anything; a task that is still open may."""
    if link.kind != "until":
        return False
    waiting = [tree.by_id[link.first]]
    while waiting:
        node = waiting.pop()
        routine = library.by_id.get(node.routine or "")
        unfinished = node.routine is None and not node.children
        if unfinished or (routine is not None and is_open_ended(routine, library)):
            return False
        waiting.extend(tree.by_id[child] for child in node.children)
    return True
