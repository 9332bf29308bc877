"""
Composed routines made flat: branches whose roles hold everything that one robot does, ready for grounding.

A routine composed of parts has a branch for each combination of its parts' branches. Parts in ``same_robot`` merge into one
role: one robot, held from the first part's first action to the last part's last. Other parts keep roles of their own, and every
part ends before the next one starts.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import product

from missiontree.errors import InputError
from missiontree.mission.frozen_map import FrozenMap
from missiontree.mission.routine import ActionStep, Branch, HandOver, Need, RoleSpec, Routine, RoutineLibrary

MAX_BRANCHES = 256


@dataclass(frozen=True, slots=True)
class FlatAction:
    """
    A primitive action of a flat role.

    Parameters
    ----------
    step
        The action as declared, in the arguments of the flattened routine. Fields in its text keep the inner names.
    rating
        Capability that rates it: that of the part it comes from.
    sync
        Label of joint work, told apart by part; None if it is not joint.
    fields
        Argument of the flattened routine by field of the text.
    parts
        Routines inside the flattened one that the action comes from, the innermost first.
    """

    step: ActionStep
    rating: str
    sync: str | None
    fields: Mapping[str, str]
    parts: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class FlatRole:
    """
    What one robot (or each of several alike) does.

    Parameters
    ----------
    name
        Name of the role; merged roles join theirs by ``+``.
    actions
        In the order in which they are done.
    needs
        All conditions on the type; the ratings are among them.
    robots
        How many robots fill it alike.
    team
        Roles of the branch with the same number are filled by different robots; None if it stands alone.
    """

    name: str
    actions: tuple[FlatAction, ...]
    needs: tuple[Need, ...]
    robots: int = 1
    team: int | None = None


@dataclass(frozen=True, slots=True)
class Order:
    """An action of one role ends before an action of another starts; roles and actions by index."""

    first_role: int
    first_action: int
    second_role: int
    second_action: int


@dataclass(frozen=True, slots=True)
class FlatBranch:
    """
    One way of doing a routine, compositions resolved.

    Parameters
    ----------
    name
        Names of the branches it combines, joined by ``+``; parts without a choice are left out where another has one.
    accepts
        Argument and the kinds it must be of; every entry holds.
    roles
        The robots' parts.
    order
        What is done before what, beyond the order inside roles.
    hand_overs
        Which action of a role ends with a hand-over, and which action of another role starts with it.
    """

    name: str
    accepts: tuple[tuple[str, tuple[str, ...]], ...]
    roles: tuple[FlatRole, ...]
    order: tuple[Order, ...] = ()
    hand_overs: tuple[Order, ...] = ()


def flatten(routine: Routine, library: RoutineLibrary) -> tuple[FlatBranch, ...]:
    """
    Flat branches of a routine, in the order of its own branches; of a composed one, the last part's varying fastest.

    Raises
    ------
    InputError
        If there are more than 256 combinations, or a part in ``same_robot`` needs several robots.
    """
    flat: dict[str, tuple[FlatBranch, ...]] = {}
    stack = [routine]
    while stack:
        current = stack[-1]
        missing = [library.by_id[part.routine] for part in current.parts if part.routine not in flat]
        if missing:
            stack += missing
            continue
        flat[current.id] = _composed(current, library, flat) if current.parts else _plain(current)
        stack.pop()
    return flat[routine.id]


def _plain(routine: Routine) -> tuple[FlatBranch, ...]:
    return tuple(
        FlatBranch(
            name=branch.name,
            # The way's own demand first: it is the narrower one, and the one to tell people about.
            accepts=(*branch.accepts.items(), *routine.argument_kinds.items()),
            roles=tuple(_role(spec, branch) for spec in branch.roles),
            hand_overs=tuple(_hand_over(one, branch) for one in branch.hand_overs),
        )
        for branch in routine.branches
    )


def _hand_over(one: HandOver, branch: Branch) -> Order:
    place = {role.name: index for index, role in enumerate(branch.roles)}
    giver = place[one.giver]
    return Order(giver, len(branch.roles[giver].actions) - 1, place[one.taker], 0)


def _role(spec: RoleSpec, branch: Branch) -> FlatRole:
    return FlatRole(
        name=spec.name,
        actions=tuple(
            FlatAction(step, spec.rating, step.sync, FrozenMap({name: name for name in step.mentions}))
            for step in spec.actions
        ),
        needs=(Need(capability=spec.rating), *spec.needs),
        robots=spec.robots,
        team=0 if len(branch.roles) > 1 or spec.robots > 1 else None,
    )


def _composed(
    routine: Routine, library: RoutineLibrary, flat: Mapping[str, tuple[FlatBranch, ...]]
) -> tuple[FlatBranch, ...]:
    offered: list[list[FlatBranch]] = []
    for index, part in enumerate(routine.parts):
        inner = library.by_id[part.routine]
        names = {argument.name: part.arguments.get(argument.name, argument.name) for argument in inner.arguments}
        offered.append([_renamed(branch, names, index, inner.id) for branch in flat[inner.id]])
    count = math.prod(map(len, offered))
    if count > MAX_BRANCHES:
        raise InputError(
            f"routine {routine.id!r} combines the branches of its parts in {count} ways.",
            where=routine.id,
            accepted=f"at most {MAX_BRANCHES}",
            hint="Split it into routines with fewer parts.",
        )
    own = tuple(routine.argument_kinds.items())
    return tuple(_joined(routine, combination, offered, own) for combination in product(*offered))


def _renamed(branch: FlatBranch, names: Mapping[str, str], part: int, inner: str) -> FlatBranch:
    """The branch in the arguments of the routine around it, its sync labels and teams told apart by part."""
    return FlatBranch(
        name=branch.name,
        accepts=tuple((names[argument], kinds) for argument, kinds in branch.accepts),
        roles=tuple(
            replace(
                role,
                actions=tuple(_renamed_action(action, names, part, inner) for action in role.actions),
                needs=tuple(_renamed_need(need, names) for need in role.needs),
            )
            for role in branch.roles
        ),
        order=branch.order,
        hand_overs=branch.hand_overs,
    )


def _renamed_action(action: FlatAction, names: Mapping[str, str], part: int, inner: str) -> FlatAction:
    step = action.step

    def outer(name: str | None) -> str | None:
        return None if name is None else names[name]

    return FlatAction(
        step=replace(
            step,
            at=outer(step.at),
            goes_to=outer(step.goes_to),
            brings=tuple(dict.fromkeys(names[name] for name in step.brings)),
            finds=outer(step.finds),
            holds=tuple(dict.fromkeys(_renamed_hold(held, names) for held in step.holds)),
        ),
        rating=action.rating,
        sync=None if action.sync is None else f"{part}.{action.sync}",
        fields=FrozenMap({field: names[name] for field, name in action.fields.items()}),
        parts=(*action.parts, inner),
    )


def _renamed_hold(held: str, names: Mapping[str, str]) -> str:
    return f"{{{names[held[1:-1]]}}}" if held.startswith("{") else held


def _renamed_need(need: Need, names: Mapping[str, str]) -> Need:
    if need.reference is None:
        return need
    argument, attribute = need.reference
    value = f"{names[argument]}.{attribute}"
    return replace(need, at_least=value) if need.at_least is not None else replace(need, at_most=value)


def _joined(
    routine: Routine,
    combination: Sequence[FlatBranch],
    offered: Sequence[Sequence[FlatBranch]],
    own: tuple[tuple[str, tuple[str, ...]], ...],
) -> FlatBranch:
    roles: list[FlatRole] = []
    order: list[Order] = []
    hand_overs: list[Order] = []
    held: int | None = None
    teams = 0
    before: list[tuple[int, int]] = []  # last action of each role of the part before
    for index, branch in enumerate(combination):
        merges = index in routine.same_robot
        if merges:
            _require_one_robot(routine, index, branch)
        place: list[tuple[int, int]] = []  # index of each role of the part, and of the first action it adds there
        for role in branch.roles:
            if merges and held is not None:
                place.append((held, len(roles[held].actions)))
                roles[held] = _merged(roles[held], role)
                continue
            if merges:
                held = len(roles)
            place.append((len(roles), 0))
            roles.append(role if role.team is None else replace(role, team=teams + role.team))
        teams += 1 + max((role.team for role in branch.roles if role.team is not None), default=-1)
        order += [_shifted(pair, place) for pair in branch.order]
        hand_overs += [_shifted(pair, place) for pair in branch.hand_overs]
        order += [Order(r, a, s, b) for r, a in before for s, b in place if r != s]
        before = [(r, start + len(role.actions) - 1) for (r, start), role in zip(place, branch.roles, strict=True)]
    choices = [branch.name for branch, ways in zip(combination, offered, strict=True) if len(ways) > 1]
    return FlatBranch(
        name=" + ".join(choices or [branch.name for branch in combination]),
        accepts=tuple(dict.fromkeys([entry for branch in combination for entry in branch.accepts] + list(own))),
        roles=tuple(roles),
        order=tuple(order),
        hand_overs=tuple(hand_overs),
    )


def _merged(held: FlatRole, role: FlatRole) -> FlatRole:
    return replace(
        held,
        name=f"{held.name}+{role.name}",
        actions=(*held.actions, *role.actions),
        needs=tuple(dict.fromkeys((*held.needs, *role.needs))),
    )


def _shifted(pair: Order, place: Sequence[tuple[int, int]]) -> Order:
    first, second = place[pair.first_role], place[pair.second_role]
    return Order(first[0], first[1] + pair.first_action, second[0], second[1] + pair.second_action)


def _require_one_robot(routine: Routine, index: int, branch: FlatBranch) -> None:
    robots = sum(role.robots for role in branch.roles)
    if robots != 1:
        raise InputError(
            f"routine {routine.id!r}: part {index} is done by one robot together with others (same_robot), but its branch "
            f"{branch.name!r} needs {robots}.",
            where=routine.id,
            accepted="parts whose branches have a single role, in same_robot",
        )
