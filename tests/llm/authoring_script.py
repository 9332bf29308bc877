"""A whole dialogue for the paper's first mission, as provider endpoints are made to speak it."""

from __future__ import annotations

from typing import Any

from missiontree.mission.brief import MissionBrief
from tests.builders import brief_of

MISSION = "Reunite mom with her lost child"

INIT = ("HierarchicalTree_init", {"objective": MISSION})
TASKS = (
    "addMultiSubtasks",
    {
        "parentString": MISSION,
        "isPrimitiveList": [False, False],
        "taskNameList": ["Locate", "Reunite"],
        "LogicalConstraint": "AND",
        "constraintPairs": [[0, 1]],
    },
)


def attach(parent: str, routine: str, *arguments: str) -> tuple[str, dict[str, Any]]:
    return (
        "attachMultiSubTrees",
        {
            "parentString": parent,
            "treeNames": [routine],
            "treeArguments": [list(arguments)],
            "LogicalConstraint": "AND",
            "constraintPairs": None,
        },
    )


SEARCH = attach("Locate", "SearchTree", "Child")
BRING = attach("Reunite", "ReachAndTransportTree", "Child", "Mom")
NODES = ["reunite-mom-with-her-lost-child", "locate", "search-child", "reunite", "reach-and-transport-child-mom"]


def paper_brief() -> MissionBrief:
    """The mission, with the paper's team and no scene."""
    return brief_of(MISSION)
