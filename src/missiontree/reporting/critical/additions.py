"""What more robots, or more room at a shared resource, would bring, in sentences; each of them was scheduled."""

from __future__ import annotations

from collections.abc import Iterator

from missiontree.mission.certificate import Certificate
from missiontree.mission.chain import Addition, CriticalChain, WhySoLong
from missiontree.mission.fleet import Fleet
from missiontree.mission.schedule import Schedule
from missiontree.reporting.critical.spans import ms
from missiontree.reporting.escape import one_line
from missiontree.reporting.gantt.time import in_words

_PROOFS = {"proven", "bounded"}


def addition_lines(why: WhySoLong, schedule: Schedule, fleet: Fleet) -> Iterator[str]:
    """
    A sentence for each addition that was tried, and what they come to together.

    Parameters
    ----------
    why
        What was found.
    schedule
        The schedule that it is about.
    fleet
        For the labels of robot types.
    """
    outcomes: dict[str, list[str]] = {}
    for one in why.additions:
        outcomes.setdefault(_outcome(one, schedule), []).append(_added(one, fleet))
    if why.unlimited is not None and not _settled_without(why):
        everyone = f"a robot for every role ({_added(why.unlimited, fleet)})"
        outcomes.setdefault(_outcome(why.unlimited, schedule), []).append(everyone)
    for outcome, added in outcomes.items():
        yield f"{'; '.join(added)}: {outcome}"
    if why.untried:
        yield why.untried
    if (verdict := _together(why)) is not None:
        yield verdict


def _added(one: Addition, fleet: Fleet) -> str:
    listed = []
    for type_id, count in one.robots.items():
        label = one_line(fleet.by_id[type_id].label) if type_id in fleet.by_id else type_id
        listed.append(f"one more {label}" if count == 1 else f"{count} more {label}")
    listed += [
        f"{'one more place' if count == 1 else f'{count} more places'} at {name}"
        for name, count in one.resources.items()
    ]
    like = f" like {one.like}" if one.like is not None else ""
    return ", ".join(listed) + like


def _outcome(one: Addition, schedule: Schedule) -> str:
    now = in_words(schedule.makespan_s)
    if one.verdict == "not_shorter":
        return f"no schedule is shorter than {now}, proven by {_method(one.certificate)}"
    if one.verdict == "none_found":
        found = f"no schedule shorter than {now} was found"
        return f"{found}, and none is excluded{_least(one.certificate)}"
    known = "proven shortest" if one.status == "optimal" else f"found{_least(one.certificate)}"
    reach = "; without it that is impossible" if _out_of_reach(one, schedule) else ""
    return f"{in_words(one.makespan_s)} instead of {now} ({known}){reach}"


def _least(certificate: Certificate) -> str:
    if certificate.bound is None or certificate.claim not in _PROOFS:
        return ""
    return f"; none can be below {in_words(certificate.bound)}"


def _method(certificate: Certificate) -> str:
    return certificate.method.replace("_", " ")


def _out_of_reach(one: Addition, schedule: Schedule) -> bool:
    """Whether it is proven that the team as it is has no schedule that short."""
    bound = schedule.certificate.bound
    return bound is not None and schedule.certificate.claim in _PROOFS and ms(one.makespan_s) < ms(bound)


def _settled_without(why: WhySoLong) -> bool:
    """Whether one more robot brings as much as any number of them."""
    assert why.unlimited is not None
    best = [ms(one.makespan_s) for one in why.additions if one.verdict == "shorter"]
    return why.unlimited.verdict == "shorter" and bool(best) and min(best) <= ms(why.unlimited.makespan_s)


def _together(why: WhySoLong) -> str | None:
    tried = [*why.additions, *([why.unlimited] if why.unlimited is not None else [])]
    if not tried or any(one.verdict == "shorter" for one in tried):
        return None
    if why.untried or any(one.verdict == "none_found" for one in tried):
        return "Nothing was found that shortens it."
    what = "No single one of these" if why.unlimited is None else "Nothing of this"
    return f"{what} shortens it: {_held_by(why.chain)}"


def _held_by(chain: CriticalChain) -> str:
    bonds = {step.bond for step in chain.steps}
    waits = [
        words for bond, words in (("robot", "busy robots"), ("resource", "room in what robots share")) if bond in bonds
    ]
    if waits:
        return f"the chain waits for {' and for '.join(waits)}, but with more of it nothing ends earlier."
    return "no part of the chain waits for a busy robot; work, ways, order and times make it that long."
