"""Entities that a call makes known: what the scene does not have, at an unknown position."""

from __future__ import annotations

from dataclasses import replace

from missiontree.authoring.answer import refuse
from missiontree.authoring.edits import with_entities
from missiontree.authoring.entities import Cast, known_kinds
from missiontree.authoring.matching import did_you_mean, listed, quoted
from missiontree.authoring.texts import MAX_NAME, check_text
from missiontree.mission.brief import MissionBrief
from missiontree.mission.entity import Entity
from missiontree.mission.reason import Reason
from missiontree.mission.tree import MissionTree

Introduced = tuple[MissionTree, Entity, tuple[Reason, ...]]
"""The tree that knows the entity, the entity, and what is assumed of it."""


def introduced(tree: MissionTree, brief: MissionBrief, name: str, kind: str) -> Introduced:
    """
    The tree with one more entity; or with another kind for one that was introduced before and that nothing uses yet.

    Raises
    ------
    RefusalError
        ``unknown_kind``; ``duplicate``, if the entity is known as it is, or used as what it was taken for; ``ambiguous_name``;
        ``malformed_arguments`` for what is no name.
    """
    check_text(name, "name", MAX_NAME)
    cast = Cast(brief, tree.entities)
    kinds, known = known_kinds(cast.scene), cast.find(name)
    if known is not None and (known not in tree.entities or kind not in kinds or kind == known.kind):
        message = f"{known.label} is known already, as {known.id} of kind {known.kind}."
        raise refuse("duplicate", message, node=known.id, hint="Use it as it is.")
    if kind not in kinds:
        hint = f"{did_you_mean(kind, kinds)} Kinds are: {listed(kinds)}.".strip()
        raise refuse("unknown_kind", f"There is no kind {quoted(kind)}.", node=name, hint=hint)
    if known is None:
        return _with(tree, cast, name, kind)
    if users := [node.id for node in tree.nodes if known.id in node.arguments.values()]:
        message = f"{known.label} is used as one of kind {known.kind} by {listed(users)}."
        raise refuse("duplicate", message, node=known.id, hint="Remove that first (removeSubtask).")
    others = tuple(entity for entity in tree.entities if entity is not known)
    return _with(replace(tree, entities=others), Cast(brief, others), known.label, kind)


def _with(tree: MissionTree, cast: Cast, name: str, kind: str) -> Introduced:
    entity = cast.introduce(name, kind)
    return with_entities(tree, [entity]), entity, tuple(cast.assumptions)
