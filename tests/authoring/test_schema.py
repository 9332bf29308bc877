from typing import Any

import jsonschema

from missiontree.authoring.builder import TreeBuilder
from missiontree.authoring.schema import offered_tools
from missiontree.authoring.tools import TOOLS, ToolBox
from missiontree.mission.brief import MissionBrief
from missiontree.mission.fleet import Fleet, RobotType


def schemas(box: ToolBox) -> dict[str, dict[str, Any]]:
    return {tool.name: dict(tool.parameters) for tool in offered_tools(box.builder)}


def accepts(schema: dict[str, Any], arguments: dict[str, Any]) -> bool:
    return bool(jsonschema.Draft202012Validator(schema).is_valid(arguments))


def attach(routine: str, given: Any, parent: str = "find") -> dict[str, Any]:
    return {"parentString": parent, "treeNames": [routine], "treeArguments": [given], "LogicalConstraint": "AND"}


def test_before_there_is_a_tree_it_can_only_be_begun_or_declined(brief: MissionBrief) -> None:
    assert [tool.name for tool in offered_tools(TreeBuilder(brief))] == [
        "HierarchicalTree_init",
        "listRoutines",
        "declareImpossible",
        "declareUnclear",
    ]


def test_afterwards_everything_else_is_offered(box: ToolBox) -> None:
    box.call("setLink", {"first": "find", "second": "bring"})
    left_out = {"HierarchicalTree_init", "CreateAndAddSubtask", "plotTree", "setTimes"}
    assert list(schemas(box)) == [tool.name for tool in TOOLS if tool.name not in left_out]


def test_nothing_is_taken_away_before_there_is_something(brief: MissionBrief) -> None:
    box = ToolBox(TreeBuilder(brief))
    assert box.call("HierarchicalTree_init", {"objective": "x"}).ok
    assert {"removeSubtask", "setLink", "dropLink"} & set(schemas(box)) == set()


def test_only_links_that_there_are_can_be_dropped(box: ToolBox) -> None:
    assert "dropLink" not in schemas(box)
    box.call("setLink", {"first": "find", "second": "bring"})
    ends = schemas(box)["dropLink"]["properties"]
    assert (ends["first"]["enum"], ends["second"]["enum"]) == (["find"], ["bring"])


def test_every_schema_is_one(box: ToolBox, scenic_box: ToolBox) -> None:
    for schema in [*schemas(box).values(), *schemas(scenic_box).values()]:
        jsonschema.Draft202012Validator.check_schema(schema)


def test_parents_are_the_tasks_there_are(box: ToolBox) -> None:
    box.call("attachMultiSubTrees", attach("Search", ["Child"]))
    made = schemas(box)
    assert made["addMultiSubtasks"]["properties"]["parentString"]["enum"] == [
        "reunite-mom-with-her-lost-child",
        "find",
        "bring",
    ]
    assert made["removeSubtask"]["properties"]["subtask"]["enum"] == ["find", "search-child", "bring"]


def test_routines_are_those_that_some_robot_can_do(brief: MissionBrief) -> None:
    fleet = Fleet((RobotType(id="walker", count=1, capabilities={"reach": 1.0}),))
    box = ToolBox(TreeBuilder(MissionBrief(text="x", fleet=fleet, routines=brief.routines)))
    box.call("HierarchicalTree_init", {"objective": "x"})
    assert schemas(box)["attachMultiSubTrees"]["properties"]["treeNames"]["items"]["enum"] == ["ReachTree"]


def test_a_constrained_model_cannot_name_what_is_not_there(scenic_box: ToolBox) -> None:
    schema = schemas(scenic_box)["attachMultiSubTrees"]
    assert accepts(schema, attach("SearchTree", ["child"]))
    assert accepts(schema, attach("SearchTree", ["child", ["tele_robot"]]))
    assert not accepts(schema, attach("SearchTree", ["grandma"]))
    assert not accepts(schema, attach("SearchTree", ["child", ["tank"]]))
    assert not accepts(schema, attach("FlyTree", ["child"]))
    assert not accepts(schema, attach("SearchTree", ["child"], parent="fetch"))
    scenic_box.call("introduceEntity", {"name": "grandma", "kind": "person"})
    assert accepts(schemas(scenic_box)["attachMultiSubTrees"], attach("SearchTree", ["grandma"]))


def test_without_a_scene_the_nouns_of_the_mission_are_offered(box: ToolBox) -> None:
    """Of "Reunite mom with her lost child" two words name somebody; once used, they go by their ids."""
    items = schemas(box)["attachMultiSubTrees"]["properties"]["treeArguments"]["items"]
    assert items["items"]["anyOf"][0]["enum"] == ["Mom", "Child"]
    box.call("attachMultiSubTrees", attach("Search", ["Child"]))
    items = schemas(box)["attachMultiSubTrees"]["properties"]["treeArguments"]["items"]
    assert items["items"]["anyOf"][0]["enum"] == ["child", "Mom"]


def test_kinds_of_entities_and_of_links_are_kept_apart(scenic_box: ToolBox) -> None:
    made = schemas(scenic_box)
    assert made["introduceEntity"]["properties"]["kind"]["enum"] == ["person", "animal", "object", "place", "dog"]
    assert made["setLink"]["properties"]["kind"]["enum"] == [
        "Precedence",
        "SameRobot",
        "DifferentRobot",
        "Until",
        "HandOver",
    ]


def test_what_the_schema_lets_through_is_not_refused_for_its_form(scenic_box: ToolBox) -> None:
    call = attach("TransportTree", ["child", "gate"]) | {"constraintPairs": [["find", 0], [0, "bring", "Until"]]}
    assert accepts(schemas(scenic_box)["attachMultiSubTrees"], call)
    answer = scenic_box.call("attachMultiSubTrees", call)
    # The first pair links Find with what stands below it: sound in form, refused for what it says.
    assert [reason.rule for reason in answer.reasons] == ["contained"]
