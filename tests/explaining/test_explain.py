"""Missions with one fault each: the cause is told, the least change that mends it is found, and its plan is sound."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from missiontree.authoring.outcome import Authored
from missiontree.briefing import Request, request_from
from missiontree.checking import check
from missiontree.errors import InputError
from missiontree.explaining.case import Case
from missiontree.explaining.changes.families import applied
from missiontree.explaining.explain import Explained, explain, explain_authored, explained, request_of
from missiontree.explaining.finding import Found
from missiontree.explaining.nearest import nearest_part
from missiontree.explaining.repairing import Repairs, planned
from missiontree.formats.document import read_text
from missiontree.mission.change import Change
from missiontree.mission.control import Control
from missiontree.mission.costs import Costs, Price
from missiontree.mission.explanation import Shortfall
from missiontree.mission.routine import RoutineLibrary
from missiontree.mission.tree import Link, MissionNode
from missiontree.planner import plan_authored
from tests.explaining.missions import CARRY, FIND, FLEET, ROADS, SCENE, mission


def told_of(request: Request, most: int = 12) -> Explained:
    """The explanation of a mission whose tree is handed in; every plan in it is sound."""
    authored = Authored(status="complete", tree=request.tree, author="given")
    known = explain_authored(request, authored, Control(), most)
    for repair in known.told.repairs:
        assert repair.plan is not None
        assert repair.plan.outcome == "delivered"
        assert check(repair.plan) == ()
    return known


def words_of(known: Explained) -> list[str]:
    return [repair.words for repair in known.told.repairs]


def test_a_payload_that_is_too_small_is_told_with_both_numbers_and_raised_to_what_is_needed() -> None:
    known = told_of(mission(CARRY, fleet=FLEET.replace("payload_kg: 15", "payload_kg: 4")))
    (cause,) = known.told.causes
    assert (cause.stage, cause.node, cause.shortfall) == (
        "tree",
        "n0",
        Shortfall(quantity="payload_kg", has=4, needs=12),
    )
    assert cause.words == 'No robot of this fleet can do "Transport(crate, dock)".'
    assert [(reason.rule, reason.robot) for reason in cause.reasons] == [
        ("limit_too_low", "arm"),
        ("capability_missing", "rover"),
        ("kind_refused", ""),
    ]
    assert known.told.cheapest == "proven"
    by_words = {repair.words: repair for repair in known.told.repairs}
    raised = by_words["Raise payload_kg of Arm from 4 to 12."]
    assert raised.claim == "smallest_proven"
    assert raised.cost == 4 + 2 * 2  # 4 to 12 is two shares more
    assert "Give Rover the capability carry (taken at quality 1)." in by_words


def test_energy_that_does_not_last_once_travel_is_counted_is_found_to_the_thousandth() -> None:
    # Approach 30 m and the way back 30 m: 60 m at 5 J are 300 J. Allocation knows of the way back alone, 150 J.
    known = told_of(mission(CARRY, fleet=FLEET.replace("energy_j: 600", "energy_j: 200")))
    assert known.told.causes[0].stage == "schedule"
    assert "Raise energy_j of Arm from 200 to 300." in words_of(known)
    assert "Raise energy_j of Arm from 100 to 300." in words_of(
        told_of(mission(CARRY, fleet=FLEET.replace("energy_j: 600", "energy_j: 100")))
    )


def test_a_deadline_is_moved_by_the_least_that_is_enough() -> None:
    # The arm drives 30 m, carries for 20 s and drives back: 30 + 20 + 30 = 80 s at 1 m/s.
    known = told_of(mission(CARRY, deadline_s=50.0))
    assert "Move the deadline of the mission from 50 s to 80 s, 30 s later." in words_of(known)
    assert known.told.causes[0].rule == "deadline_missed"
    moved = next(repair for repair in known.told.repairs if repair.changes[0].kind == "extend_deadline")
    assert moved.claim == "smallest_proven"
    assert moved.makespan_s == 80


def test_the_road_that_cuts_a_place_off_is_named_and_opened() -> None:
    known = told_of(mission(CARRY, scene=SCENE + ROADS.replace("hall]", "hall], blocked: true")))
    assert "the road dock - hall is blocked" in known.told.causes[0].reasons[0].message
    assert words_of(known)[0] == "Open the road dock - hall."


def test_a_wall_in_a_grid_is_opened_where_it_is_thinnest() -> None:
    scene = """
places: [{id: dock, position: {x_m: 0.5, y_m: 1.5}}, {id: hall, position: {x_m: 4.5, y_m: 1.5}}]
entities: [{id: crate, mass_kg: 12, place: hall}]
grid: {rows: ["..##.", "..##.", "...#."], cell_m: 1}
"""
    assert words_of(told_of(mission(CARRY, scene=scene))) == ["Clear the cell of the grid at (3.5, 0.5)."]


def test_robots_that_cannot_be_home_in_time_may_end_where_they_are() -> None:
    # Anna is 30 m away: 5 s, then 30 s there, 60 s and 2 s of search are 97 s, and 30 s home are 127 s.
    known = told_of(mission(FIND, deadline_s=100.0, return_home=True))
    assert words_of(known)[:2] == [
        "Let robots end where they are (return_home: false).",
        "Move the deadline of the mission from 100 s to 127 s, 27 s later.",
    ]


def test_two_faults_at_once_are_mended_together_and_nothing_can_be_spared() -> None:
    fleet = FLEET.replace("payload_kg: 15", "payload_kg: 4").replace("search: 0.8, ", "")
    known = told_of(mission(CARRY, FIND, ("Search", {"agent": "crate"}), fleet=fleet))
    assert [cause.node for cause in known.told.causes] == ["n0", "n1", "n2"]
    for repair in known.told.repairs:
        assert len(repair.changes) == 2
        for spared in repair.changes:
            rest = [change for change in repair.changes if change != spared]
            assert known.case is not None
            case = applied(known.case, rest)
            request = replace(known.request, brief=case.brief, tree=case.tree)
            plan = plan_authored(request, Authored(status="complete", tree=case.tree, author="given"), Control())
            assert plan.outcome == "cannot_be_done"
    assert known.told.repairs


def test_what_the_user_prices_high_comes_last() -> None:
    dear = Costs({"add_capability": Price(fixed=100), "raise_limit": Price(fixed=50, per_share=0)})
    request = replace(mission(CARRY, fleet=FLEET.replace("payload_kg: 15", "payload_kg: 4")), costs=dear)
    assert [repair.cost for repair in told_of(request).told.repairs] == [50, 100]


def test_where_one_robot_is_too_few_for_two_parts_that_is_told() -> None:
    """Anna and the crate are to be searched for by different robots; the rover alone can search, and there is one."""
    request = mission(FIND, ("Search", {"agent": "crate"}), links=(Link("n0", "n1", "different_robot"),))
    (cause,) = told_of(request).told.causes
    few = [reason for reason in cause.reasons if reason.rule == "too_few_robots"]
    assert [(one.robot, one.message) for one in few] == [("rover", "Rover can do both parts, and there is one.")]
    assert {reason.robot for reason in cause.reasons if reason.rule == "capability_missing"} == {"arm"}


def test_who_lacks_what_is_told_of_a_part_with_choices_too() -> None:
    """Anna is searched for or reached, by another robot than the one that carries the crate; and the rover alone can do any of it."""
    both = FLEET.replace("carry: 1.0", "lift: 1.0").replace("reach: 0.8", "reach: 0.8, carry: 0.9")
    request = mission(CARRY, FIND, ("Reach", {"agent": "Anna"}), fleet=both)
    assert request.tree is not None
    nodes = {node.id: node for node in request.tree.nodes}
    inner = MissionNode(id="meet", label="Meet Anna", gate="xor", children=("n1", "n2"))
    root = replace(nodes["root"], children=("n0", "meet"))
    links = (Link("n0", "meet", "different_robot"),)
    tree = replace(request.tree, nodes=(root, nodes["n0"], inner, nodes["n1"], nodes["n2"]), links=links)
    (cause,) = told_of(replace(request, tree=tree)).told.causes
    assert "different robots" in cause.words
    lacking = {(reason.node, reason.robot, reason.needed) for reason in cause.reasons if reason.robot}
    too_few = ("", "rover", "2")
    assert lacking == {("n0", "arm", "carry"), ("n1", "arm", "search"), ("n2", "arm", "reach"), too_few}


def test_links_that_no_robot_can_keep_are_given_up() -> None:
    known = told_of(mission(CARRY, FIND, links=(Link("n0", "n1", "same_robot"),)))
    lacking = {
        (one.robot, one.node, one.needed) for one in known.told.causes[0].reasons if one.rule == "capability_missing"
    }
    assert lacking == {("rover", "n0", "carry"), ("arm", "n1", "search")}  # each part has somebody, and nobody both
    assert words_of(known)[0].startswith("Give up that one robot does both")
    assert any(repair.changes[0].kind == "add_capability" for repair in known.told.repairs)


def test_a_link_that_leaves_only_robots_which_lack_something_is_part_of_the_cause() -> None:
    """
    Who searches carries, too, and only the arm can do both; 60 m to the hall and back cost 300 J, and it has 200 J.

    Without the link the rover carries, and the arm needs 150 J to search in the hall.
    """
    fleet = FLEET.replace("search: 0.8, reach: 0.8", "carry: 0.9").replace("carry: 1.0", "carry: 1.0, search: 0.8")
    fleet = fleet.replace("energy_j: 600", "energy_j: 200")
    request = mission(CARRY, FIND, fleet=fleet, links=(Link("n1", "n0", "same_robot"),), check_kinds=False)
    (cause,) = told_of(request).told.causes
    assert (cause.stage, cause.shortfall) == ("schedule", Shortfall(quantity="energy_j", has=200, needs=300))
    asked = 'The mission asks that one robot does both "Search(Anna)" and "Transport(crate, dock)"; without that it can be done.'
    assert [reason.message for reason in cause.reasons if reason.rule == "same_robot_binds"] == [asked]


def test_a_deadline_that_leaves_only_ways_which_clash_stands_behind_the_clash() -> None:
    """
    The crate is fetched first; then the same robot searches for Anna, which the arm cannot, or fetches a beam from 200 m away at 1 m/s.

    Both loads take longer than the mission has, so that the link is all that seems to stand in the way; with more time the arm does both.
    """
    beam = SCENE.replace("entities:", "  - {id: yard, position: {x_m: 200, y_m: 0}}\nentities:")
    beam += "  - {id: beam, mass_kg: 10, place: yard}\n"
    request = mission(CARRY, FIND, ("Transport", {"agent": "beam", "location": "dock"}), scene=beam, check_kinds=False)
    assert request.tree is not None
    nodes = {node.id: node for node in request.tree.nodes}
    inner = MissionNode(id="then", label="Then", gate="xor", children=("n1", "n2"))
    root = replace(nodes["root"], children=("n0", "then"))
    links = (Link("n0", "then"), Link("n0", "then", "same_robot"))
    tree = replace(request.tree, nodes=(root, nodes["n0"], inner, nodes["n1"], nodes["n2"]), links=links)
    brief = replace(request.brief, deadline_s=130.0)
    known = told_of(replace(request, tree=tree, brief=brief))
    (cause,) = known.told.causes
    assert cause.rule == "limits_clash"
    assert "one robot" in cause.words
    late = next(reason for reason in cause.reasons if reason.rule == "deadline_missed")
    assert "must end by 130 s" in late.message
    assert any(repair.changes[0].kind == "extend_deadline" for repair in known.told.repairs)


def test_joint_work_kept_for_one_type_is_opened_to_all_where_no_single_type_is_enough() -> None:
    """A beam takes two to carry. The arms may not, for it is kept for the drone; of arms and rovers there is one each."""
    both = FLEET.replace("search: 0.8, reach: 0.8", "lift: 0.9").replace("carry: 1.0", "lift: 1.0")
    drone = "  - {id: drone, count: 1, capabilities: {fly: 1.0}, limits: {max_speed_mps: 2}, place: dock}\n"
    heavy = ("LiftTogether", {"agent": "crate"})
    known = told_of(mission(heavy, fleet=both + drone, resources=("drone",), routines=lifting()))
    assert words_of(known)[0] == 'Allow any robot type for "LiftTogether(crate)".'
    two_arms = both.replace("id: arm, label: Arm, count: 1", "id: arm, label: Arm, count: 2")
    words = words_of(told_of(mission(heavy, fleet=two_arms + drone, resources=("drone",), routines=lifting())))
    assert 'Allow Arm for "LiftTogether(crate)".' in words
    assert not any("any robot type" in one for one in words)


def lifting() -> RoutineLibrary:
    """One routine: two robots that can lift do it together."""
    file = read_text(
        """
routines:
  - id: LiftTogether
    purpose: Lift {agent}.
    arguments: [{name: agent, kinds: [object]}]
    branches:
      - name: lift
        roles:
          - {name: left, rating: lift, actions: [{name: up, text: "Lift {agent}", at: agent, duration_s: 5, sync: up}]}
          - {name: right, rating: lift, actions: [{name: up, text: "Lift {agent}", at: agent, duration_s: 5, sync: up}]}
""",
        "routines",
    )
    return RoutineLibrary(routines=file.routines)


def test_a_mission_that_can_be_done_has_no_causes() -> None:
    told = told_of(mission(CARRY)).told
    assert (told.outcome, told.causes, told.repairs) == ("delivered", (), ())


def test_a_sentence_is_explained_though_its_author_declined_it() -> None:
    brief = mission(CARRY).brief
    told = explain("Carry the crate to the dock", fleet=brief.fleet, scene=brief.scene, without=["arm"])
    assert told.outcome == "cannot_be_done"
    assert told.causes[0].stage == "tree"
    assert told.repairs[0].words == "Let Arm take part (take it off 'without')."


def test_a_goal_that_no_routine_serves_is_told_as_such_and_has_no_repair() -> None:
    told = explain("Recommend best Italian restaurants in the area")
    assert (told.causes[0].stage, told.causes[0].rule) == ("authoring", "capability_missing")
    assert "'recommend' among its verbs" in told.causes[0].hint
    assert told.repairs == ()


def test_a_plan_is_explained_like_its_mission() -> None:
    request = mission(CARRY, deadline_s=50.0)
    plan = plan_authored(request, Authored(status="complete", tree=request.tree, author="given"), Control())
    of_plan, of_mission = explain(plan), told_of(request, 6).told
    assert [repair.words for repair in of_plan.repairs] == [repair.words for repair in of_mission.repairs]
    assert request_of(plan).tree == request.tree


def test_of_a_plan_for_a_part_the_whole_mission_is_explained() -> None:
    request = mission(CARRY, FIND, fleet=FLEET.replace("payload_kg: 15", "payload_kg: 4"))
    authored = Authored(status="complete", tree=request.tree, author="given")
    whole = plan_authored(request, authored, Control())
    part = nearest_part(whole, request, authored, Control())
    assert part is not None
    assert part.outcome == "partial"
    assert [repair.words for repair in explain(part).repairs] == words_of(told_of(request, 6))


def test_what_a_search_left_open_is_said() -> None:
    costs = Costs({"add_robot": Price(of={"rovr": 1})})
    request = replace(mission(CARRY, fleet=FLEET.replace("payload_kg: 15", "payload_kg: 4")), costs=costs)
    assert [notice.rule for notice in told_of(request).told.notices] == ["cost_unused"]
    authored = Authored(status="complete", tree=request.tree, author="given")
    plan = plan_authored(request, authored, Control())
    cut = explained(plan, request, Control(time_limit_s=0.0)).told
    assert [notice.rule for notice in cut.notices] == ["repairs_cut_short", "cost_unused"]


def test_a_repair_gives_the_whole_plan_and_says_so_in_it() -> None:
    known = told_of(mission(CARRY, deadline_s=50.0))
    plan = known.repaired(1)
    assert plan.notices[-1].rule == "repair_applied" or any(one.rule == "repair_applied" for one in plan.notices)
    with pytest.raises(InputError, match="there is no repair 99"):
        known.repaired(99)
    with pytest.raises(InputError, match="the mission can be done as it stands"):
        told_of(mission(CARRY)).repaired(1)


def test_no_limit_of_time_gives_causes_and_claims_nothing() -> None:
    request = mission(CARRY, deadline_s=50.0)
    authored = Authored(status="complete", tree=request.tree, author="given")
    plan = plan_authored(request, authored, Control())
    told = explained(plan, request, Control(time_limit_s=0.0)).told
    assert told.causes
    assert told.cheapest in {"none", "found"}


def test_a_request_from_a_file_carries_its_costs(tmp_path: Path) -> None:
    file = tmp_path / "mission.yaml"
    file.write_text(
        "mission: Find the keys\ncosts: {add_robot: 3, extend_deadline: {per_share: 9}}\n", encoding="utf-8"
    )
    assert request_from(file).costs == Costs({"add_robot": 3, "extend_deadline": Price(per_share=9)})
    file.write_text("mission: Find the keys\ncosts: {add_robots: 3}\n", encoding="utf-8")
    with pytest.raises(InputError, match=r"costs name 'add_robots'; the nearest is 'add_robot'"):
        request_from(file)


def test_a_number_that_is_only_found_comes_down_to_what_its_plan_does_with() -> None:
    """The crate is fetched from the hall, 30 m away at 1 m/s, so that a deadline of 10 s has to move; to 1000 s is more than it takes."""
    request = mission(CARRY, deadline_s=10.0, check_kinds=False)
    assert request.tree is not None
    case = Case(request.brief, request.tree)
    repairs = Repairs(request, case, (), Control())
    wide = Found((Change(kind="extend_deadline", was=10.0, to=1000.0),), 99.0, proven=False)
    plan = planned(request, case, wide, Control(), 1)
    assert plan is not None
    found, tight = repairs._tightened(wide, plan)
    (schedule,) = tight.schedules
    assert found.changes[0].to == pytest.approx(schedule.makespan_s)
    assert found.cost < wide.cost
    assert schedule.makespan_s < 1000
    assert repairs._tightened(replace(wide, proven=True), plan)[0].changes == wide.changes
