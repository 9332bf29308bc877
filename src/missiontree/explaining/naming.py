"""Who and what a person means by a name in a question: parts of the mission, robot types, robots. A near miss earns suggestions."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping

from missiontree.authoring.matching import same_name, suggestions, without_articles
from missiontree.errors import InputError
from missiontree.mission.call import call_of
from missiontree.mission.fleet import Fleet
from missiontree.mission.tree import MissionNode, MissionTree


def nodes_named(
    name: str, tree: MissionTree, where: str, labels: Mapping[str, str] | None = None
) -> tuple[MissionNode, ...]:
    """
    Nodes that a name means: those of this id, else of this label or call, else all calls of this routine, else all about this
    entity.

    Parameters
    ----------
    name
        What was written.
    tree
        The mission.
    where
        Where it was written, for the message.
    labels
        What entities are called, by id. Default: none are meant by a name of their own.

    Raises
    ------
    InputError
        If there is none, with those that look like it.
    """
    if name in tree.by_id:
        return (tree.by_id[name],)
    asked, called = _loosely(name), labels or {}
    ways: tuple[Callable[[MissionNode], tuple[str, ...]], ...] = (
        lambda node: _names(node, tree),
        lambda node: (node.routine or "",),
        lambda node: tuple(text for one in node.arguments.values() if one in called for text in (one, called[one])),
    )
    for key in ways:
        found = tuple(node for node in tree.nodes if asked and any(_loosely(one) == asked for one in key(node)))
        if found:
            return found
    known = [node.label for node in tree.nodes[1:]] or [tree.root.label]
    raise _unknown(name, "no part of the mission", known, where)


def team_member(name: str, fleet: Fleet, where: str) -> tuple[str, str]:
    """
    The type that a name means, and the robot if the name is a robot's.

    Raises
    ------
    InputError
        If there is none, with those that look like it.
    """
    types = {kind.id: (kind.id, kind.label or kind.id) for kind in fleet.types}
    if (found := _one_of(name, types)) is not None:
        return found, ""
    robots = {robot.id: (robot.id,) for kind in fleet.types for robot in kind.members}
    if (found := _one_of(name, robots)) is not None:
        return fleet.type_of[found].id, found
    known = [label for _, label in types.values()] + list(robots)
    raise _unknown(name, "neither a robot type nor a robot", known, where)


def _one_of(name: str, known: Mapping[str, Iterable[str]]) -> str | None:
    """The id whose names include this one; by letter, else loosely or by one word of them, if that is one alone."""
    if name in known:
        return name
    asked = _loosely(name)
    found = [one for one, names in known.items() if any(_loosely(each) == asked for each in names)]
    found = found or [one for one, names in known.items() if any(asked in _loosely(each).split() for each in names)]
    return found[0] if len(found) == 1 else None


def _names(node: MissionNode, tree: MissionTree) -> tuple[str, ...]:
    if node.routine is None:
        return (node.label,)
    labels = {entity.id: entity.label or entity.id for entity in tree.entities}
    by_id = ", ".join(node.arguments.values())
    by_label = ", ".join(labels.get(entity, entity) for entity in node.arguments.values())
    return node.label, f"{node.routine}({by_id})", f"{node.routine}({by_label})"


def _loosely(name: str) -> str:
    """A name with letter case, articles, and what stands between words aside; ``SearchTree(cat)`` is ``Search(cat)``."""
    call = call_of(name)
    if call is not None:
        parts = [call.routine.removesuffix("Tree"), *call.arguments]
        return "|".join(_loosely(part) for part in parts)
    return " ".join(without_articles(same_name(name).replace("_", " ").replace("-", " "))) or same_name(name)


def _unknown(name: str, what: str, known: list[str], where: str) -> InputError:
    near = suggestions(name, known)
    shown = ", ".join(known[:12]) + (f" and {len(known) - 12} more" if len(known) > 12 else "")
    return InputError(
        f"{name!r:.100} is {what}",
        where=where,
        accepted=shown,
        hint=f"Did you mean {' or '.join(near[:2])}?" if near else "",
    )
