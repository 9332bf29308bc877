"""Trees in several states with the tools offered at each, and values drawn from schemas."""

from __future__ import annotations

import json
import random
from collections.abc import Mapping
from typing import Any

from missiontree.authoring.builder import TreeBuilder
from missiontree.authoring.schema import offered_tools
from missiontree.authoring.tools import ToolBox
from missiontree.formats.document import read_file
from missiontree.mission.brief import MissionBrief
from missiontree.mission.entity import Entity
from missiontree.mission.fleet import Fleet
from missiontree.mission.scene import Scene
from missiontree.routines.library import built_in
from missiontree.samples.catalogue import FOLDER

REUNITE = "Reunite mom with her lost child"
ROOT = "reunite-mom-with-her-lost-child"
STATES = ("no tree", "root only", "several nodes", "scene")


def builder_at(state: str) -> TreeBuilder:
    """A builder in one of the states."""
    fleet = read_file(FOLDER / "fleet.yaml", "fleet")
    assert isinstance(fleet, Fleet)
    known = {"child": "person", "mom": "person", "dog_1": "animal"}
    scene = Scene(entities=tuple(Entity(id=name, kind=kind) for name, kind in known.items()))
    brief = MissionBrief(text=REUNITE, fleet=fleet, routines=built_in(), scene=scene if state == "scene" else None)
    builder = TreeBuilder(brief)
    box = ToolBox(builder)
    if state != "no tree":
        assert box.call("HierarchicalTree_init", {"objective": REUNITE}).ok
    if state in {"several nodes", "scene"}:
        tasks = {"parentString": ROOT, "isPrimitiveList": [False] * 2, "taskNameList": ["Find", "Bring"]}
        assert box.call("addMultiSubtasks", {**tasks, "LogicalConstraint": "AND"}).ok
        search = {"parentString": "find", "treeNames": ["SearchTree"], "treeArguments": [["child"]]}
        assert box.call("attachMultiSubTrees", {**search, "LogicalConstraint": "AND"}).ok
    return builder


OFFERED = {state: offered_tools(builder_at(state)) for state in STATES}


def drawn(schema: Mapping[str, Any], rng: random.Random) -> Any:
    """A value of a schema as the engine's grammar would have it: keys in the schema's order, everything else by chance."""
    if "anyOf" in schema:
        return drawn(rng.choice(schema["anyOf"]), rng)
    if "const" in schema:
        return schema["const"]
    if "enum" in schema:
        return rng.choice(schema["enum"])
    match schema["type"]:
        case "string":
            length = rng.randint(schema["minLength"], schema["maxLength"])
            return "".join(rng.choice('ab"\\é ü\u2028\U0001f916{}[],:0/') for _ in range(length))
        case "integer":
            return rng.randint(schema["minimum"], schema["maximum"])
        case "array":
            return [drawn(schema["items"], rng) for _ in range(rng.randint(schema["minItems"], schema["maxItems"]))]
        case "object":
            known, needed = schema["properties"], schema["required"]
            return {name: drawn(of, rng) for name, of in known.items() if name in needed or rng.random() < 0.5}
        case "boolean":
            return rng.random() < 0.5
        case "null":
            return None
    raise AssertionError(schema)


def longest(schema: Mapping[str, Any]) -> int:
    """Letters of the longest text of a schema, written without blanks; fails on whatever has no bound."""
    if "anyOf" in schema:
        return max(longest(branch) for branch in schema["anyOf"])
    if values := schema.get("enum", [schema["const"]] if "const" in schema else []):
        return max(len(json.dumps(value, ensure_ascii=False)) for value in values)
    match schema["type"]:
        case "string":
            return 2 + 2 * int(schema["maxLength"])  # a quotation mark or a backslash takes two
        case "integer":
            return max(len(str(schema["minimum"])), len(str(schema["maximum"])))
        case "array":
            return 2 + int(schema["maxItems"]) * (1 + longest(schema["items"]))
        case "object":
            assert schema["additionalProperties"] is False
            return 2 + sum(len(name) + 4 + longest(of) for name, of in schema["properties"].items())
        case "boolean":
            return 5
        case "null":
            return 4
    raise AssertionError(f"no bound is known for {schema}")
