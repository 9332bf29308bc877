"""The command that measures the offline author: its parts, its numbers, and what it says of a miss."""

from benchmarks.offline_author import SUITE, Judged, got, miss, missions_of, table
from missiontree.authoring.outcome import Authored
from missiontree.evaluation.suite import Setting, Suite, load_suite
from missiontree.evaluation.suite_file import SuiteMission
from missiontree.evaluation.verdict import judge
from missiontree.mission.reason import Reason
from missiontree.mission.tree import Link
from missiontree.routines.library import built_in
from tests.builders import paper_fleet
from tests.evaluation.trees import leaf, task, tree

FARM = Setting(
    id="farm",
    fleet=paper_fleet(),
    routines=built_in(),
    missions=tuple(
        SuiteMission(id=f"farm-{number}", say=f"Find hen {number}.", plan=(f"Search(Hen {number})",))
        for number in range(6)
    ),
)
MADE = tree(
    leaf("s", "Search(hen)", "tele_robot"),
    task("c", "xor", leaf("a", "Reach(hen)"), leaf("b", "Follow(hen)")),
    links=[Link("s", "a")],
    new=["Hen"],
)


def judged(authored: Authored) -> Judged:
    mission = FARM.missions[0]
    return Judged(FARM, mission, FARM.brief(mission), authored, judge(mission, authored, FARM.brief(mission)))


def test_the_parts_are_the_whole() -> None:
    suite = Suite(settings=(FARM,))
    parts = {part: [mission.id for _, mission in missions_of(suite, part, 1)] for part in ("open", "aside", "all")}
    assert (len(parts["open"]), len(parts["aside"])) == (4, 2)
    assert sorted(parts["open"] + parts["aside"]) == parts["all"] == [f"farm-{number}" for number in range(6)]


def test_what_was_made_is_told_as_suites_write_it() -> None:
    told = "Search(Hen) by tele_robot; xor(Reach(Hen); Follow(Hen)) | 1 < 2"
    assert got(judged(Authored(status="complete", tree=MADE))) == told


def test_a_miss_says_words_expectation_outcome_and_reasons() -> None:
    reason = Reason(rule="verb_unknown", message="'hen' is not understood.")
    assert miss(judged(Authored(status="incomplete", reasons=(reason,)))).splitlines() == [
        "farm-0: declined though possible",
        "  words: Find hen 0.",
        "  expected: Search(Hen 0)",
        "  got: incomplete",
        "  difference: a plan was expected; authoring came to incomplete",
        "  reason: verb_unknown: 'hen' is not understood.",
    ]


def test_the_table_has_a_row_for_each_setting_and_the_total() -> None:
    done = [judged(Authored(status="complete", tree=MADE)), judged(Authored(status="incomplete"))]
    # One plan of another kind, one declined; each mission is of the farm.
    assert table(done, by_setting=True).splitlines()[2:] == [
        "| farm | 2 | 0 | 1 | 0 | 1 |",
        "| total | 2 | 0 | 1 | 0 | 1 |",
    ]
    assert table(done, by_setting=False).splitlines()[2:] == ["| total | 2 | 0 | 1 | 0 | 1 |"]


def test_the_built_in_suite_fits_its_own_fleets_scenes_and_routines() -> None:
    assert load_suite(SUITE).settings
