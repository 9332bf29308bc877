"""Each verdict, on outcomes written by hand."""

from typing import Any

import pytest

from missiontree.authoring.outcome import Authored
from missiontree.evaluation.expected import Expected
from missiontree.evaluation.suite_file import SuiteMission
from missiontree.evaluation.verdict import Verdict, judge
from missiontree.mission.reason import Reason
from tests.evaluation.trees import brief, leaf, tree

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
    assert verdict(PLANNED, plan=("Reach(Anna)",)) == Verdict(mission="m-1", kind="right", status="complete")


def test_a_plan_that_is_accepted_is_right() -> None:
    assert verdict(PLANNED, plan=("Search(Anna)",), accept=(Expected(plan=("Reach(Anna)",)),)).kind == "right"


def test_another_plan_is_wrong_whatever_it_remarks() -> None:
    remark = Reason(rule="search_added", message="Search(Anna) was left out.", severity="notice")
    told = Authored(status="complete", tree=PLANNED.tree, notices=(remark,))
    judged = verdict(told, plan=("Search(Anna)",))
    assert (judged.kind, judged.differences) == ("wrong", ("missing: Search(Anna)", "not expected: Reach(Anna)"))


@pytest.mark.parametrize(
    "authored", [UNCLEAR, NO_PAINTER, Authored(status="exhausted"), Authored(status="provider_failed")]
)
def test_no_plan_where_there_is_one_is_declined_though_possible(authored: Authored) -> None:
    judged = verdict(authored, plan=("Reach(Anna)",))
    assert (judged.kind, judged.status) == ("declined_though_possible", authored.status)


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
