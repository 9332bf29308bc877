"""
Routines: what a mission tree ends in, and the only things robots are ever asked to do.

A routine is a subtree for one purpose with typed arguments and one branch per way of doing it, or it is composed of other
routines. The built-in ones are YAML files; users write more in YAML or as Python functions. All of them are this value.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property

from missiontree.mission.pattern import Form, forms_of
from missiontree.mission.value import ID_PATTERN, Count, Id, NonNegative, Positive, Value, require_unique

_FIELD = re.compile(r"\{([^{}]*)\}")
_HELD = re.compile(rf"{ID_PATTERN}|\{{{ID_PATTERN}\}}", re.ASCII)


@dataclass(frozen=True, slots=True, kw_only=True)
class Argument(Value):
    """
    One argument of a routine.

    Parameters
    ----------
    name
        Its name, used in texts as ``{name}``.
    kinds
        Entity kinds accepted; kinds declared under them count too.
    """

    name: Id
    kinds: tuple[Id, ...]

    def _check(self) -> None:
        if not self.kinds:
            raise ValueError(f"argument {self.name!r} accepts no kind.")


@dataclass(frozen=True, slots=True, kw_only=True)
class Need(Value):
    """
    One condition on the robot type that fills a role. A comparison, never an expression.

    Either ``capability`` is given (the type must have it, at quality ``at_least`` if that is given), or ``limit`` with
    ``at_least`` or ``at_most`` (the type's limit of that name is compared).

    Parameters
    ----------
    capability
        Capability the type must have.
    limit
        Name of a limit of the type.
    at_least, at_most
        A number, or ``argument.attribute`` of an entity: ``agent.mass_kg``.
    share
        Factor on the value compared with, for loads that several roles share. Default 1.
    """

    capability: Id | None = None
    limit: Id | None = None
    at_least: float | str | None = None
    at_most: float | str | None = None
    share: Positive = 1.0

    def _check(self) -> None:
        if (self.capability is None) == (self.limit is None):
            raise ValueError("a need names either a capability or a limit.")
        if self.limit is not None and (self.at_least is None) == (self.at_most is None):
            raise ValueError(f"the need of limit {self.limit!r} has either at_least or at_most.")
        if self.capability is not None and (self.at_most is not None or isinstance(self.at_least, str)):
            raise ValueError(
                f"the need of capability {self.capability!r} may have at_least, a number, and nothing else."
            )
        for bound in (self.at_least, self.at_most):
            if isinstance(bound, str) and bound.count(".") != 1:
                raise ValueError(f"{bound!r} is neither a number nor of the form argument.attribute.")

    @property
    def reference(self) -> tuple[str, str] | None:
        """Argument and attribute compared with, if it is not a plain number."""
        for bound in (self.at_least, self.at_most):
            if isinstance(bound, str):
                argument, attribute = bound.split(".")
                return argument, attribute
        return None


@dataclass(frozen=True, slots=True, kw_only=True)
class ActionStep(Value):
    """
    A primitive action as a routine declares it: something that one robot executes.

    Parameters
    ----------
    name
        Name of the primitive action, shared by all routines that use it.
    text
        What people read; ``{argument}`` stands for an entity, ``{robot}`` for the robot type.
    duration_s
        Nominal duration in seconds, at least 0. For a move: what it takes when positions are unknown.
    cost
        Nominal cost, at least 0.
    uses
        What it uses of the robot's budgets, travel excluded.
    at
        Argument at whose place the action is done; the robot travels there first.
    goes_to
        Argument whose place the action moves to; the action is that travel. Not together with ``at``.
    brings
        Arguments that move along (``goes_to`` only) and are at the new place afterwards.
    finds
        Argument whose position is known once the action succeeded.
    sync
        Label of joint work: actions of different roles of a branch with one label share start and end.
    open_ended
        It has no end of its own: it lasts ``duration_s``, or as an *until* link says.
    holds
        Shared resources that its robot holds from its start to its end: ids of the scene's ``resources``, or ``{argument}`` for the
        entity that an argument stands for. Default: none.
    """

    name: Id
    text: str
    duration_s: NonNegative = 0.0
    cost: NonNegative = 0.0
    uses: Mapping[Id, NonNegative] = field(default_factory=dict)
    at: Id | None = None
    goes_to: Id | None = None
    brings: tuple[Id, ...] = ()
    finds: Id | None = None
    sync: Id | None = None
    open_ended: bool = False
    holds: tuple[str, ...] = ()

    def _check(self) -> None:
        for held in self.holds:
            if not _HELD.fullmatch(held):
                raise ValueError(
                    f"action {self.name!r} holds {held!r}; accepted are ids of the scene's resources, and an argument in braces: "
                    '["lift-1", "{door}"].'
                )
        require_unique(f"action {self.name!r} holds: resource", self.holds)
        if self.at is not None and self.goes_to is not None:
            raise ValueError(f"action {self.name!r} has both at and goes_to; a move is only a move.")
        if self.brings and self.goes_to is None:
            raise ValueError(f"action {self.name!r} brings something but goes nowhere; add goes_to.")
        if self.open_ended and (self.goes_to is not None or self.sync is not None):
            raise ValueError(f"action {self.name!r} is open-ended; it can be neither a move nor joint.")

    @property
    def mentions(self) -> tuple[str, ...]:
        """Arguments that the action names."""
        held = (name for each in self.holds for name in _FIELD.findall(each))
        named = [*_FIELD.findall(self.text), self.at, self.goes_to, *self.brings, self.finds, *held]
        return tuple(dict.fromkeys(name for name in named if name is not None and name != "robot"))


@dataclass(frozen=True, slots=True, kw_only=True)
class RoleSpec(Value):
    """
    One robot's part in a branch.

    Parameters
    ----------
    name
        Name of the role, unique in the branch.
    rating
        Capability that rates every action of the role; the type must have it.
    needs
        Further conditions on the type.
    actions
        What the robot does, in order; at least one.
    robots
        How many robots fill the role alike, each with the same actions. Default 1.
    """

    name: Id
    rating: Id
    actions: tuple[ActionStep, ...]
    needs: tuple[Need, ...] = ()
    robots: Count = 1

    def _check(self) -> None:
        if not self.actions:
            raise ValueError(f"role {self.name!r} has no actions.")


@dataclass(frozen=True, slots=True, kw_only=True)
class HandOver(Value):
    """
    One role of a branch hands over to another: the giver's last action ends when the taker's first action starts, at one place.

    The giver waits for the taker within its role. The taker's first action is done where the giver then is: at the same argument, or at
    something that the giver brought there.

    Parameters
    ----------
    giver, taker
        Names of the two roles.
    """

    giver: Id
    taker: Id


@dataclass(frozen=True, slots=True, kw_only=True)
class Branch(Value):
    """
    One way of doing a routine. Roles of one branch are filled by different robots.

    Parameters
    ----------
    name
        Name of the way, unique in the routine.
    accepts
        Argument to entity kinds, where this way takes fewer than the routine does (a message needs a reader).
    roles
        The robots' parts, at least one.
    hand_overs
        Which role hands over to which. Default: none.
    """

    name: Id
    roles: tuple[RoleSpec, ...]
    accepts: Mapping[Id, tuple[Id, ...]] = field(default_factory=dict)
    hand_overs: tuple[HandOver, ...] = ()

    def _check(self) -> None:
        if not self.roles:
            raise ValueError(f"branch {self.name!r} has no roles.")
        require_unique("role", tuple(role.name for role in self.roles))
        require_unique(f"branch {self.name!r}: giver", tuple(one.giver for one in self.hand_overs))
        for one in self.hand_overs:
            if why := self._unfit(one):
                raise ValueError(f"branch {self.name!r}: {one.giver!r} cannot hand over to {one.taker!r}: {why}.")

    def _unfit(self, one: HandOver) -> str:
        """Why a hand-over can never be; empty if it can."""
        roles = {role.name: role for role in self.roles}
        for name in (one.giver, one.taker):
            if name not in roles:
                return f"there is no role {name!r}; roles are {', '.join(roles)}"
        if one.giver == one.taker:
            return "it is one role"
        last, first = roles[one.giver].actions[-1], roles[one.taker].actions[0]
        for role, step in ((roles[one.giver], last), (roles[one.taker], first)):
            if role.robots > 1 and step.sync is None:
                return (
                    f"{role.name!r} has {role.robots} robots, which do {step.name!r} not jointly; give it a sync label"
                )
        if last.sync is not None and last.sync == first.sync:
            return "they are done jointly"
        if len(roles[one.giver].actions) == 1 and any(other.taker == one.giver for other in self.hand_overs):
            return f"{one.giver!r} takes over, too; give it a second action"
        if last.open_ended:
            return f"{last.name!r} has no end of its own"
        if first.at is None:
            return f"{first.name!r} is done at no place; give it at"
        if first.at not in (there := _left_at(roles[one.giver])):
            where = " or ".join(sorted(there)) or "a place, which it has not"
            return f"{first.name!r} is done at {first.at!r}, and {one.giver!r} ends at {where}"
        return ""


def _left_at(role: RoleSpec) -> set[str]:
    """Arguments at whose place a role ends: where it was last, and what it brought there."""
    here: set[str] = set()
    for step in role.actions:
        if step.goes_to is not None:
            here = {step.goes_to, *step.brings}
        elif step.at is not None and step.at not in here:
            here = {step.at}
    return here


@dataclass(frozen=True, slots=True, kw_only=True)
class Part(Value):
    """
    A routine within a composed routine.

    Parameters
    ----------
    routine
        Id of the routine.
    arguments
        Its argument to the composed routine's argument. Default: same names.
    """

    routine: Id
    arguments: Mapping[Id, Id] = field(default_factory=dict)


@dataclass(frozen=True, kw_only=True)
class Routine(Value):
    """
    A subtree routine.

    Parameters
    ----------
    id
        Name. Language models see it as ``<id>Tree``; both spellings are accepted everywhere.
    purpose
        What it achieves, one sentence with ``{argument}`` fields: people and language models read it.
    arguments
        Typed arguments, in order. Each call may also name *resources*, the robot types allowed.
    verbs
        English verbs whose objects are the arguments in order, for authors that read plain language.
    says
        Further wordings for such authors: patterns with every argument in ``{braces}``, see :mod:`~missiontree.mission.pattern`.
    branches
        Ways of doing it. Either this or ``parts``.
    parts
        Routines it is composed of, done one after the other.
    same_robot
        Indices of parts whose roles are filled by one robot and merge into one held role. Those parts must have single-role
        branches.
    """

    id: Id
    purpose: str
    arguments: tuple[Argument, ...]
    verbs: tuple[str, ...] = ()
    says: tuple[str, ...] = ()
    branches: tuple[Branch, ...] = ()
    parts: tuple[Part, ...] = ()
    same_robot: tuple[int, ...] = ()

    def _check(self) -> None:
        names = tuple(argument.name for argument in self.arguments)
        require_unique("argument", names)
        if not self.arguments or "robot" in names or "resources" in names:
            raise ValueError(f"routine {self.id!r} needs arguments; 'robot' and 'resources' are not free as names.")
        if bool(self.branches) == bool(self.parts):
            raise ValueError(f"routine {self.id!r} needs either branches or parts, and not both.")
        for pattern, forms in zip(self.says, self.forms, strict=True):
            for form in forms:
                slots = tuple(element.text for element in form if element.kind == "slot")
                if sorted(slots) != sorted(names):
                    raise ValueError(
                        f"routine {self.id!r}: the pattern {pattern!r} has the slots {', '.join(slots) or 'none'}; "
                        f"it needs each argument once: {', '.join(names)}."
                    )
        require_unique("branch", tuple(branch.name for branch in self.branches))
        for mentioned in self._mentions():
            if mentioned not in names:
                raise ValueError(
                    f"routine {self.id!r} speaks of {mentioned!r}, which is not among its arguments {', '.join(names)}."
                )
        for index in self.same_robot:
            if not 0 <= index < len(self.parts):
                raise ValueError(
                    f"routine {self.id!r}: same_robot names part {index}, parts count from 0 to {len(self.parts) - 1}."
                )

    @cached_property
    def forms(self) -> tuple[tuple[Form, ...], ...]:
        """The forms of each pattern."""
        return tuple(forms_of(pattern) for pattern in self.says)

    def _mentions(self) -> list[str]:
        mentioned = _FIELD.findall(self.purpose) + [own for part in self.parts for own in part.arguments.values()]
        for branch in self.branches:
            mentioned += branch.accepts
            for role in branch.roles:
                mentioned += [need.reference[0] for need in role.needs if need.reference]
                mentioned += [name for action in role.actions for name in action.mentions]
        return mentioned

    @cached_property
    def argument_kinds(self) -> dict[str, tuple[str, ...]]:
        """Kinds accepted, by argument name."""
        return {argument.name: argument.kinds for argument in self.arguments}

    @property
    def wire_name(self) -> str:
        """The name language models see: ``SearchTree``."""
        return f"{self.id}Tree"


@dataclass(frozen=True, kw_only=True)
class RoutineLibrary(Value):
    """
    The routines on offer.

    Parameters
    ----------
    routines
        Routines; ids are unique, and so are wire names. The parts of composed ones are among them.
    """

    routines: tuple[Routine, ...]

    def _check(self) -> None:
        require_unique("routine", tuple(routine.id for routine in self.routines))
        spellings = tuple(name for routine in self.routines for name in {routine.id, routine.wire_name})
        require_unique("routine name", spellings)
        for routine in self.routines:
            self._check_parts(routine)
        self._check_circles()

    def _check_parts(self, routine: Routine) -> None:
        for part in routine.parts:
            inner = self.by_id.get(part.routine)
            if inner is None:
                raise ValueError(f"routine {routine.id!r} is composed of {part.routine!r}, which is not known.")
            if missing := [
                a.name for a in inner.arguments if a.name not in part.arguments and a.name not in routine.argument_kinds
            ]:
                raise ValueError(f"routine {routine.id!r} gives part {inner.id!r} no {missing[0]!r}.")
            if unknown := [name for name in part.arguments if name not in inner.argument_kinds]:
                raise ValueError(
                    f"routine {routine.id!r} gives part {inner.id!r} an argument {unknown[0]!r} that it does not have."
                )

    def _check_circles(self) -> None:
        """Take away, again and again, what is composed only of what was taken away; circles are what remains."""
        left = {routine.id: {part.routine for part in routine.parts} for routine in self.routines}
        users: dict[str, list[str]] = {name: [] for name in left}
        for name, parts in left.items():
            for part in parts:
                users[part].append(name)
        done = [name for name, parts in left.items() if not parts]
        while done:
            inner = done.pop()
            del left[inner]
            for name in users[inner]:
                left[name].discard(inner)
                if not left[name]:
                    done.append(name)
        if left:
            way = [next(iter(left))]
            while way.count(way[-1]) == 1:
                way.append(min(left[way[-1]]))
            circle = way[way.index(way[-1]) :]
            raise ValueError(f"routine {circle[0]!r} is composed of itself: {' > '.join(circle)}.")

    @cached_property
    def by_id(self) -> dict[str, Routine]:
        """Routines by id."""
        return {routine.id: routine for routine in self.routines}

    def find(self, spelling: str) -> Routine | None:
        """The routine of that id or wire name, exactly spelt; None if there is none."""
        return self.by_id.get(spelling) or next((r for r in self.routines if r.wire_name == spelling), None)
