"""Claims: nothing is claimed that the plan itself contradicts."""

from __future__ import annotations

from collections.abc import Iterator

from missiontree.mission.reason import Reason
from missiontree.rechecking.facts import TICK_MS, Facts, broken, milliseconds

RULE = "core_claims"
MILLIONTH = 1e-6


def bound_of_the_alternative(facts: Facts) -> Iterator[Reason]:
    """No utility is above the bound; the alternative's own is not either."""
    one = facts.alternative
    if one.certificate.bound is not None and one.certificate.bound < one.utility - MILLIONTH:
        message = (
            f"rank {one.rank} has utility {one.utility}, and its bound says that none is above {one.certificate.bound}."
        )
        yield broken(RULE, message)


def bound_of_the_schedule(facts: Facts) -> Iterator[Reason]:
    """No schedule is shorter than the bound; this one is not either. An optimal one is proven."""
    one = facts.schedule
    if one is None:
        return
    bound = one.certificate.bound
    if bound is not None and milliseconds(bound) > milliseconds(one.makespan_s) + TICK_MS:
        yield broken(
            RULE, f"the schedule lasts {one.makespan_s} s, and its bound says that none is shorter than {bound} s."
        )
    short = bound is not None and milliseconds(bound) + TICK_MS < milliseconds(one.makespan_s)
    if one.status == "optimal" and (one.certificate.claim != "proven" or short):
        yield broken(RULE, f"the schedule of rank {one.rank} is called optimal, and is not proven to be.")
