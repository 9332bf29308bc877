"""The list of what each robot does tells the way, whether the travel is an action or comes before one."""

from hypothesis import given, settings
from hypothesis import strategies as st

from missiontree import plan
from missiontree.mission.entity import Entity
from missiontree.mission.fleet import Fleet, Robot, RobotType
from missiontree.mission.plan import Plan
from missiontree.mission.position import Position
from missiontree.mission.scene import Scene
from missiontree.mission.ways import Road, RoadGraph, RoadNode
from missiontree.reporting.gantt.reading import content_of
from missiontree.reporting.text import render
from missiontree.reporting.timeline.bars import bars as bars_of
from missiontree.reporting.timeline.view import timeline, timeline_rows
from tests.reporting.charts import planned, plans, worded
from tests.scheduling.instances import Part, at, mission, move, robots, scene, work


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


def shown(made: Plan, width: int = 100) -> list[str]:
    return render(timeline(made.schedules[0], made), width).splitlines()


def test_bars_stand_on_one_scale_with_their_axis() -> None:
    """A takes 20 + 60 s, B 20 s after it: of 60 characters 12, 36 and 12."""
    instance = mission([Part("A", "a", [work(20), work(60)]), Part("B", "b", [work(20)])], [("A", "B")])
    lines = shown(planned(instance, Fleet((robots("b"), robots("a")))), 65)
    assert lines[:3] == [
        "b-1  " + " " * 48 + "█" * 12,
        "a-1  " + "█" * 12 + "▓" * 36,
        "     0           20 s        40 s        60 s        80 s   100 s",
    ]


def test_what_is_short_is_never_lost_between_what_is_long() -> None:
    """1 s between two times 500 s is less than a character; it stands in front all the same."""
    instance = mission([Part("A", "a", [work(500), work(1), work(500)])])
    assert "█▓█" in shown(planned(instance, Fleet((robots("a"),))))[0]


def test_ways_moves_and_waits_have_signs_of_their_own() -> None:
    """6 m at 2 m/s to q, a move; 8 m on to p; there work that is done together with B, who comes after 20 s."""
    instance = mission(
        [Part("A", "a", [move("q"), work(5, at="p", sync=0)]), Part("B", "b", [work(20), work(5, sync=0)])]
    )
    lines = shown(planned(instance, Fleet((robots("a", speed=2.0, position=at(0)), robots("b"))), scene(q=6, p=14)), 55)
    assert lines[0] == "a-1  " + "═" * 6 + "─" * 8 + "·" * 26 + "▓" * 10
    assert lines[4:8] == [
        "a-1      0.0   3.0 s  A.0 (6.0 m)",
        "         3.0   7.0 s  travel 8.0 m",
        "         7.0  20.0 s  wait for b-1, to do it together",
        "     ◆  20.0  25.0 s  A.1, with b-1",
    ]
    assert lines[-2] == "█▓ action   ═ move   ─ travel   · waiting   ◆ critical"


def test_the_critical_chain_is_marked_in_the_list_and_explained() -> None:
    instance = mission([Part("A", "a", [work(9)]), Part("B", "b", [work(1)])])
    lines = shown(planned(instance, Fleet((robots("a"), robots("b")))))
    assert "a-1  ◆  0.0  9.0 s  A.0" in lines
    assert "b-1     0.0  1.0 s  B.0" in lines
    assert any("◆ critical chain" in line for line in lines)


def test_very_many_robots_and_rows_are_summed_up() -> None:
    """150 robots with two actions each: 100 bars, 200 of 300 rows."""
    parts = [Part(f"P{number}", "a", [work(1), work(1)]) for number in range(150)]
    lines = shown(planned(mission(parts), Fleet((robots("a", 150),))))
    assert any("… and 50 more robots" in line for line in lines)
    assert any("… and 100 more rows; --json has them all" in line for line in lines)


@given(plans(), st.integers(50, 120))
@settings(max_examples=40)
def test_no_line_is_wider_than_the_terminal(made: Plan, width: int) -> None:
    if made.schedules[0].actions:
        bars = render(bars_of(content_of(made, made.schedules[0]), width), width).splitlines()
        assert len(bars) == len({one.robot for one in made.schedules[0].actions}) + 1
        assert all(len(line) <= width for line in bars)


def test_long_names_of_robots_leave_room_for_bars() -> None:
    """Names of 64 characters on 60: 34 for the name, 2 between, 24 for the bar; what differs is at the end."""
    kind = robots("a", robots=(Robot(id="r" * 63 + "1"), Robot(id="r" * 63 + "2")))
    lines = shown(planned(mission([Part("A", "a", [work(1)]), Part("B", "a", [work(1)])]), Fleet((kind,))), 60)
    assert lines[0].split() == ["r" * 17 + "…" + "r" * 15 + "1", "█" * 24]
    assert lines[1].split()[0].endswith("r2")


def test_names_cannot_steer_the_terminal() -> None:
    instance = worded(mission([Part("A", "a", [work(5)])]), ["\x1b[31mred\x1b[0m\u202e"])
    lines = shown(planned(instance, Fleet((robots("a"),))))
    assert any(line.endswith("5.0 s  red") for line in lines)
