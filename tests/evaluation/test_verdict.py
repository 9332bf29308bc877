"""Each verdict, on outcomes written by hand."""

from typing import Any

import pytest

from missiontree.authoring.outcome import Authored
from missiontree.evaluation.expected import Expected
from missiontree.evaluation.suite_file import SuiteMission
from missiontree.evaluation.verdict import Verdict, judge
from missiontree.mission.plan import Plan, Provenance
from missiontree.mission.reason import Reason
from tests.evaluation.trees import brief, leaf, task, tree

PLANNED = Authored(status="complete", tree=tree(leaf("a", "Reach(anna)"), new=["Anna"]))
UNCLEAR = Authored(
    status="incomplete",
    reasons=(Reason(rule="decisive_words", message="'If it rains' is not understood.", hint="Reword it."),),
)
NO_PAINTER = Authored(
    status="cannot_be_done",
    reasons=(
        Reason(
            rule="capability_missing",
            message="The mission needs the capability paint ('varnish'), which no routine has; there are Search, Reach.",
            needed="paint",
        ),
    ),
)


def mission(**right: Any) -> SuiteMission:
    return SuiteMission(id="m-1", say="-", **right)


def verdict(authored: Authored, **right: Any) -> Verdict:
    return judge(mission(**right), authored, brief())


def test_a_right_plan_is_right() -> None:
    assert verdict(PLANNED, plan=("Reach(Anna)",)) == Verdict(mission="m-1", kind="right", status="complete", score=1)


def test_a_plan_that_is_accepted_is_right() -> None:
    assert verdict(PLANNED, plan=("Search(Anna)",), accept=(Expected(plan=("Reach(Anna)",)),)).kind == "right"


def test_another_plan_is_wrong_whatever_it_remarks() -> None:
    remark = Reason(rule="search_added", message="Search(Anna) was left out.", severity="notice")
    told = Authored(status="complete", tree=PLANNED.tree, notices=(remark,))
    judged = verdict(told, plan=("Search(Anna)",))
    assert (judged.kind, judged.differences) == ("wrong", ("missing: Search(Anna)", "not expected: Reach(Anna)"))


@pytest.mark.parametrize("authored", [UNCLEAR, NO_PAINTER])
def test_no_plan_where_there_is_one_is_declined_though_possible(authored: Authored) -> None:
    judged = verdict(authored, plan=("Reach(Anna)",))
    assert (judged.kind, judged.status, judged.score) == ("declined_though_possible", authored.status, 0)


@pytest.mark.parametrize("status", ["exhausted", "provider_failed"])
@pytest.mark.parametrize("right", [{"plan": ("Reach(Anna)",)}, {"declined": "impossible", "because": "paint"}])
def test_a_budget_that_ran_out_and_a_model_that_failed_are_no_answer(status: Any, right: dict[str, Any]) -> None:
    """Whatever was right, and whatever tree was left."""
    judged = verdict(Authored(status=status, tree=PLANNED.tree), **right)
    assert (judged.kind, judged.status, judged.score) == ("no_answer", status, 0)


def test_loose_expectations_are_judged_by_their_share() -> None:
    """One of must holds, the other and nothing else is broken: 1 of 2."""
    assert verdict(PLANNED, must=("Reach(*)",)).kind == "right"
    judged = verdict(PLANNED, must=("Reach(Anna)", "Search(Anna)"))
    assert (judged.kind, judged.score, judged.differences) == ("wrong", 0.5, ("missing: Search(Anna)",))


def test_of_several_accepted_plans_the_nearest_gives_the_score() -> None:
    """Of two routines one is there: P = 1, R = 1/2. The plan under ``plan`` has nothing in common."""
    accepted = Expected(plan=("Reach(Anna)", "Search(Anna)"))
    assert verdict(PLANNED, plan=("Follow(Anna)",), accept=(accepted,)).score == pytest.approx(2 / 3)


def test_a_tree_that_is_not_finished_is_worth_nothing() -> None:
    open_task = Authored(status="complete", tree=tree(task("t", "and"), leaf("a", "Reach(anna)"), new=["Anna"]))
    for right in ({"must": ("Reach(Anna)",)}, {"plan": ("Reach(Anna)",)}):
        judged = verdict(open_task, **right)
        assert (judged.kind, judged.score, judged.differences) == ("wrong", 0, ("unfinished: t",))


def planned(outcome: Any, *reasons: Reason) -> Plan:
    return Plan(outcome=outcome, brief=brief(), reasons=reasons, provenance=Provenance(author="scripted"))


@pytest.mark.parametrize(
    ("right", "outcome", "kind"),
    [
        ({"plan": ("Reach(Anna)",)}, "delivered", "right"),
        ({"plan": ("Reach(Anna)",)}, "cannot_be_done", "declined_though_possible"),
        ({"plan": ("Reach(Anna)",)}, "exhausted", "no_answer"),
        ({"plan": ("Reach(Anna)",), "outcome": "cannot_be_done"}, "cannot_be_done", "right"),
        ({"plan": ("Reach(Anna)",), "outcome": "cannot_be_done"}, "delivered", "wrong"),
        ({"plan": ("Search(Anna)",), "outcome": "cannot_be_done"}, "cannot_be_done", "wrong"),
        ({"plan": ("Search(Anna)",)}, "delivered", "wrong"),
        ({"declined": "impossible", "because": "energy"}, "cannot_be_done", "right"),
        ({"declined": "impossible", "because": "paint"}, "cannot_be_done", "wrong_decline"),
        ({"declined": "impossible", "because": "energy"}, "delivered", "wrong"),
    ],
)
def test_planning_to_the_end_has_the_last_word(right: dict[str, Any], outcome: str, kind: str) -> None:
    empty = Reason(rule="limit_exceeded", message="No energy is left for the way back.", needed="energy_j 900")
    plan = planned(outcome, *([empty] if outcome == "cannot_be_done" else []))
    assert judge(mission(**right), PLANNED, brief(), plan).kind == kind


def test_a_tree_that_was_never_built_is_not_saved_by_an_outcome() -> None:
    """Authoring declines what it should plan; that planning then comes to the same is no merit."""
    right = mission(plan=("Reach(Anna)",), outcome="cannot_be_done")
    assert judge(right, NO_PAINTER, brief(), planned("cannot_be_done")).kind == "declined_though_possible"


@pytest.mark.parametrize("declined", ["impossible", "unclear"])
def test_a_plan_where_there_is_none_is_wrong(declined: str) -> None:
    assert verdict(PLANNED, declined=declined, because="paint").kind == "wrong"


@pytest.mark.parametrize(
    ("because", "kind"),
    [
        ("paint", "right"),  # the group of verbs
        ("varnish", "right"),  # the verb
        ("Painting", "right"),
        ("repair", "wrong_decline"),
        ("search", "wrong_decline"),  # named as what there is, not as what is missing
        ("repair | varnish", "right"),
        ("repair | search", "wrong_decline"),
    ],
)
def test_what_is_impossible_is_to_be_named(because: str, kind: str) -> None:
    assert verdict(NO_PAINTER, declined="impossible", because=because).kind == kind


def test_names_with_units_are_found_in_what_is_needed() -> None:
    heavy = Authored(
        status="cannot_be_done",
        reasons=(Reason(rule="limit_exceeded", message="It is too heavy.", needed="payload_kg 300"),),
    )
    assert verdict(heavy, declined="impossible", because="payload_kg").kind == "right"


def test_the_kind_of_decline_counts() -> None:
    assert verdict(UNCLEAR, declined="impossible", because="paint").kind == "wrong_decline"
    assert verdict(NO_PAINTER, declined="unclear", because="paint").kind == "wrong_decline"


def test_what_is_unclear_need_not_be_named_but_it_is_kept_whether_it_was() -> None:
    named, unnamed = (verdict(UNCLEAR, declined="unclear", because=words) for words in ("if", "by noon"))
    assert (named.kind, named.reason_named) == ("right", True)
    assert (unnamed.kind, unnamed.reason_named) == ("right", False)
