"""How an author that reads plain language understood a mission: clauses, who and what is meant, order, what was taken for granted."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from rich.console import Group, RenderableType
from rich.padding import Padding
from rich.table import Table
from rich.text import Text

from missiontree.mission.entity import Entity
from missiontree.mission.plan import Plan
from missiontree.mission.tree import MissionTree
from missiontree.reporting.text import reason_line, render, said_once, words
from missiontree.reporting.tree.shape import link_words, shape_of


def reading_text(plan: Plan, width: int = 100) -> str:
    """The reading as plain text, without colour."""
    return render(reading_view(plan), width)


def reading_view(plan: Plan) -> Group:
    """
    The reading of a plan's mission.

    Clauses come with the method or routine that matched each and what its slots were filled with; entities with their kind and where
    that is known from; then the order, what was not understood, what was added, and every assumption.
    """
    return Group(
        Text.assemble(("Reading: ", "bold"), words(plan.brief.text.strip() or "(no words)", "bold")), *_parts(plan)
    )


def _parts(plan: Plan) -> Iterator[RenderableType]:
    clauses = [Text.assemble(f"{number}. ", words(line)) for number, line in enumerate(plan.provenance.reading, 1)]
    yield from _titled("Clauses", clauses)
    if plan.tree is not None:
        yield from _titled("Who and what is meant", [_entities(plan)] if _named(plan.tree) else [])
        order = [Text(line) for line in link_words(shape_of(plan.tree))]
        yield from _titled("Order", order or ([Text("none is said")] if _is_built(plan) else []))
    yield from _titled("Why it is not planned", [reason_line(reason) for reason in said_once(plan.reasons)])
    yield from _titled("Look at", [reason_line(reason) for reason in plan.findings])
    yield from _titled("Done on your behalf", [reason_line(reason) for reason in plan.notices])
    yield from _titled("Assumed", [reason_line(reason) for reason in plan.assumptions])


def _is_built(plan: Plan) -> bool:
    """Whether the tree holds all that was read; one that was left unfinished says nothing about order."""
    return plan.outcome not in {"incomplete", "cannot_be_done"}


def _titled(title: str, body: Sequence[RenderableType]) -> Iterator[RenderableType]:
    if body:
        yield Text("")
        yield Text(title, style="bold")
        yield Padding(Group(*body), (0, 0, 0, 2), expand=False)


def _named(tree: MissionTree) -> list[str]:
    """Ids of the entities that the routines of a tree are about, each once, in the order of the tree."""
    found = (entity for node in tree.nodes if node.routine is not None for entity in node.arguments.values())
    return list(dict.fromkeys(found))


def _entities(plan: Plan) -> Table:
    """Name, kind and origin, a row per entity."""
    assert plan.tree is not None
    scene = plan.brief.world.extended(plan.tree.entities)
    introduced = {entity.id for entity in plan.tree.entities}
    declared = {entity.id for entity in plan.brief.entities}
    table = Table(box=None, padding=(0, 2, 0, 0), header_style="dim")
    for name in ("name", "kind", "known from", "position"):
        table.add_column(name)
    for name in _named(plan.tree):
        entity = scene.by_id[name]
        origin = "the words" if name in introduced else "the mission file" if name in declared else "the scene"
        table.add_row(words(entity.label), words(entity.kind), origin, words(_where(entity, plan)))
    return table


def _where(entity: Entity, plan: Plan) -> str:
    assert plan.tree is not None
    scene = plan.brief.world.extended(plan.tree.entities)
    if entity.place is not None:
        return f"at {scene.by_id[entity.place].label}"
    return {"known": "known"}.get(scene.whereabouts(entity).source, scene.whereabouts(entity).source.replace("_", " "))
