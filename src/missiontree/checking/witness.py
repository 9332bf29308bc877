"""Does the witness of an alternative show what it is meant to: robots that keep every limit by what allocation knows?"""

from __future__ import annotations

from collections.abc import Iterator

from missiontree.checking.case import Case
from missiontree.checking.fault import Fault, role_named
from missiontree.checking.staff_search import can_be_staffed, conflict
from missiontree.checking.staffing import Staffing


def witness_incomplete(case: Case) -> Iterator[Fault]:
    """A witness does not name exactly one existing robot for every reached role."""
    for staffing in case.staffings:
        witness = staffing.alternative.witness
        roles = [entry.role for entry in witness]
        strangers = [entry.robot for entry in witness if entry.robot not in case.fleet.robots]
        if witness and (sorted(roles) != list(staffing.leaves_of_role) or strangers):
            yield Fault(
                f"the witness of alternative {staffing.alternative.rank} does not name one robot of the fleet for each of its roles.",
                robot=strangers[0] if strangers else "",
                found=f"roles {roles}",
                needed=f"roles {list(staffing.leaves_of_role)}",
            )


def witness_broken(case: Case) -> Iterator[Fault]:
    """The robots of a witness are of the wrong type, share a team, break a link, exceed a budget, or break a term of the mission."""
    for staffing in case.staffings:
        robots = {
            entry.role: entry.robot
            for entry in staffing.alternative.witness
            if entry.role in staffing.leaves_of_role and entry.robot in case.fleet.robots
        }
        problem = conflict(staffing, case, robots) if _types_known(case, staffing) else None
        if problem is not None:
            why, role, robot = problem
            yield Fault(
                f"the witness of alternative {staffing.alternative.rank} does not hold: {why}.",
                node=role_named(staffing.tree, role),
                robot=robot,
                found=why,
                needed="type, team, links, budgets and terms of the mission kept",
            )


def alternative_unstaffable(case: Case) -> Iterator[Fault]:
    """An alternative without a witness can be staffed by no choice of robots."""
    for staffing in case.staffings:
        if (
            not staffing.alternative.witness
            and _types_known(case, staffing)
            and can_be_staffed(staffing, case) is False
        ):
            yield Fault(
                f"alternative {staffing.alternative.rank} has no witness, and no choice of robots keeps teams, links, budgets and terms.",
                found="no robots fit",
                needed="a robot for every role",
            )


def _types_known(case: Case, staffing: Staffing) -> bool:
    return all(type_id in case.fleet.by_id for type_id in staffing.type_of_role.values())
