"""The list of what each robot does tells the way, whether the travel is an action or comes before one."""

from missiontree import plan
from missiontree.mission.entity import Entity
from missiontree.mission.fleet import Fleet, RobotType
from missiontree.mission.position import Position
from missiontree.mission.scene import Scene
from missiontree.mission.ways import Road, RoadGraph, RoadNode
from missiontree.reporting.timeline import timeline_rows


def test_every_stretch_of_travel_tells_its_way() -> None:
    """Bend at (3, 0), so that the way from (0, 0) to (3, 4) is 3 m + 4 m."""
    scene = Scene(
        places=(
            Entity(id="depot", kind="place", position=Position(0, 0)),
            Entity(id="shop", kind="place", position=Position(3, 4)),
        ),
        entities=(Entity(id="parcel", kind="object", place="shop"),),
        roads=RoadGraph(
            nodes=(RoadNode(id="bend", position=Position(3, 0)),),
            roads=(Road(ends=("depot", "bend")), Road(ends=("bend", "shop"))),
        ),
    )
    walker = RobotType(
        id="walker",
        count=1,
        capabilities={"reach": 1.0, "carry": 1.0, "search": 1.0},
        limits={"max_speed_mps": 1.0},
        place="depot",
    )
    made = plan("Find the parcel, then bring the parcel to the depot", fleet=Fleet((walker,)), scene=scene)
    texts = [row.text for row in timeline_rows(made.schedules[0], made)]
    assert "travel 7.0 m via depot, bend, shop" in texts  # before the search
    assert any(text.endswith("(7.0 m via shop, bend, depot)") for text in texts)  # the carrying itself


def test_a_robot_that_is_there_already_is_said_to_be() -> None:
    depot = Entity(id="depot", kind="place", position=Position(0, 0))
    walker = RobotType(id="walker", count=1, capabilities={"reach": 1.0}, limits={"max_speed_mps": 1.0}, place="depot")
    made = plan("Go to the depot", fleet=Fleet((walker,)), scene=Scene(places=(depot,)))
    assert [row.text for row in timeline_rows(made.schedules[0], made)][-1].endswith("location (already there)")
