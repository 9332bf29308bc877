"""The checker's own bound: never above what is possible, and close enough to confirm most of what is claimed."""

from __future__ import annotations

from missiontree.checking import check
from missiontree.checking.case import Case
from missiontree.checking.lower_bound import least_makespan
from missiontree.checking.proofs import claimed_bound
from tests.checking.missions import random_mission
from tests.checking.plans import made


def test_no_sound_schedule_is_shorter_than_the_bound() -> None:
    """Eighty missions of every kind; and of what their schedules claim, the bound confirms four fifths at least."""
    confirmed = claimed = 0
    for seed in range(1000, 1080):
        plan = made(*random_mission(seed))
        if check(plan):
            continue  # a fault elsewhere, which test_sound.py is about
        case = Case(plan)
        for timetable in case.timetables:
            own = least_makespan(case, timetable)
            assert own is not None
            assert own <= round(timetable.schedule.makespan_s * 1000), f"seed {seed}"
            if timetable.schedule.certificate.method == "enumeration":
                continue  # which proves what no bound does
            claimed += 1
            confirmed += own >= claimed_bound(timetable.schedule) - 1
    assert claimed > 50
    assert confirmed >= 0.8 * claimed
