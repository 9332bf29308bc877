"""Every kind of change: it is offered where it may matter, applied to a copy, undone by nothing, and told as an order."""

from __future__ import annotations

import pytest

from missiontree.explaining.case import Case
from missiontree.explaining.changes.families import FAMILIES, applied, candidates, in_words
from missiontree.mission.change import CHANGE_KINDS, Change
from missiontree.mission.tree import Link
from tests.explaining.missions import CARRY, FIND, FLEET, ROADS, SCENE, mission

RICH_FLEET = """
total_limits: {energy_j: 900}
types:
  - {id: rover, label: Rover, count: 3, max_in_use: 1, capabilities: {search: 0.4}, limits: {max_speed_mps: 1}, zones: [],
     available_until_s: 50}
  - {id: arm, label: Arm, capabilities: {carry: 1.0}, limits: {payload_kg: 4, energy_j: 600}, total_limits: {energy_j: 500},
     uses_per_m: {energy_j: 5}, robots: [{id: left, place: dock, remaining: {energy_j: 300}, available_from_s: 20}]}
"""
RICH_SCENE = (
    SCENE
    + """
zones: [{id: ward}]
stock: {energy_j: 100}
resources: [{id: gate}]
keep_outs: [{id: wet, area: {corners: [[10, -1], [11, -1], [11, 1]]}}]
roads:
  roads: [{ends: [dock, hall], blocked: true, types: [rover], one_way: true}]
  lifts: [{id: lift, stops: [dock, hall], ride_s: 1, blocked: true}]
"""
)


def rich() -> Case:
    """A mission with something to change of nearly every kind."""
    request = mission(
        CARRY,
        FIND,
        fleet=RICH_FLEET,
        scene=RICH_SCENE,
        links=(Link("n0", "n1", "same_robot"),),
        resources=("rover",),
        due={"n0": 30.0},
        without=("left",),
        require=("rover",),
        min_quality=0.5,
        return_home=True,
        deadline_s=90.0,
    )
    assert request.tree is not None
    return Case(request.brief, request.tree)


def test_every_kind_of_change_has_a_way_to_be_applied_and_told() -> None:
    assert set(FAMILIES) == set(CHANGE_KINDS)


def test_what_the_mission_states_is_what_may_be_changed() -> None:
    offered = {(change.kind, change.target, change.name) for change in candidates(rich())}
    assert offered >= {
        ("take_off_without", "left", ""),
        ("take_off_require", "rover", ""),
        ("end_anywhere", "", ""),
        ("lower_min_quality", "", ""),
        ("allow_type", "n0", "arm"),
        ("ignore_kinds", "", ""),
        ("drop_link", "n0", "n1"),
        ("extend_deadline", "", ""),
        ("extend_deadline", "n0", ""),
        ("extend_stay", "rover", ""),
        ("come_earlier", "left", ""),
        ("open_way", "dock - hall", ""),
        ("open_way", "dock - hall", "arm"),
        ("open_way", "dock - hall", "both ways"),
        ("open_way", "lift", ""),
        ("lift_keep_out", "wet", ""),
        ("allow_zone", "rover", "ward"),
        ("add_robot", "rover", ""),
        ("raise_in_use", "rover", ""),
        ("raise_capacity", "gate", ""),
        ("raise_total", "", "energy_j"),
        ("raise_total", "arm", "energy_j"),
        ("raise_stock", "", "energy_j"),
        ("raise_limit", "arm", "payload_kg"),
        ("raise_limit", "arm", "energy_j"),
        ("raise_quality", "rover", "search"),
        ("add_capability", "rover", "carry"),
        ("drop_part", "n0", ""),
    }


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (Change(kind="take_off_without", target="left"), "Let left take part (take it off 'without')."),
        (Change(kind="take_off_require", target="rover"), "Do not insist on Rover (take it off 'require')."),
        (Change(kind="end_anywhere"), "Let robots end where they are (return_home: false)."),
        (Change(kind="lower_min_quality", was=0.5, to=0.4), "Ask for a quality of 0.4 instead of 0.5 (min_quality)."),
        (Change(kind="allow_type", target="n0", name="arm"), 'Allow Arm for "Transport(crate, dock)".'),
        (Change(kind="drop_link", target="n0", name="n1"), 'Give up that one robot does both "Transport(crate, dock)" and "Search(Anna)".'),
        (Change(kind="extend_deadline", was=90, to=95.5), "Move the deadline of the mission from 90 s to 95.5 s, 5.5 s later."),
        (Change(kind="extend_stay", target="rover", was=50, to=80), "Keep rover until 80 s instead of 50 s (available_until_s)."),
        (Change(kind="come_earlier", target="left", was=20, to=5), "Have left from 5 s instead of 20 s (available_from_s)."),
        (Change(kind="open_way", target="dock - hall"), "Open the road dock - hall."),
        (Change(kind="open_way", target="dock - hall", name="arm"), "Let Arm use the road dock - hall."),
        (Change(kind="open_way", target="dock - hall", name="both ways"), "Let the road dock - hall be used both ways."),
        (Change(kind="open_way", target="lift"), "Put the lift lift back into service."),
        (Change(kind="lift_keep_out", target="wet"), "Let robots through the keep-out wet."),
        (Change(kind="allow_zone", target="rover", name="ward"), "Let Rover enter the zone ward."),
        (Change(kind="add_robot", target="rover", was=3, to=4), "Add one more Rover."),
        (Change(kind="raise_in_use", target="rover", was=1, to=2), "Let 2 robots of type Rover take part instead of 1 (max_in_use)."),
        (Change(kind="raise_capacity", target="gate", was=1, to=2), "Make room for 2 robots at a time at gate instead of 1."),
        (Change(kind="raise_stock", name="energy_j", was=100, to=150), "Raise the stock of energy_j from 100 to 150."),
        (Change(kind="raise_limit", target="arm", name="payload_kg", was=4, to=12), "Raise payload_kg of Arm from 4 to 12."),
        (Change(kind="add_capability", target="rover", name="carry", to=1), "Give Rover the capability carry (taken at quality 1)."),
        (Change(kind="drop_part", target="n0"), 'Leave out "Transport(crate, dock)".'),
    ],
)  # fmt: skip
def test_a_change_reads_as_an_order_and_changes_a_copy_alone(change: Change, words: str) -> None:
    case = rich()
    changed = applied(case, [change])
    assert in_words(case, [change]) == words
    assert changed != case
    assert case == rich()


def test_a_raised_limit_fills_up_robots_that_have_less_of_their_own() -> None:
    raised = applied(rich(), [Change(kind="raise_limit", target="arm", name="energy_j", was=300, to=450)])
    arm = raised.brief.fleet.by_id["arm"]
    assert (arm.limits["energy_j"], arm.robots[0].remaining["energy_j"]) == (600, 450)


def test_a_new_robot_among_named_ones_starts_where_the_first_does_with_a_name_of_its_own() -> None:
    grown = applied(rich(), [Change(kind="add_robot", target="arm", was=1, to=2)])
    left, new = grown.brief.fleet.by_id["arm"].robots
    assert (new.id, new.place, dict(new.remaining)) == ("arm-new-1", "dock", {})
    assert left.id == "left"


def test_a_part_that_is_left_out_takes_its_links_and_emptied_tasks_along() -> None:
    dropped = applied(rich(), [Change(kind="drop_part", target="n0")])
    assert [node.id for node in dropped.tree.nodes] == ["root", "n1"]
    assert dropped.tree.links == ()
    with pytest.raises(ValueError, match="nothing of the mission would be left"):
        applied(dropped, [Change(kind="drop_part", target="n1")])


def test_a_mission_of_one_part_offers_nothing_to_leave_out() -> None:
    request = mission(CARRY, fleet=FLEET, scene=SCENE + ROADS)
    assert request.tree is not None
    assert not [change for change in candidates(Case(request.brief, request.tree)) if change.kind == "drop_part"]


def test_of_a_grid_the_fewest_cells_that_close_the_way_are_offered() -> None:
    # A wall of two cells, three high; the lowest row has a gap of one cell on its left: two cells there, one cell below.
    scene = """
places: [{id: dock, position: {x_m: 0.5, y_m: 1.5}}, {id: hall, position: {x_m: 4.5, y_m: 1.5}}]
entities: [{id: crate, mass_kg: 1, place: hall}]
grid: {rows: ["..##.", "..##.", "...#."], cell_m: 1}
"""
    request = mission(CARRY, scene=scene)
    assert request.tree is not None
    case = Case(request.brief, request.tree)
    (cleared,) = [change for change in candidates(case) if change.kind == "clear_cells"]
    assert cleared.target == "2,3"
    assert in_words(case, [cleared]) == "Clear the cell of the grid at (3.5, 0.5)."
    changed = applied(case, [cleared])
    assert changed.brief.world.grid is not None
    assert changed.brief.world.grid.rows == ("..##.", "..##.", ".....")
