"""What is known of a schedule: five outcomes, each in words of its own, the same for missions and for instances."""

import pytest

from missiontree.mission.certificate import Certificate, Claim
from missiontree.mission.schedule import Schedule, ScheduleStatus
from missiontree.reporting.known import by_word, known_in_words, known_of, may_look_further


@pytest.mark.parametrize(
    ("status", "claim", "method", "bound", "said"),
    [
        ("optimal", "proven", "critical_path", 8, "optimal, confirmed by a bound (critical path)"),
        ("optimal", "proven", "load", 8, "optimal, confirmed by a bound (load)"),
        ("optimal", "proven", "spanning_tree", 8, "optimal, confirmed by a bound (spanning tree)"),
        ("optimal", "proven", "second_formulation", 8, "optimal, confirmed by a second formulation"),
        ("optimal", "proven", "enumeration", 8, "optimal, confirmed by enumeration"),
        ("optimal", "proven", "labels", 8, "optimal, confirmed by a complete search (labels)"),
        ("feasible", "solver_word", "cp_sat", 8, "optimal by the solver's word, which nothing confirms"),
        ("feasible", "solver_word", "cp_sat", 6, "feasible; none is below 6 s by the solver's word (gap 25 %)"),
        ("feasible", "bounded", "load", 6, "feasible; none is below 6 s (gap 25 %)"),
        ("feasible", "unproven", "serial_generation", None, "feasible; nothing is known of shorter ones"),
        ("infeasible", "proven", "deadline_bound", None, "infeasible, proven by deadline bound"),
        ("unknown", "unproven", "serial_generation", 6, "unknown: none was found, none is excluded"),
    ],
)
def test_each_outcome_is_said_in_words(
    status: ScheduleStatus, claim: Claim, method: str, bound: float | None, said: str
) -> None:
    """The schedule takes 8 s; a bound of 6 s leaves a gap of 2 s, a quarter."""
    certificate = Certificate(claim=claim, method=method, bound=bound)
    assert known_in_words(status, certificate, 8.0) == said
    schedule = Schedule(rank=1, status=status, certificate=certificate, makespan_s=8.0)
    assert known_of(schedule) == said
    assert by_word(schedule) == said.startswith("optimal by the solver's word")


def test_where_nothing_takes_time_there_is_no_gap() -> None:
    certificate = Certificate(claim="bounded", method="load", bound=0.0)
    assert known_in_words("feasible", certificate, 0.0) == "feasible; none is below 0 s (gap 0 %)"


@pytest.mark.parametrize(
    ("status", "scheduler", "may"),
    [
        ("feasible", "greedy", True),
        ("feasible", "auto", True),
        ("feasible", "cpsat", False),
        ("optimal", "greedy", False),
        ("unknown", "greedy", False),
    ],
)
def test_who_left_a_gap_in_a_moment_is_told_who_takes_longer(status: ScheduleStatus, scheduler: str, may: bool) -> None:
    schedule = Schedule(rank=1, status=status, certificate=Certificate(claim="bounded", method="load", bound=6.0))
    assert may_look_further(schedule, scheduler) == may
