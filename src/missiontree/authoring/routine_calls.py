"""One routine of an ``attachMultiSubTrees`` call: its name, its arguments, the robot types allowed, and who can do it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from missiontree.authoring.answer import RefusalError, refuse
from missiontree.authoring.entities import Cast
from missiontree.authoring.matching import did_you_mean, listed, quoted, same_name
from missiontree.authoring.wire import RULE, kind_of_json
from missiontree.mission.brief import MissionBrief
from missiontree.mission.entity import Entity
from missiontree.mission.fleet import Fleet
from missiontree.mission.reason import Reason
from missiontree.mission.routine import Routine, RoutineLibrary
from missiontree.mission.scene import Scene
from missiontree.routines.offers import Offers, offers_for


@dataclass(frozen=True, slots=True)
class RoutineCall:
    """A routine with its entities, as asked for, and what the fleet offers for it."""

    routine: Routine
    entities: Mapping[str, Entity]
    resources: tuple[str, ...] | None
    offers: Offers

    @property
    def label(self) -> str:
        """What people read: ``Search(Child)``."""
        return f"{self.routine.id}({', '.join(entity.label for entity in self.entities.values())})"


def read_routine_call(name: str, given: Any, what: str, cast: Cast) -> RoutineCall:
    """
    Understand one routine call, completely or not at all.

    Parameters
    ----------
    name
        The routine, with or without ``Tree``.
    given
        Its arguments: a list in the routine's order, or an object by argument; both may end in *resources*.
    what
        Where they stand in the call, for messages.
    cast
        Who may be named.

    Raises
    ------
    RefusalError
        ``unknown_routine``, ``malformed_arguments``, ``unknown_entity``, ``same_entity_twice``, ``wrong_kind``, ``unknown_robot``,
        ``no_robot_able``.
    """
    brief = cast.brief
    routine = find_routine(brief.routines, name)
    by_name = _by_name(routine, given, what)
    resources = _read_resources(by_name.pop("resources", None), brief.fleet, what)
    entities = {argument: cast.resolve(spelling) for argument, spelling in by_name.items()}
    _check_different(routine, entities)
    if brief.check_kinds:
        _check_kinds(routine, entities, cast)
    offers = offers_for(
        routine, entities, brief.fleet, cast.scene, brief.routines, resources, brief.check_kinds, brief.terms
    )
    call = RoutineCall(routine, entities, resources, offers)
    if not offers.able:
        raise _nobody(call)
    return call


def find_routine(library: RoutineLibrary, name: str) -> Routine:
    """
    The routine of that id or wire name, exactly spelt.

    Raises
    ------
    RefusalError
        ``unknown_routine`` with the nearest names.
    """
    routine = library.find(name)
    if routine is None:
        names = [known.wire_name for known in library.routines]
        hint = f"{did_you_mean(name, names)} Routines are: {listed(names)}.".strip()
        raise refuse("unknown_routine", f"There is no routine {quoted(name)}.", node=name[:200], hint=hint)
    return routine


def able_types(brief: MissionBrief) -> dict[str, Offers]:
    """
    What the fleet offers for every routine, whoever it is about, by routine id.

    Each argument is stood for by an entity of which nothing is known, and kinds are not looked at; so a routine that nobody can do
    here can be done for nobody.
    """
    made = {}
    for routine in brief.routines.routines:
        anybody = {argument.name: Entity(id=argument.name) for argument in routine.arguments}
        scene = Scene(entities=tuple(anybody.values()))
        made[routine.id] = offers_for(
            routine, anybody, brief.fleet, scene, brief.routines, check_kinds=False, terms=brief.terms
        )
    return made


def form_of(routine: Routine) -> str:
    """How the routine is called: ``TransportTree(agent, location)``."""
    return f"{routine.wire_name}({', '.join(argument.name for argument in routine.arguments)})"


def _by_name(routine: Routine, given: Any, what: str) -> dict[str, Any]:
    """Arguments by name, entity names as texts; *resources* still unread."""
    names = [argument.name for argument in routine.arguments]
    form = f"Give {form_of(routine)} as a list in that order or as an object; both may end in resources, a list of robot types."
    if isinstance(given, list):
        if len(given) not in {len(names), len(names) + 1}:
            raise refuse(RULE, f"{what} has {len(given)} entries; {routine.id} takes {len(names)}.", hint=form)
        given = dict(zip([*names, "resources"], given, strict=False))
    if not isinstance(given, dict):
        raise refuse(RULE, f"{what} is {kind_of_json(given)} where arguments are expected.", hint=form)
    for name in given:
        if name not in names and name != "resources":
            hint = f"{did_you_mean(name, names)} {form}".strip()
            raise refuse(RULE, f"{what}: {routine.id} has no argument {quoted(name)}.", hint=hint)
    for name in names:
        if name not in given:
            raise refuse(RULE, f"{what} lacks {routine.id}'s argument {name!r}.", hint=form)
        if not isinstance(given[name], str):
            said = f"{what}: {name} is {kind_of_json(given[name])} where the name of an entity is expected."
            raise refuse(RULE, said, hint=form)
    in_order = {name: given[name] for name in names}
    return in_order | ({"resources": given["resources"]} if "resources" in given else {})


def _read_resources(given: Any, fleet: Fleet, what: str) -> tuple[str, ...] | None:
    if given is None:
        return None
    if not isinstance(given, list) or not all(isinstance(name, str) for name in given):
        message = f"{what}: resources is {kind_of_json(given)} where a list of robot types is expected."
        raise refuse(RULE, message, hint=f"Robot types are: {listed(fleet.by_id)}.")
    if not given:
        raise refuse(
            RULE, f"{what}: resources is empty, which allows no robot.", hint="Leave resources out to allow all."
        )
    return tuple(dict.fromkeys(_find_type(fleet, name) for name in given))


def _find_type(fleet: Fleet, name: str) -> str:
    if name in fleet.by_id:
        return name
    found = [kind.id for kind in fleet.types if same_name(name) in {same_name(kind.id), same_name(kind.label)}]
    if len(found) == 1:
        return found[0]
    spellings = [spelling for kind in fleet.types for spelling in (kind.id, kind.label)]
    hint = f"{did_you_mean(name, spellings)} Robot types are: {listed(fleet.by_id)}.".strip()
    raise refuse("unknown_robot", f"There is no robot type {quoted(name)}.", robot=name[:200], hint=hint)


def _check_different(routine: Routine, entities: Mapping[str, Entity]) -> None:
    taken: dict[str, str] = {}
    for name, entity in entities.items():
        if entity.id in taken:
            raise refuse(
                "same_entity_twice",
                f"{routine.id} is given {entity.label} as {taken[entity.id]} and as {name}.",
                node=entity.id,
                hint="Name somebody or something else for one of them.",
            )
        taken[entity.id] = name


def _check_kinds(routine: Routine, entities: Mapping[str, Entity], cast: Cast) -> None:
    for name, entity in entities.items():
        accepted = routine.argument_kinds[name]
        if not set(cast.scene.lineage(entity.kind)) & set(accepted):
            guessed = entity in (*cast.introduced, *cast.added)
            mend = (
                f"If {entity.label} is one, make that known by introduceEntity and send this again. " if guessed else ""
            )
            raise refuse(
                "wrong_kind",
                f"{routine.id} takes as {name} {' or '.join(accepted)}; {entity.label} is of kind {entity.kind}.",
                node=entity.id,
                found=entity.kind,
                needed=", ".join(accepted),
                hint=f"{mend}Else use another routine, or another entity."
                if mend
                else "Use another routine, or another entity.",
            )


def _nobody(call: RoutineCall) -> RefusalError:
    message = f"No robot of this fleet can do {call.label}."
    hint = "Give a robot type what is missing, or reword the mission."
    return RefusalError(Reason(rule="no_robot_able", message=message, node=call.label, hint=hint), *call.offers.refused)
