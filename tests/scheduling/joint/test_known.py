"""What is claimed of the schedule of a tree: proof only where there is one, and a solver's word is called one."""

import pytest

from missiontree.checking.columns import check_tree
from missiontree.mission.certificate import Certificate, Claim
from missiontree.mission.columns import AND, LEAF, TreeColumns
from missiontree.mission.tree_schedule import TreeSchedule, TreeScheduleStatus
from missiontree.scheduling.joint.known import Known
from missiontree.scheduling.joint.listing import Listed

TREE = TreeColumns(
    kind=[AND, LEAF, LEAF],
    parent=[-1, 0, 0],
    robot=[0, 0, 0],
    utility=[0, 0, 0],
    duration=[0, 3, 4],
    consumption=[0, 0, 0],
    precedence=[],
    disjoint=[],
    robots=1,
    budget=None,
)
"""One robot, 3 s and 4 s: 7 s, which is its load."""


def told(bound: int, method: str = "critical_path", word: int = 0) -> TreeSchedule:
    return Known(Listed(7, {1: 0, 2: 3}, {1: 0, 2: 0}, {}), bound, method, word).told()


@pytest.mark.parametrize(
    ("bound", "method", "word", "status", "claim", "by", "at_least"),
    [
        (7, "load", 0, "optimal", "proven", "load", 7),
        (7, "second_formulation", 7, "optimal", "proven", "second_formulation", 7),
        (4, "critical_path", 0, "feasible", "bounded", "critical_path", 4),
        (4, "critical_path", 6, "feasible", "solver_word", "cp_sat", 6),
        (4, "critical_path", 7, "feasible", "solver_word", "cp_sat", 7),
    ],
)
def test_optimal_is_what_is_proven_and_a_word_is_called_one(
    bound: int, method: str, word: int, status: str, claim: str, by: str, at_least: float
) -> None:
    found = told(bound, method, word)
    certificate = found.certificate
    assert (found.status, certificate.claim, certificate.method, certificate.bound) == (status, claim, by, at_least)
    assert check_tree(TREE, found) == ()


@pytest.mark.parametrize(
    ("status", "claim", "method", "said"),
    [
        ("optimal", "solver_word", "cp_sat", "the schedule is optimal, and its certificate solver_word"),
        ("optimal", "bounded", "load", "the schedule is optimal, and its certificate bounded"),
        ("feasible", "proven", "load", "the schedule is feasible, and its certificate proven"),
        ("feasible", "bounded", "cp_sat", "rests on the method cp_sat"),
        ("feasible", "solver_word", "load", "rests on the method load"),
        ("optimal", "proven", "guess", "rests on the method guess"),
    ],
)
def test_the_checker_refuses_claims_beyond_their_certificate(
    status: TreeScheduleStatus, claim: Claim, method: str, said: str
) -> None:
    certificate = Certificate(claim=claim, method=method, bound=7.0)
    faults = check_tree(TREE, TreeSchedule(status, certificate, {}, {1: 0, 2: 3}, {1: 0, 2: 0}, 7))
    assert any(said in fault.message for fault in faults), faults
