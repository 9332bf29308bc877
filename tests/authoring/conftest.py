"""Missions to build trees for."""

import pytest

from missiontree.authoring.builder import TreeBuilder
from missiontree.authoring.tools import ToolBox
from missiontree.formats.document import read_file
from missiontree.mission.brief import MissionBrief
from missiontree.mission.entity import Entity
from missiontree.mission.fleet import Fleet
from missiontree.mission.scene import Scene
from missiontree.routines.library import built_in
from missiontree.samples.catalogue import FOLDER

REUNITE = "Reunite mom with her lost child"


@pytest.fixture(scope="session")
def fleet() -> Fleet:
    """The paper's team."""
    value = read_file(FOLDER / "fleet.yaml", "fleet")
    assert isinstance(value, Fleet)
    return value


@pytest.fixture(scope="session")
def brief(fleet: Fleet) -> MissionBrief:
    """The paper's first mission, with no scene."""
    return MissionBrief(text=REUNITE, fleet=fleet, routines=built_in())


@pytest.fixture(scope="session")
def scenic(fleet: Fleet) -> MissionBrief:
    """The same mission in a scene: what the scene does not have, only introduceEntity makes known."""
    scene = Scene(
        entities=(
            Entity(id="child", kind="person", label="Tim", aliases=("the boy", "Jüngster")),
            Entity(id="mom", kind="person"),
            Entity(id="dog_1", kind="dog", label="dog"),
            Entity(id="dog_2", kind="dog", label="dog"),
        ),
        places=(Entity(id="gate", label="North Gate"),),
        kinds={"dog": "animal"},
    )
    return MissionBrief(text=REUNITE, fleet=fleet, routines=built_in(), scene=scene)


@pytest.fixture
def box(brief: MissionBrief) -> ToolBox:
    """Functions over a tree that is begun."""
    return begun(brief)


@pytest.fixture
def scenic_box(scenic: MissionBrief) -> ToolBox:
    """The same with a scene."""
    return begun(scenic)


def begun(brief: MissionBrief) -> ToolBox:
    """Functions over a tree that has its root, ``reunite-mom-with-her-lost-child``, and the tasks ``find`` and ``bring``."""
    made = ToolBox(TreeBuilder(brief))
    assert made.call("HierarchicalTree_init", {"objective": REUNITE}).ok
    tasks = {"parentString": REUNITE, "isPrimitiveList": [False, False], "taskNameList": ["Find", "Bring"]}
    assert made.call("addMultiSubtasks", {**tasks, "LogicalConstraint": "AND"}).ok
    return made
