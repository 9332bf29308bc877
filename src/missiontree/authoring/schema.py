"""
The tools as offered at one turn: their JSON Schemas hold the state, so that a constrained model cannot name what is not there.

Parents are the tasks there are, routines those some robot can do, agents the entities there are.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

from missiontree.authoring.builder import TreeBuilder
from missiontree.authoring.entities import known_kinds, nouns_said
from missiontree.authoring.tools import TOOLS, TreeFunction
from missiontree.llm.chat import Tool

_BEFORE_THE_TREE = frozenset({"HierarchicalTree_init", "listRoutines", "declareImpossible", "declareUnclear"})
_NOT_OFFERED = frozenset({"CreateAndAddSubtask", "plotTree", "setTimes"})
"""
Not worth their tokens at every turn: ``addMultiSubtasks`` adds one task as well, and a picture is for people. Words that name a time
are declined (``declareUnclear``); times come from goals that are stated formally. All of these can be called.
"""
Schema = dict[str, Any]


def offered_tools(builder: TreeBuilder) -> tuple[Tool, ...]:
    """
    The tools of this turn: those that can do something.

    Before there is a tree it can only be begun, or declined. What takes something away is offered once there is something to take.
    Every other function can be called as well; see ``_NOT_OFFERED``.
    """
    tree = builder.tree
    useless = {"HierarchicalTree_init", *_NOT_OFFERED}
    if tree is not None and len(tree.nodes) == 1:
        useless |= {"removeSubtask", "setLink"}
    if tree is not None and not tree.links:
        useless.add("dropLink")
    now = [tool for tool in TOOLS if (tool.name in _BEFORE_THE_TREE if tree is None else tool.name not in useless)]
    narrowed = _narrowed(builder)
    return tuple(Tool(tool.name, tool.description, schema_of(tool, narrowed)) for tool in now)


def schema_of(tool: TreeFunction, narrowed: Mapping[str, Schema]) -> Schema:
    """
    JSON Schema of a function's arguments.

    Parameters
    ----------
    tool
        The function.
    narrowed
        Schemas, by ``argument`` or ``function.argument``, that go before the argument's own since they know the state.
    """
    properties = {}
    for known in tool.parameters:
        schema = narrowed.get(f"{tool.name}.{known.name}") or narrowed.get(known.name) or known.shape.schema
        properties[known.name] = {**schema, "description": known.says}
    required = [known.name for known in tool.parameters if not known.optional]
    return {"type": "object", "properties": properties, "required": required, "additionalProperties": False}


def _narrowed(builder: TreeBuilder) -> dict[str, Schema]:
    tree, library = builder.tree, builder.brief.routines
    if tree is None:
        return {}
    tasks = [node.id for node in tree.nodes if node.routine is None]
    nodes = [node.id for node in tree.nodes]
    able = [routine for routine in library.routines if builder.offers[routine.id].able]
    return {
        "parentString": _one_of(tasks),
        "subtask": _one_of(nodes[1:]),
        "first": _one_of(nodes),
        "second": _one_of(nodes),
        "introduceEntity.kind": _one_of(known_kinds(builder.cast.scene)),
        "treeNames": {"type": "array", "items": _one_of(routine.wire_name for routine in able), "minItems": 1},
        "treeArguments": _calls(builder),
        "dropLink.first": _one_of(dict.fromkeys(link.first for link in tree.links)),
        "dropLink.second": _one_of(dict.fromkeys(link.second for link in tree.links)),
    }


def _calls(builder: TreeBuilder) -> Schema:
    """Arguments in their order. The form by name is accepted as well; one form is offered, since two are twice as long."""
    agents = [entity.id for entity in builder.cast.everyone]
    if builder.brief.scene is None:
        called = {spelling for entity in builder.cast.everyone for spelling in (entity.id, entity.label.casefold())}
        agents += [noun.capitalize() for noun in nouns_said(builder.brief.text) if noun not in called]
    resources = {"type": "array", "items": _one_of(builder.brief.fleet.by_id), "minItems": 1}
    in_order = {"type": "array", "items": {"anyOf": [_one_of(agents), resources]}, "minItems": 1}
    return {"type": "array", "items": in_order, "minItems": 1}


def _one_of(names: Iterable[str]) -> Schema:
    every = list(names)
    return {"type": "string", "enum": every} if every else {"type": "string"}
