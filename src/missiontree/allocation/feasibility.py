"""
Does this choice of robots stay inside their limits, and can it meet its deadlines?

Totals per type add up over all robots of the type, totals and stocks of the mission over all robots there are. A limit per robot
holds if *some* assignment of the roles to the type's robots keeps every robot within it; roles of one team, and the two sides of a
different-robot link, are filled by different robots, and everything under the two ends of a same-robot link by one. Robots are not
used up: one robot may fill any number of roles, one after the other; but no more robots of a type take part than may be in use, and
all that must. Types never share a robot, so each type is decided by itself, see :mod:`packing`.
Deadlines are tested by the critical path, see :mod:`lateness`.

The answer has three values. Packing is hard in the worst case, and beyond a number of steps it is given up as *undecided*,
which is neither a proof of feasibility nor of the opposite.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Literal

from missiontree.allocation.flat import AMOUNT_SCALE, Flat, Shared, Stock
from missiontree.allocation.lateness import late
from missiontree.allocation.packing import Amounts, Load, Packed, add_up, pack
from missiontree.allocation.selection import Selection
from missiontree.allocation.wording import of_all_robots, of_the_mission, type_idle
from missiontree.mission.reason import Reason

DEFAULT_STEPS = 20_000


@dataclass(frozen=True, slots=True)
class Verdict:
    """
    What is known of one selection.

    Parameters
    ----------
    answer
        ``yes``, ``no`` or ``undecided``.
    witness
        Robot by role that keeps every rule, if the answer is yes.
    reason
        Why not, if the answer is no.
    """

    answer: Literal["yes", "no", "undecided"]
    witness: tuple[tuple[int, str], ...] = ()
    reason: Reason | None = None


@dataclass(frozen=True, slots=True)
class _Refused(Exception):
    reason: Reason


class Feasibility:
    """
    Decides selections of one problem.

    Parameters
    ----------
    flat
        The problem.
    steps
        Steps of packing per type and selection before it is given up as undecided.
    """

    def __init__(self, flat: Flat, steps: int = DEFAULT_STEPS) -> None:
        self.flat = flat
        self.steps = steps

    def decide(self, selection: Selection) -> Verdict:
        """Whether some assignment of the selected roles to robots keeps all rules."""
        try:
            return self._decide(selection)
        except _Refused as refused:
            return Verdict("no", reason=refused.reason)

    def _decide(self, selection: Selection) -> Verdict:
        types = self._types(selection)
        self._check_required(types)
        uses = self._uses(selection)
        self._check_totals(types, uses)
        if (reason := late(self.flat, selection)) is not None:
            raise _Refused(reason)
        linked = self._bound_links(selection)
        group_of = _merged(types, linked["same_robot"])
        self._check_groups(types, group_of)
        apart = self._apart(types, group_of, linked["different_robot"])
        robot_of: dict[int, str] = {}
        undecided = False
        for type_id, loads in sorted(_loads(group_of, types, uses, apart).items()):
            packed = pack(self.flat.stocks[type_id], loads, self.steps)
            if packed.answer == "no":
                raise _Refused(_cannot_pack(type_id, self.flat.stocks[type_id], packed, len(loads)))
            undecided |= packed.answer == "undecided"
            robot_of.update({group: self.flat.stocks[type_id].robots[robot] for group, robot in packed.robots.items()})
        if undecided:
            return Verdict("undecided")
        return Verdict("yes", tuple((role, robot_of[group_of[role]]) for role in sorted(types)))

    def _types(self, selection: Selection) -> dict[int, str]:
        types: dict[int, str] = {}
        for leaf in selection.leaves:
            role, kind = self.flat.role[leaf], self.flat.robot_type[leaf]
            if types.setdefault(role, kind) != kind:
                message = f"A role's actions name two robot types, {types[role]} and {kind}; one robot fills a role."
                raise _Refused(Reason(rule="role_torn", message=message))
        return types

    def _check_required(self, types: dict[int, str]) -> None:
        taking_part = set(types.values()) if self.flat.required else set()
        for type_id, named in self.flat.required.items():
            if type_id not in taking_part:
                raise _Refused(type_idle(type_id, named))

    def _uses(self, selection: Selection) -> dict[int, Amounts]:
        uses: dict[int, Amounts] = {}
        for leaf in selection.leaves:
            if self.flat.uses[leaf]:
                add_up(uses.setdefault(self.flat.role[leaf], {}), self.flat.uses[leaf])
        return uses

    def _check_totals(self, types: dict[int, str], uses: dict[int, Amounts]) -> None:
        spent: dict[str, Amounts] = {}
        for role, used in uses.items():
            add_up(spent.setdefault(types[role], {}), used)
        for type_id, used in spent.items():
            for name, needed in sorted(used.items()):
                there = self.flat.stocks[type_id].pooled(name)
                if there is not None and needed > there:
                    raise _Refused(_over_budget(type_id, self.flat.stocks[type_id], name, needed, there))
        for name, shared in self.flat.shared.items():
            needed = sum(used.get(name, 0) for used in spent.values())
            if needed > shared.limit:
                raise _Refused(_over_shared(name, shared, needed))

    def _bound_links(self, selection: Selection) -> dict[str, list[tuple[list[int], list[int]]]]:
        """The roles on both sides of every link whose two nodes are selected."""
        bound: dict[str, list[tuple[list[int], list[int]]]] = {"same_robot": [], "different_robot": []}
        if not self.flat.links:
            return bound
        nodes = set(selection.nodes)
        sides: dict[int, list[int]] = {}
        for kind, links in (("same_robot", self.flat.same_robot), ("different_robot", self.flat.different_robot)):
            for link in links:
                if link[0] in nodes and link[1] in nodes:
                    for end in link:
                        if end not in sides:
                            under = self.flat.leaves_under[end]
                            sides[end] = sorted({self.flat.role[leaf] for leaf in selection.leaves if leaf in under})
                    bound[kind].append((sides[link[0]], sides[link[1]]))
        return bound

    def _check_groups(self, types: dict[int, str], group_of: dict[int, int]) -> None:
        for role, group in group_of.items():
            if types[role] != types[group]:
                message = f"One robot should fill roles of the types {types[group]} and {types[role]}."
                raise _Refused(Reason(rule="same_robot_broken", message=message, robot=types[group]))

    def _apart(
        self, types: dict[int, str], group_of: dict[int, int], different: Iterable[tuple[list[int], list[int]]]
    ) -> dict[int, set[int]]:
        """Which groups of one type must be filled by different robots."""
        pairs = [(a, b) for first, second in different for a in first for b in second]
        teams: dict[int, list[int]] = {}
        for role in types:
            team = self.flat.team[role]
            if team is not None:
                pairs += [(mate, role) for mate in teams.setdefault(team, [])]
                teams[team].append(role)
        apart: dict[int, set[int]] = {}
        for a, b in pairs:
            one, other = group_of[a], group_of[b]
            if one == other:
                message = f"A robot of type {types[a]} should fill two roles that need different robots."
                raise _Refused(Reason(rule="different_robot_broken", message=message, robot=types[a]))
            if types[a] == types[b]:
                apart.setdefault(one, set()).add(other)
                apart.setdefault(other, set()).add(one)
        return apart


def _merged(types: dict[int, str], same: Iterable[tuple[list[int], list[int]]]) -> dict[int, int]:
    """Smallest role of the group each role belongs to; roles of a group are filled by one robot."""
    leader = {role: role for role in types}

    def find(role: int) -> int:
        while leader[role] != role:
            leader[role] = leader[leader[role]]
            role = leader[role]
        return role

    for first, second in same:
        roles = first + second
        for role in roles[1:]:
            one, other = sorted((find(roles[0]), find(role)))
            leader[other] = one
    return {role: find(role) for role in types}


def _loads(
    group_of: dict[int, int], types: dict[int, str], uses: dict[int, Amounts], apart: dict[int, set[int]]
) -> dict[str, list[Load]]:
    """What the robots of each type are to be dealt out, by group."""
    spent: dict[int, Amounts] = {group: {} for group in sorted(set(group_of.values()))}
    for role, used in uses.items():
        add_up(spent[group_of[role]], used)
    loads: dict[str, list[Load]] = {}
    for group, used in spent.items():
        loads.setdefault(types[group], []).append(Load(group, used, frozenset(apart.get(group, ()))))
    return loads


def _over_budget(type_id: str, stock: Stock, name: str, needed: int, there: int) -> Reason:
    holder = of_all_robots(type_id, stock, name)
    wanted, held = f"{needed / AMOUNT_SCALE:g}", f"{there / AMOUNT_SCALE:g}"
    return Reason(
        rule="budget_exceeded",
        message=f"Robots of type {type_id} would use {wanted} of {name}, and {holder.whose} may use {held}.",
        robot=type_id,
        found=f"{name} {held}",
        needed=f"{name} {wanted}",
        hint=holder.remedy,
    )


def _over_shared(name: str, shared: Shared, needed: int) -> Reason:
    holder = of_the_mission(name, shared)
    wanted, held = f"{needed / AMOUNT_SCALE:g}", f"{shared.limit / AMOUNT_SCALE:g}"
    return Reason(
        rule="budget_exceeded",
        message=f"The robots would use {wanted} of {name}, and {holder.whose} may use {held}.",
        found=f"{name} {held}",
        needed=f"{name} {wanted}",
        hint=holder.remedy,
    )


def _cannot_pack(type_id: str, stock: Stock, packed: Packed, groups: int) -> Reason:
    if packed.because == "required":
        names = " and ".join(stock.robots[robot] for robot in stock.required)
        return Reason(
            rule="required_idle",
            message=f"{names} must take part, and no way of dealing {_shares(groups)} out to the robots of type {type_id} lets them.",
            robot=type_id,
            needed=names,
            hint="Require fewer robots, or give the task another way of being done.",
        )
    if packed.because == "in_use":
        return Reason(
            rule="max_in_use_exceeded",
            message=f"No way of dealing {_shares(groups)} out to at most {stock.usable} robots of type {type_id} keeps every rule.",
            robot=type_id,
            found=f"max_in_use {stock.usable}",
            needed="max_in_use more",
            hint=f"Raise max_in_use of type {type_id}, or give the task another way of being done.",
        )
    if packed.because == "apart":
        message = f"More robots of type {type_id} are needed at once, or kept apart, than there are."
        return Reason(rule="too_few_robots", message=message, robot=type_id)
    whom = (
        f"the robots of type {type_id} keeps each"
        if len(stock.robots) > 1
        else f"the only robot of type {type_id} keeps it"
    )
    message = f"No way of dealing {_shares(groups)} out to {whom} within its {packed.name}."
    return Reason(rule="budget_exceeded", message=message, robot=type_id, needed=packed.name)


def _shares(groups: int) -> str:
    return f"{groups} roles" if groups > 1 else "one role"
