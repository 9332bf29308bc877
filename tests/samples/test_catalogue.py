"""The samples: each is delivered, sound, built as its author meant it, and shows what is said of it."""

from __future__ import annotations

from functools import cache
from itertools import combinations
from math import dist, hypot

import pytest

from missiontree import plan
from missiontree.checking import check
from missiontree.errors import InputError
from missiontree.mission.plan import Plan
from missiontree.mission.position import Position
from missiontree.mission.schedule import ScheduledAction
from missiontree.mission.tree import MissionTree
from missiontree.samples.catalogue import FOLDER, PAPER, SAMPLES, SETTINGS, sample_file, sample_files
from missiontree.samples.dialogues import DIALOGUES

# Written by hand from the words: `&` all of them, `|` exactly one, `<` ends before, `~` lasts until. Groups are tasks of the tree.
TREES: dict[str, tuple[str, set[str]]] = {
    "airport": (
        "ReachAndTransport(wheelchair, mrs_okafor) & "
        "(Transport(transfer_group, gate_5) | ReachAndTransport(passenger_stairs, stand_12))",
        set(),
    ),
    "clinic": (
        "(ReachAndTransport(medicine, nurse_adams) & ReachAndTransport(blood_samples, laboratory)) & "
        "Transport(mr_weber, x_ray)",
        {
            "(ReachAndTransport(medicine, nurse_adams) & ReachAndTransport(blood_samples, laboratory)) < "
            "Transport(mr_weber, x_ray)"
        },
    ),
    "college": (
        "ReachAndTransport(projector, lecture_hall_2) by rover & ReachAndTransport(exam_papers, lecture_hall_1) & "
        "SearchAndFollow(dog)",
        {"SearchAndFollow(dog) ~ ReachAndTransport(projector, lecture_hall_2) by rover"},
    ),
    "depot": (
        "(ReachAndTransport(pallet_1, dock_2) & ReachAndTransport(pallet_2, dock_2) & "
        "ReachAndTransport(pallet_3, dock_2)) & Search(hand_scanner) & ReachAndTransport(hand_scanner, tom)",
        {"Search(hand_scanner) < ReachAndTransport(hand_scanner, tom)"},
    ),
    "harbour": (
        "Tow(freighter, berth_3) & ReachAndTransport(mooring_lines, berth_3) & Inspect(gantry_crane)",
        {
            "Tow(freighter, berth_3) < Inspect(gantry_crane)",
            "ReachAndTransport(mooring_lines, berth_3) < Inspect(gantry_crane)",
        },
    ),
    "home": (
        "Search(glasses) & ReachAndTransport(glasses, grandma) & ReachAndTransport(tea, grandma)",
        {
            "Search(glasses) < ReachAndTransport(glasses, grandma)",
            "ReachAndTransport(glasses, grandma) < ReachAndTransport(tea, grandma)",
        },
    ),
    "museum": (
        "Follow(straggler) & Search(night_guard) & Transport(straggler, exit) & ReachAndTransport(lantern, night_guard)",
        {
            "Follow(straggler) ~ Search(night_guard)",
            "Follow(straggler) < Transport(straggler, exit)",
            "Search(night_guard) < Transport(straggler, exit)",
            "Follow(straggler) < ReachAndTransport(lantern, night_guard)",
            "Search(night_guard) < ReachAndTransport(lantern, night_guard)",
        },
    ),
    "orchard": (
        "(Water(block_1) & Water(block_2) & Water(block_3) & Water(block_4) & Water(block_5)) & "
        "ReachAndTransport(ladder, barn)",
        set(),
    ),
    "tunnel": (
        "MeasureGas(north_drift) by crawler/sled/lamp & Search(surveyor) by crawler/sled/lamp & "
        "ReachAndTransport(surveyor, refuge_chamber) by crawler/sled/lamp",
        {
            "MeasureGas(north_drift) by crawler/sled/lamp < Search(surveyor) by crawler/sled/lamp",
            "Search(surveyor) by crawler/sled/lamp < ReachAndTransport(surveyor, refuge_chamber) by crawler/sled/lamp",
        },
    ),
    "wind_farm": (
        "(Inspect(turbine_1) & Inspect(turbine_2) & Inspect(turbine_3) & Inspect(turbine_4) & Inspect(turbine_5)) & "
        "ReachAndTransport(spare_sensor, van)",
        {
            "(Inspect(turbine_1) & Inspect(turbine_2) & Inspect(turbine_3) & Inspect(turbine_4) & Inspect(turbine_5)) < "
            "ReachAndTransport(spare_sensor, van)"
        },
    ),
}


@cache
def planned(name: str) -> Plan:
    return plan(sample_file(name))


def written(tree: MissionTree, node_id: str) -> str:
    """A node of a tree in the notation above."""
    node = tree.by_id[node_id]
    if node.routine is not None:
        by = "" if node.resources is None else f" by {'/'.join(node.resources)}"
        return f"{node.routine}({', '.join(node.arguments.values())}){by}"
    inner = {"and": " & ", "xor": " | "}[node.gate or "and"].join(written(tree, child) for child in node.children)
    return inner if node_id == tree.root.id else f"({inner})"


def links(tree: MissionTree) -> set[str]:
    signs = {"precedence": "<", "until": "~"}
    return {f"{written(tree, link.first)} {signs[link.kind]} {written(tree, link.second)}" for link in tree.links}


def team(made: Plan, rank: int = 1) -> dict[str, list[str]]:
    """Robot types of the roles of an alternative, by the call they belong to."""
    assert made.tree is not None
    assert made.grounding is not None
    assert made.ranking is not None
    roles: dict[str, list[str]] = {}
    for filled in made.ranking.alternatives[rank - 1].roles:
        source = made.grounding.tree.roles[filled.role].source
        assert source is not None
        roles.setdefault(written(made.tree, source), []).append(filled.robot_type)
    return roles


def done(made: Plan, text: str, rank: int = 1) -> list[ScheduledAction]:
    """The scheduled actions of that text, in the order of their robots' names."""
    assert made.grounding is not None
    tree = made.grounding.tree
    found = [entry for entry in made.schedules[rank - 1].actions if tree.action(entry.leaf).text == text]
    return sorted(found, key=lambda entry: entry.robot)


def refusals(made: Plan, robot: str, rule: str) -> list[str]:
    """What a robot type would need, where it was not offered by that rule."""
    assert made.grounding is not None
    return [reason.needed for reason in made.grounding.not_offered if (reason.robot, reason.rule) == (robot, rule)]


@pytest.mark.parametrize("name", SETTINGS)
def test_a_setting_is_delivered_and_sound(name: str) -> None:
    made = planned(name)
    assert made.outcome == "delivered"
    assert made.schedules
    assert check(made) == ()


@pytest.mark.parametrize("name", SETTINGS)
def test_a_setting_has_the_tree_that_its_words_mean(name: str) -> None:
    tree = planned(name).tree
    assert tree is not None
    assert (written(tree, tree.root.id), links(tree)) == TREES[name]
    assert tree.entities == ()  # everything spoken of is in the scene


@pytest.mark.parametrize("name", SETTINGS)
def test_what_a_setting_leaves_open_is_who_does_it(name: str) -> None:
    made = planned(name)
    assert made.ranking is not None
    assert len(made.ranking.alternatives) > 1
    assert made.ranking.status == "exact"


def test_airport_takes_the_stairs_by_what_the_two_ways_are_worth() -> None:
    # The wheelchair lies where the trolley stands: 5 s to look up, 20 s to load, then (55, 10) m at 1.6 m/s.
    wheelchair = 2 * 0.8 + 2 * 0.9 - 0.005 * (25 + hypot(55, 10) / 1.6)
    # A tractor goes (35, 40) m, loads, and passes the two southern corners of the fuel pit, 40 m apart, at 5 m/s.
    stairs = 2 * 0.7 + 2 * 1.0 - 0.005 * (25 + hypot(35, 40) / 5 + (2 * hypot(50, 10) + 40) / 5)
    made = planned("airport")
    assert made.ranking is not None
    best, *others = made.ranking.alternatives
    assert best.utility == pytest.approx(wheelchair + stairs, abs=2e-6)
    assert team(made) == {
        "ReachAndTransport(wheelchair, mrs_okafor)": ["trolley"],
        "ReachAndTransport(passenger_stairs, stand_12)": ["tractor"],
    }
    assert [team(made, other.rank)["Transport(transfer_group, gate_5)"] for other in others] == [["usher"], ["trolley"]]


def test_clinic_takes_the_lift_and_keeps_runners_out_of_isolation() -> None:
    made = planned("clinic")
    # Porter: 64 m + lift to ward B, 60 m + lift to the laboratory, at 1 m/s; then 10 s of message, 70 m at Mr Weber's 0.6 m/s.
    blood = 5 + (64 + 20) + 20 + (60 + 20)
    weber = 10 + 70 / 0.6 + 20
    assert made.schedules[0].makespan_s == pytest.approx(blood + weber, abs=0.01)
    assert refusals(made, "runner", "zone_forbidden") == ["isolation"]


def test_college_follows_the_dog_until_newton_has_arrived() -> None:
    made = planned("college")
    # Newton: 90 m at 1.5 m/s to the workshop, 20 s to load, 240 m along the ring; no other robot may.
    (follow,) = done(made, "Follow dog")
    assert follow.end_s == pytest.approx(5 + 90 / 1.5 + 20 + 240 / 1.5, abs=0.01)
    (found,) = done(made, "Detect dog")
    assert found.robot == follow.robot  # one robot finds it and stays with it


def test_depot_has_three_carriers_at_work_at_once() -> None:
    made = planned("depot")
    loads = [done(made, f"Carry pallet {number}")[0] for number in (1, 2, 3)]
    assert sorted(load.robot for load in loads) == ["forklift-1", "forklift-2", "mover-1"]
    # The mover is nearest to pallet 2 and stays 5 + 30 / 1.2 + 20 + 36 / 1.2 = 80 s; by then both forklifts carry theirs.
    arrived = done(made, "Get to dock 2 location")
    assert min(entry.end_s for entry in arrived) == pytest.approx(80, abs=0.01)
    assert max(load.start_s for load in loads) < 80
    assert refusals(made, "mover", "limit_too_low") == ["payload_kg 900 (pallet 3 mass_kg 900)"]


def test_harbour_has_two_tugs_that_start_and_end_together() -> None:
    made = planned("harbour")
    fast, tow = done(made, "Make fast to freighter"), done(made, "Tow freighter to berth 3")
    assert [entry.robot for entry in fast] == ["alba", "bruno"] == [entry.robot for entry in tow]
    # Bruno has the longer way: (240, 100) m at 4 m/s. Then past the corner of the sandbank at the freighter's 1.5 m/s.
    start = hypot(240, 100) / 4
    end = start + 45 + (hypot(190, 80) + hypot(70, 80)) / 1.5
    assert [entry.start_s for entry in fast] == pytest.approx([start, start], abs=0.01)
    assert [entry.end_s for entry in tow] == pytest.approx([end, end], abs=0.01)


def test_home_searches_for_what_is_lost_before_it_is_brought() -> None:
    made = planned("home")
    assert [notice.rule for notice in made.notices] == ["search_added", "order_added"]
    (found,) = done(made, "Detect glasses")
    assert found.end_s <= done(made, "Carry glasses")[0].start_s


def test_museum_follows_until_the_guard_is_found_and_not_a_fixed_time() -> None:
    made = planned("museum")
    (follow,), (report,) = done(made, "Follow straggler"), done(made, "Report detection of night guard to server")
    assert follow.end_s == pytest.approx(report.end_s, abs=0.001)
    assert follow.robot != report.robot


@pytest.mark.parametrize("rank", [1, 2, 3, 4])
def test_orchard_divides_the_water_two_blocks_to_a_sprayer(rank: int) -> None:
    # 110 l for a block, 250 l in a tank: 2 blocks each, so 4 for the two sprayers and the fifth for the tanker.
    made = planned("orchard")
    types = [team(made, rank)[f"Water(block_{number})"][0] for number in range(1, 6)]
    assert sorted(types) == ["sprayer"] * 4 + ["tanker"]
    robots = [done(made, f"Water block {number}", rank)[0].robot for number in range(1, 6)]
    assert {robot: robots.count(robot) for robot in robots} == {"sprayer-1": 2, "sprayer-2": 2, "tanker-1": 1}


def test_tunnel_leaves_the_drone_out_and_goes_round_the_fall() -> None:
    made = planned("tunnel")
    assert refusals(made, "drone", "resource_excluded") == ["crawler, sled, lamp"] * 3
    # (185, 62.5) to the bend, 60 m to the north drift, to junction 1, 70 m to junction 2, 40 m to the chamber, at 1.2 m/s.
    (bring,) = done(made, "Get to refuge chamber location")
    way = hypot(15, 2.5) + 60 + hypot(40, 50) + 70 + 40
    assert bring.end_s - bring.start_s == pytest.approx(way / 1.2, abs=0.01)


def test_wind_farm_sends_the_heavy_drone_up_the_high_tower() -> None:
    made = planned("wind_farm")
    assert [team(made)[f"Inspect(turbine_{number})"] for number in range(1, 6)] == [["scout"]] * 4 + [["heavy"]]
    assert refusals(made, "scout", "limit_too_low") == ["max_height_m 160 (turbine 5 height_m 160)"]
    # Four turbines by one scout: 240,000 J for pictures, 50 J for each of more than 1,460 m: above its 300,000 J.
    robots = [done(made, f"Take pictures of turbine {number}")[0].robot for number in range(1, 5)]
    assert set(robots) == {"scout-1", "scout-2"}


def test_the_catalogue_holds_ten_settings_and_the_folders_are_theirs() -> None:
    assert len(SETTINGS) == 10
    assert set(SAMPLES) == {*PAPER, "site", *SETTINGS}
    folders = {file.name for file in FOLDER.iterdir() if (file / "mission.yaml").exists()}
    assert folders == {"project", *SETTINGS}
    labels = {planned(name).brief.world.label for name in SETTINGS}
    assert len(labels) == 10
    assert set(DIALOGUES) & set(SAMPLES) == set(PAPER)  # or a dialogue's name would mean two missions


@pytest.mark.parametrize("name", SAMPLES)
def test_every_file_of_a_sample_explains_itself(name: str) -> None:
    files = sample_files(name)
    assert "mission.yaml" in files
    assert "fleet.yaml" in files
    if name not in PAPER:
        assert "scene.yaml" in files
        assert all(file.read_text(encoding="utf-8").startswith("# ") for file in files.values())


def test_an_unknown_sample_is_refused_with_those_there_are() -> None:
    with pytest.raises(InputError, match=r"no sample 'picnic'(?s:.*)accepted: reunite, (?s:.*)wind_farm"):
        sample_file("picnic")


@pytest.mark.parametrize("name", ["site", *SETTINGS])
def test_nothing_lies_on_top_of_another_on_the_map(name: str) -> None:
    world = planned(name).brief.world
    shown = {entity.id: world.whereabouts(entity).position for entity in world.all_entities if entity.place is None}
    spots = {id_: spot for id_, spot in shown.items() if spot is not None}
    for floor in {spot.floor for spot in spots.values()}:
        here = {id_: _xy(spot) for id_, spot in spots.items() if spot.floor == floor}
        xs, ys = zip(*here.values(), strict=True)
        extent = max(max(xs) - min(xs), max(ys) - min(ys))
        for (one, at), (other, there) in combinations(here.items(), 2):
            assert dist(at, there) >= extent / 18, f"{one} and {other}"


def _xy(spot: Position) -> tuple[float, float]:
    return (spot.x_m, spot.y_m)
