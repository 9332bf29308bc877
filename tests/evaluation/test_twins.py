"""Impossible missions beside possible twins: the offline author and the planner part them, for the thing that was taken."""

from __future__ import annotations

from dataclasses import replace

import pytest

from benchmarks.twin_removal import Removal, removals
from benchmarks.twins import SUITE, Pair, Twin, is_right, pairs_of, shown, table
from missiontree.evaluation.suite import Setting, Suite, load_suite
from missiontree.evaluation.suite_file import SuiteMission
from missiontree.mission.area import Zone
from missiontree.mission.brief import MissionBrief
from missiontree.mission.entity import Entity
from missiontree.mission.fleet import Fleet, RobotType
from missiontree.mission.position import Position
from missiontree.mission.reason import Reason
from missiontree.mission.scene import Scene
from missiontree.mission.ways import Lift, Road, RoadGraph
from missiontree.routines.library import built_in

PAIRS = tuple(pairs_of(load_suite(SUITE)))

SPEED = {"max_speed_mps": 1}
VAN = RobotType(
    id="van", capabilities={"carry": 1, "reach": 1}, limits={"payload_kg": 50, **SPEED}, zones=("yard",), count=1
)
DRONE = RobotType(id="drone", capabilities={"search": 1, "reach": 1}, limits={"payload_kg": 1, **SPEED}, count=2)
SCENE = Scene(
    zones=(Zone(id="yard"),),
    places=(
        Entity(id="shed", kind="place", position=Position(0, 0)),
        Entity(id="barn", kind="place", position=Position(9, 0)),
    ),
    entities=(Entity(id="crate", place="shed", mass_kg=40),),
    roads=RoadGraph(roads=(Road(ends=("shed", "barn")),), lifts=(Lift(id="hoist", stops=("shed", "barn"), ride_s=5),)),
)


def brief(*types: RobotType, scene: Scene = SCENE, text: str = "Bring the crate to the barn.") -> MissionBrief:
    return MissionBrief(text=text, fleet=Fleet(types=types), routines=built_in(), scene=scene)


BRIEF = brief(VAN, DRONE)


@pytest.mark.parametrize("pair", PAIRS, ids=[pair.impossible.mission.id for pair in PAIRS])
def test_the_possible_twin_is_delivered_and_the_other_cannot_be_done_for_what_was_taken(pair: Pair) -> None:
    possible, impossible = pair.possible, pair.impossible
    assert (possible.authored.status, possible.plan.outcome) == ("complete", "delivered")
    assert possible.verdict.differences == ()
    assert impossible.plan.outcome == "cannot_be_done"
    assert impossible.verdict.differences == ()
    (taken,) = pair.taken
    assert taken.is_missing_in(impossible.plan.reasons), impossible.plan.reasons
    # Who lacked things before still lacks them: what is said of the possible twin must not be what settles the other.
    assert possible.plan.grounding is not None
    assert not taken.is_missing_in(possible.plan.grounding.not_offered)


@pytest.mark.parametrize("pair", PAIRS, ids=[pair.impossible.mission.id for pair in PAIRS])
def test_what_the_fleet_decides_is_declared_by_the_author_already(pair: Pair) -> None:
    """Only ways and budgets are looked at later: there the author's tree is the right one."""
    decided = pair.impossible.mission.declined is not None
    assert pair.impossible.authored.status == ("cannot_be_done" if decided else "complete")
    if decided:
        (taken,) = pair.taken
        assert taken.is_missing_in(pair.impossible.authored.reasons)


def test_a_capability_that_nobody_has_any_more_is_taken() -> None:
    after = brief(replace(VAN, capabilities={"reach": 1}), DRONE)
    assert removals(BRIEF, after) == (Removal("capability", "carry", ("van",)),)


def test_a_capability_that_somebody_keeps_is_not_taken_from_the_fleet() -> None:
    # The drone still gets about.
    after = brief(replace(VAN, capabilities={"carry": 1}), DRONE)
    assert [one.kind for one in removals(BRIEF, after)] == ["other"]


def test_one_capability_that_two_types_lose_is_one_thing() -> None:
    van, drone = replace(VAN, capabilities={"carry": 1}), replace(DRONE, capabilities={"search": 1})
    assert removals(BRIEF, brief(van, drone)) == (Removal("capability", "reach", ("van", "drone")),)


def test_a_limit_that_is_lower_is_taken_and_one_that_is_higher_or_gone_is_not() -> None:
    lower, higher, gone = ({"payload_kg": 20, **SPEED}, {"payload_kg": 60, **SPEED}, SPEED)
    assert removals(BRIEF, brief(replace(VAN, limits=lower), DRONE)) == (Removal("limit", "payload_kg", ("van",)),)
    for limits in (higher, gone):
        assert [one.kind for one in removals(BRIEF, brief(replace(VAN, limits=limits), DRONE))] == ["other"]


def test_a_zone_a_road_and_a_lift_are_places() -> None:
    assert SCENE.roads is not None
    (road,), (lift,) = SCENE.roads.roads, SCENE.roads.lifts
    cut = replace(SCENE, roads=replace(SCENE.roads, roads=(replace(road, blocked=True),)))
    still = replace(SCENE, roads=replace(SCENE.roads, lifts=(replace(lift, blocked=True),)))
    assert removals(BRIEF, brief(replace(VAN, zones=()), DRONE)) == (Removal("place", "yard", ("van",)),)
    assert [one.kind for one in removals(BRIEF, brief(replace(VAN, zones=None), DRONE))] == [
        "other"
    ]  # it may go anywhere
    assert removals(BRIEF, brief(VAN, DRONE, scene=cut)) == (Removal("place", "shed - barn"),)
    assert removals(BRIEF, brief(VAN, DRONE, scene=still)) == (Removal("place", "hoist"),)


@pytest.mark.parametrize(
    ("after", "where"),
    [
        (brief(VAN), "fleet.types.drone"),
        (brief(replace(VAN, count=3), DRONE), "fleet.types.van.count"),
        (brief(VAN, DRONE, text="Bring the crate to the shed."), "text"),
        (brief(VAN, DRONE, scene=replace(SCENE, entities=(Entity(id="crate", place="barn", mass_kg=40),))), "scene"),
    ],
    ids=["a type", "a number of robots", "the words", "where something is"],
)
def test_anything_else_that_differs_is_told_with_its_place(after: MissionBrief, where: str) -> None:
    found = removals(BRIEF, after)
    assert found
    assert all(one.kind == "other" and one.name.startswith(where) for one in found)


def test_equal_worlds_differ_in_nothing() -> None:
    assert removals(BRIEF, brief(VAN, DRONE)) == ()


@pytest.mark.parametrize(
    ("taken", "rule", "robot", "needed", "said"),
    [
        (Removal("capability", "carry", ("van",)), "capability_missing", "van", "carry", True),
        (Removal("capability", "carry", ("van",)), "capability_missing", "drone", "carry", False),
        (Removal("capability", "carry", ("van",)), "capability_missing", "van", "reach", False),
        (Removal("limit", "payload_kg", ("van",)), "limit_too_low", "van", "payload_kg 40 (crate mass_kg 40)", True),
        (Removal("limit", "energy_j", ("van",)), "budget_exceeded", "van", "energy_j 900", True),
        (Removal("limit", "payload_kg", ("van",)), "limit_too_low", "van", "payload_kg_max 40", False),
        (Removal("limit", "payload_kg", ("van",)), "capability_missing", "van", "payload_kg 40", False),
        (Removal("place", "yard", ("van",)), "zone_forbidden", "van", "yard", True),
        (Removal("place", "yard", ("van",)), "zone_forbidden", "drone", "yard", False),
        (Removal("place", "hoist"), "zone_forbidden", "van", "hoist", False),
        (Removal("other", "text"), "unreachable", "van", "text", False),
    ],
)
def test_a_reason_says_what_was_taken_only_of_those_who_lost_it(
    taken: Removal, rule: str, robot: str, needed: str, said: bool
) -> None:
    reason = Reason(rule=rule, message="It cannot be done.", robot=robot, needed=needed)
    assert taken.is_said_by(reason) is said


def test_a_way_that_is_blocked_is_named_in_the_message() -> None:
    no_way = Reason(rule="unreachable", message="No way from (0, 0) to (9, 0): the road shed - barn is blocked.")
    assert Removal("place", "shed - barn").is_said_by(no_way)
    assert not Removal("place", "hoist").is_said_by(no_way)


def farm(*missions: SuiteMission, weak: RobotType = VAN) -> Suite:
    fleets = {"weak.yaml": Fleet(types=(weak, DRONE))}
    setting = Setting(id="farm", fleet=BRIEF.fleet, scene=SCENE, routines=built_in(), fleets=fleets, missions=missions)
    return Suite(settings=(setting,))


PLAN = "ReachAndTransport(crate, barn)"
POSSIBLE = SuiteMission(id="crate", say="Bring the crate to the barn.", plan=(PLAN,))
TWIN = SuiteMission(
    id="crate-x",
    say=POSSIBLE.say,
    fleet="weak.yaml",
    declined="impossible",
    because="payload",
    twin="crate",
    removed="payload",
)


def test_the_table_counts_a_pair_that_comes_out_right() -> None:
    pairs = list(pairs_of(farm(POSSIBLE, TWIN, weak=replace(VAN, limits={"payload_kg": 20, **SPEED}))))
    assert [is_right(pair) for pair in pairs] == [True]
    limit, total = (row.split(" | ") for row in table(pairs).splitlines()[3:6:2])
    # One pair; declared, planned and named; how the first reason words it is measured, not promised; none refused, one delivered.
    assert (limit[0], limit[1:5], limit[6:]) == ("| limit", ["1", "1", "1", "1"], ["0", "1 |"])
    assert total[1:] == limit[1:]


def test_a_twin_from_which_nothing_was_taken_is_told() -> None:
    (pair,) = pairs_of(farm(POSSIBLE, TWIN))
    # Both worlds are the same, so the mission that should be impossible is delivered.
    assert pair.taken == ()
    assert pair.impossible.verdict.kind == "wrong"
    assert not is_right(pair)
    assert shown(pair).splitlines() == [
        "crate-x beside crate: Bring the crate to the barn.",
        "  taken: ",
        "  impossible: authored complete, planned delivered: no reason",
        "  possible: authored complete, planned delivered",
    ]
    assert table([pair]).splitlines()[-1] == "| total | 1 | 0 | 0 | 0 | 0 | 0 | 1 |"


def test_a_possible_twin_that_is_refused_is_counted() -> None:
    lost = replace(POSSIBLE, say="Repair the crate.")
    (pair,) = pairs_of(farm(lost, TWIN, weak=replace(VAN, limits={"payload_kg": 20, **SPEED})))
    assert pair.possible.plan.outcome == "cannot_be_done"
    assert not is_right(pair)
    assert table([pair]).splitlines()[-1].endswith("| 1 | 0 |")


def test_a_mission_that_only_planning_refuses_is_beside_the_one_in_its_words() -> None:
    cut = SuiteMission(id="crate-cut", say=POSSIBLE.say, fleet="weak.yaml", plan=(PLAN,), outcome="cannot_be_done")
    other = SuiteMission(id="other", say="Go to the barn.", plan=("Reach(barn)",))
    (pair,) = pairs_of(farm(POSSIBLE, other, cut))
    assert (pair.possible.mission.id, pair.impossible.mission.id) == ("crate", "crate-cut")


def test_a_twin_is_read_with_its_own_fleet() -> None:
    suite = farm(POSSIBLE, TWIN, weak=replace(VAN, limits={"payload_kg": 20, **SPEED}))
    (setting,) = suite.settings
    assert Twin(setting, TWIN).brief.fleet.by_id["van"].limits["payload_kg"] == 20
    assert Twin(setting, POSSIBLE).brief.fleet.by_id["van"].limits["payload_kg"] == 50
