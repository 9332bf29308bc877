"""The parts of the report, each by itself: what they say, and how much of it."""

from __future__ import annotations

from dataclasses import replace

import pytest

from missiontree.formats.plain import to_plain
from missiontree.mission.entity import Entity
from missiontree.mission.fleet import Fleet, Robot, RobotType
from missiontree.mission.plan import Plan
from missiontree.mission.position import Position
from missiontree.mission.reason import Reason
from missiontree.mission.routine import ActionStep, Argument, Branch, Need, RoleSpec, Routine
from missiontree.mission.schedule import Schedule
from missiontree.reporting.html.compared import compared
from missiontree.reporting.html.crew import FEW, MANY_JOBS, crew
from missiontree.reporting.html.dialogue import dialogue
from missiontree.reporting.html.facts import facts, headline
from missiontree.reporting.html.inputs import inputs
from missiontree.reporting.html.json_words import MOST_CHARACTERS, cut, json_words
from missiontree.reporting.html.moving import moving
from missiontree.reporting.html.origin import origin
from missiontree.reporting.html.proofs import proofs
from missiontree.reporting.html.quantity import count, number, share
from missiontree.reporting.html.remarks import MOST_REMARKS, not_offered, remarks, sentence
from missiontree.reporting.html.thresholds import thresholds
from missiontree.reporting.html.times import at, between, lasts
from missiontree.reporting.html.timetable import MOST_ROWS, timetable
from missiontree.reporting.html.ways import ways
from missiontree.reporting.team.view import team_view
from tests.reporting.html_page import planned

REUNITE, SITE = "reunite", "site"


@pytest.mark.parametrize(
    ("value", "text"),
    [(10.2597, "10.2597"), (16500, "16,500"), (1234567.8, "1,234,568"), (0, "0"), (-0.5, "-0.5"), (1.5e-7, "1.5e-07")],
)
def test_numbers_show_six_digits_that_count(value: float, text: str) -> None:
    assert number(value) == text


@pytest.mark.parametrize(
    ("part", "whole", "text"),
    [
        (1, 4, "25 %"),
        (0, 4, "0 %"),
        (1, 1000, "<1 %"),
        (999, 1000, ">99 %"),
        (4, 4, "100 %"),
        (5, 4, "125 %"),
        (1, 0, "–"),
    ],
)
def test_shares_never_round_to_nothing_or_to_all(part: float, whole: float, text: str) -> None:
    assert share(part, whole) == text


def test_one_robot_and_several() -> None:
    assert [count(1, "robot"), count(1200, "robot")] == ["1 robot", "1,200 robots"]


def test_times_of_one_schedule_are_written_alike() -> None:
    """Below ten minutes in seconds; else all of them by the clock, however small."""
    assert between(5, 95.46, 325) == "5.0 – 95.5 s"
    assert between(5, 3723, 4000) == "0:00:05 – 1:02:03"
    assert at(599.94, 599.94) == "599.9 s"
    assert lasts(95.5) == "95.5 s"
    assert lasts(1246) == "20 min 46 s"


def test_the_headline_names_a_shorter_schedule_of_equal_utility() -> None:
    """Reunite: 5.6 by carrying in 212 s, 5.6 by a message in 202 s; the ranking does not look at time."""
    said = headline(planned(REUNITE))
    assert (said.word, said.tone) == ("Planned", "good")
    assert said.sentence == (
        "2 robots do it in 212 s. It is the best of 4 alternatives; their order is proven. "
        "Alternative 2 is of the same utility and takes 202 s."
    )


def test_key_figures_of_an_alternative() -> None:
    """5.6 - 3.5 = 2.1 below the best."""
    third = facts(planned(REUNITE), 3)
    assert [(fact.name, fact.value) for fact in third] == [
        ("makespan", "212 s"),
        ("utility", "3.5"),
        ("robots", "1 of 5"),
    ]
    assert third[1].note == "2.1 below the best"
    assert facts(planned(REUNITE), 1)[1].note == "the next is equal"


def test_who_does_what_is_said_in_the_words_of_the_routines() -> None:
    plan = planned(REUNITE)
    assert plan.ranking is not None
    told = crew(plan, plan.ranking.alternatives[0], plan.schedules[0])
    assert [member.name for member in told.members] == ["tele_robot-1", "transportation_robot-1"]
    job = told.members[1].jobs[0]
    assert job.text == "Go to where Child is, then bring Child to Mom."  # what one robot does goes without saying
    assert job.when == "67.0 – 212.0 s"
    assert job.after == ("Locate the Lost Child",)
    assert told.idle == ("mobile_scooter-1", "tele_robot-2", "social_robot-1")


def test_without_a_schedule_robot_types_are_named() -> None:
    plan = planned(REUNITE)
    assert plan.ranking is not None
    told = crew(plan, plan.ranking.alternatives[0], None)
    assert [(member.name, member.kind) for member in told.members] == [("", "Tele-Robot"), ("", "Transportation Robot")]
    assert told.members[0].jobs[0].when == ""
    assert told.idle == ()


def test_of_many_jobs_only_the_first_are_told() -> None:
    """30 searches are more than 24, so that each robot tells two; one robot has all of them."""
    plan = planned_searches(30)
    assert plan.ranking is not None
    assert len(plan.ranking.alternatives[0].roles) > MANY_JOBS
    (member,) = crew(plan, plan.ranking.alternatives[0], plan.schedules[0]).members
    assert len(member.jobs) == FEW
    assert member.more == "and 28 more until 0:33:30"  # 30 times 67 s are 2010 s


def planned_searches(how_many: int, repeated: int = 1) -> Plan:
    from missiontree import plan

    names = [f"Person{chr(65 + place // 26)}{chr(97 + place % 26)}" for place in range(how_many)]
    fleet = Fleet((RobotType(id="walker", count=repeated, capabilities={"search": 1.0}),))
    return plan(", then ".join(f"find {name}" for name in names), fleet=fleet, k=1)


def test_a_long_timetable_is_cut_and_says_so() -> None:
    """90 searches of 3 actions each are 270 lines."""
    plan = planned_searches(90)
    table = timetable(plan, plan.schedules[0])
    assert sum(len(lines) for _, lines in table.robots) == MOST_ROWS == 250
    assert table.more == 20


def test_a_timetable_tells_actions_and_travel() -> None:
    table = timetable(planned(SITE), planned(SITE).schedules[0])
    robots = dict(table.robots)
    assert list(robots) == ["scout-1", "hauler-1", "ada", "ben"]  # as in the chart: the order of the fleet
    travel, message, lead = robots["ben"]
    assert (travel.start, travel.end, travel.lasts, travel.moving) == ("0.0 s", "35.3 s", "35.3 s", True)
    assert (message.text, message.moving) == ("Display message to visitor to follow Guide to gate", False)
    assert lead.end == "177.5 s"


def test_limits_are_told_beside_what_is_used_of_them() -> None:
    """The crate weighs 40 kg and the hauler carries 200; 55 m at 300 J each are 16,500 J of 400,000."""
    first = ways(planned(SITE), 1)[0]
    rows = {(row.who, row.name): row for row in first.limits}
    carried = rows["hauler-1", "payload_kg"]
    assert (carried.used, carried.allowed, carried.why, carried.percent, carried.bar) == (
        "40",
        "200",
        "red crate",
        "20 %",
        "16",
    )
    energy = rows["hauler-1", "energy_j"]
    assert (energy.used, energy.allowed, energy.percent) == ("16,500", "400,000", "4 %")


def test_of_several_loads_the_heaviest_is_told() -> None:
    """Two crates of 3 and 5 kg, each shared by two pushers: half of 5 kg is what the limit is compared with."""
    step = ActionStep(name="push", text="Push {agent}", duration_s=10, sync="push")
    role = RoleSpec(
        name="pusher",
        rating="push",
        robots=2,
        actions=(step,),
        needs=(Need(limit="force_kg", at_least="agent.mass_kg", share=0.5),),
    )
    push = Routine(
        id="Push",
        purpose="Push {agent}.",
        arguments=(Argument(name="agent", kinds=("object",)),),
        verbs=("push",),
        branches=(Branch(name="push", roles=(role,)),),
    )
    from missiontree import plan
    from missiontree.mission.scene import Scene

    fleet = Fleet(
        (
            RobotType(
                id="mule", robots=(Robot(id="a"), Robot(id="b")), capabilities={"push": 1}, limits={"force_kg": 10}
            ),
        )
    )
    scene = Scene(
        entities=(
            Entity(id="box", mass_kg=3, position=Position(1, 0)),
            Entity(id="chest", mass_kg=5, position=Position(2, 0)),
        )
    )
    made = plan("Push the box, then push the chest", fleet=fleet, scene=scene, routines=[push])
    assert made.ranking is not None
    rows = thresholds(made, made.ranking.alternatives[0], made.schedules[0])
    assert [(row.who, row.used, row.allowed, row.why) for row in rows] == [
        ("a", "2.5", "10", "chest"),
        ("b", "2.5", "10", "chest"),
    ]


def test_alternatives_stand_side_by_side_by_what_differs() -> None:
    """The visitor is led by the guide, carried by the hauler, or by the courier; the other three tasks are done alike."""
    view = team_view(planned(SITE))
    assert view is not None
    side = compared(view)
    assert side.ranks == (1, 2, 3)
    assert [label for label, _ in side.tasks] == ["Transport(visitor, gate)"]
    cells = side.tasks[0][1]
    assert [cell.other for cell in cells] == [False, True, True]
    assert [cell.text.partition(":")[0] for cell in cells] == ["Guide", "Hauler", "Courier"]
    assert side.alike == 3
    assert dict(side.rows)["makespan"][1].text == "347.5 s"


def test_what_is_only_lacking_is_gathered_and_the_rest_is_told_one_by_one() -> None:
    by_task = {refused.task: refused for refused in not_offered(planned(SITE))}
    assert by_task["Search(visitor)"].lacking == (("search", "Hauler, Courier, Guide"),)
    assert not len(by_task["Search(visitor)"].remarks)
    crate = by_task["ReachAndTransport(red crate, workshop)"]
    assert crate.remarks.listed[0].message.startswith(
        "Courier cannot do ReachAndTransport(red crate, workshop) by carry"
    )
    assert crate.lacking == (("carry", "Scout, Guide"),)


def test_many_remarks_are_cut_and_say_so() -> None:
    told = remarks([Reason(rule="x", message=f"Reason {place}.") for place in range(MOST_REMARKS + 5)])
    assert (len(told.listed), told.more, len(told)) == (MOST_REMARKS, 5, MOST_REMARKS + 5)


@pytest.mark.parametrize(
    ("hint", "text"),
    [
        ("", ""),
        ("reword it", "Reword it."),
        ("max_speed_mps is missing", "max_speed_mps is missing."),
        ("Why?", "Why?"),
    ],
)
def test_hints_read_as_sentences(hint: str, text: str) -> None:
    assert sentence(hint) == text


def test_certificates_of_list_ranks_and_schedules_are_told() -> None:
    told = {proof.what: proof for proof in proofs(planned(SITE))}
    assert told["the list of alternatives"].says == "complete and in order"
    assert (told["rank 1"].claim, told["rank 1"].method) == ("proven", "lazy k best")
    assert (told["schedule 1"].claim, told["schedule 1"].bound) == ("proven", "at least 325 s")
    assert proofs(planned("restaurants")) == ()


def test_the_origin_is_told_in_pairs() -> None:
    pairs = dict(origin(planned(SITE)))
    assert pairs["tree by"] == "the offline author, which reads plain language by rules"
    assert pairs["utility"] == "1 × quality − 0.001 × seconds"
    assert "language model" not in pairs


def test_the_dialogue_is_told_in_short() -> None:
    told = dialogue(planned(SITE).provenance.transcript)
    assert told is not None
    assert (told.turns, told.refused, told.more) == (3, 0, 0)
    assert told.calls[0].call.startswith("HierarchicalTree_init")
    assert all(called.ok for called in told.calls)


def test_a_refused_call_is_told_with_the_answer_it_got() -> None:
    from missiontree import plan
    from missiontree.samples.dialogues import FOLDER

    made = plan(FOLDER / "campus.yaml", model=f"recorded:{FOLDER / 'campus.jsonl'}")
    told = dialogue(made.provenance.transcript)
    assert told is not None
    assert told.refused >= 1
    refused = next(called for called in told.calls if not called.ok)
    assert refused.answer


def test_a_dialogue_in_which_nothing_was_said_is_not_told() -> None:
    """Its header alone: words that were not understood led to no call."""
    transcript = planned(SITE).provenance.transcript
    assert dialogue(transcript) is not None
    assert dialogue(transcript[:1]) is None


@pytest.mark.parametrize("lines", [(), ("not JSON",), ('{"format": "transcript/1"}',)])
def test_no_dialogue_and_a_damaged_one_are_not_told(lines: tuple[str, ...]) -> None:
    assert dialogue(lines) is None


def test_inputs_stand_there_with_their_digests() -> None:
    plan = planned(SITE)
    told = {entry.name: entry for entry in inputs(plan)}
    assert told["fleet"].digest == plan.digests["fleet"]
    assert told["fleet"].text == json_words(to_plain(plan.brief.fleet))
    assert told["fleet"].more == 0


def test_json_shows_what_cannot_be_seen() -> None:
    """A right-to-left override and a tag, which is beyond U+FFFF and takes two escapes."""
    assert json_words({"name": "a\u202eb\U000e0041"}) == '{\n  "name": "a\\u202eb\\udb40\\udc41"\n}'


def test_a_long_text_is_cut_at_the_end_of_a_line() -> None:
    text = ("x" * 999 + "\n") * 200
    kept, more = cut(text)
    assert len(kept) == MOST_CHARACTERS
    assert kept.endswith("\n")
    assert more == len(text) - MOST_CHARACTERS
    assert cut("short") == ("short", 0)


def test_without_a_map_the_clock_still_tells_who_does_what() -> None:
    told = moving(planned(REUNITE), [1, 3])
    assert list(told) == ["1", "3"]
    first = told["1"]["movers"][0]
    assert (first["id"], first["frames"]) == ("tele_robot-1", [])
    assert first["doings"][0] == [0, 5000, "Get search path to find Child"]
    assert told["1"]["end"] == 212_000


def test_an_alternative_without_a_schedule_has_no_clock() -> None:
    plan = planned(REUNITE)
    bare = Schedule(rank=1, status="unknown", certificate=plan.schedules[0].certificate)
    assert list(moving(replace(plan, schedules=(bare, *plan.schedules[1:])), [1, 2])) == ["2"]


def test_at_most_eight_alternatives_can_be_chosen_and_the_first_is_among_them() -> None:
    """Three searches by any of three types: 27 ways, of which twelve are asked for."""
    from missiontree import plan

    types = tuple(
        RobotType(id=f"type{number}", count=3, capabilities={"search": 1 - number / 10}) for number in range(3)
    )
    made = plan("find Ada, find Ben, find Cleo", fleet=Fleet(types), k=12)
    assert made.ranking is not None
    assert len(made.ranking.alternatives) == 12
    assert [way.rank for way in ways(made, 1)] == [1, 2, 3, 4, 5, 6, 7, 8]
    assert [way.rank for way in ways(made, 11)] == [1, 2, 3, 4, 5, 6, 7, 11]
