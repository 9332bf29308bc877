"""The routine calls of a mission tree: who can do them, by which ways, and what they mean for the entities they name."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass, field, replace

from missiontree.mission.brief import MissionBrief
from missiontree.mission.entity import Entity
from missiontree.mission.reason import Reason
from missiontree.mission.scene import Scene
from missiontree.mission.tree import MissionNode, MissionTree
from missiontree.routines.arguments import check_resources, find_entities, find_routine
from missiontree.routines.compose import FlatBranch, FlatRole, flatten
from missiontree.routines.itinerary import Itineraries, Travel, unreachable
from missiontree.routines.offers import BranchOffer, Offers, offers_for
from missiontree.routines.staffing import shortage

Key = tuple[str, tuple[tuple[str, str], ...], tuple[str, ...] | None]
Travels = Mapping[tuple[int, str], tuple[Travel, ...]]


@dataclass(frozen=True, slots=True)
class Touch:
    """
    Entities that a call touches, by id, in the order in which it names them.

    Parameters
    ----------
    places
        Those at whose place something is done, or that are gone to.
    moves
        Those it brings to another place.
    finds
        Those whose position is known afterwards.
    unfound
        Those it uses before it found them itself.
    """

    places: tuple[str, ...]
    moves: tuple[str, ...]
    finds: tuple[str, ...]
    unfound: tuple[str, ...]

    @property
    def uses(self) -> tuple[str, ...]:
        """Everybody whose position matters to it."""
        return tuple(dict.fromkeys((*self.places, *self.moves)))


@dataclass(frozen=True, slots=True)
class Way:
    """
    A branch that can be done, with the travel of each type in each role.

    Parameters
    ----------
    offer
        Branch and types.
    travels
        Travel for each action, by role index and type id.
    """

    offer: BranchOffer
    travels: Travels


@dataclass(frozen=True, slots=True)
class Call:
    """
    A routine with its arguments.

    Parameters
    ----------
    entities
        Entity by argument.
    ways
        What can be done.
    touch
        What it means for the entities.
    not_offered, assumptions
        What was refused and what was taken for granted.
    """

    entities: Mapping[str, Entity]
    ways: tuple[Way, ...]
    touch: Touch
    not_offered: tuple[Reason, ...]
    assumptions: tuple[Reason, ...]


@dataclass(slots=True)
class _Remembered:
    """Calls that are alike are worked out once, and what calls of the same routine share."""

    branches: dict[str, tuple[FlatBranch, ...]] = field(default_factory=dict)
    offers: dict[Key, tuple[Mapping[str, Entity], Offers, Touch]] = field(default_factory=dict)
    calls: dict[tuple[Key, frozenset[str]], Call] = field(default_factory=dict)


def calls_of(tree: MissionTree, brief: MissionBrief, world: Scene) -> dict[str, Call]:
    """
    Calls by id of the routine node, in tree order.

    Raises
    ------
    InputError
        If a routine, an argument, an entity or a robot type is not known.
    """
    leaves = [node for node in tree.nodes if node.routine is not None]
    remembered = _Remembered()
    for node in leaves:
        if _key(node) not in remembered.offers:
            remembered.offers[_key(node)] = _offered(node, brief, world, remembered.branches)
    movers = Counter(entity for node in leaves for entity in remembered.offers[_key(node)][2].moves)
    itineraries = Itineraries(world)
    calls: dict[str, Call] = {}
    for node in leaves:
        entities, offers, touch = remembered.offers[_key(node)]
        elsewhere = frozenset(
            entity.id for entity in entities.values() if movers[entity.id] > (entity.id in touch.moves)
        )
        key = (_key(node), elsewhere)
        if key not in remembered.calls:
            remembered.calls[key] = _routed(entities, offers, touch, brief, itineraries, elsewhere)
        calls[node.id] = remembered.calls[key]
    return calls


def _key(node: MissionNode) -> Key:
    assert node.routine is not None, "only routine nodes are calls"
    return node.routine, tuple(node.arguments.items()), node.resources


def _offered(
    node: MissionNode, brief: MissionBrief, world: Scene, branches: dict[str, tuple[FlatBranch, ...]]
) -> tuple[Mapping[str, Entity], Offers, Touch]:
    assert node.routine is not None, "only routine nodes are calls"
    routine = find_routine(node.routine, brief.routines, node.id)
    entities = find_entities(routine, node.arguments, world, node.id)
    check_resources(node.resources, brief.fleet, f"{node.id}.resources")
    if routine.id not in branches:
        branches[routine.id] = flatten(routine, brief.routines)
    offers = offers_for(
        routine,
        entities,
        brief.fleet,
        world,
        brief.routines,
        resources=node.resources,
        check_kinds=brief.check_kinds,
        terms=brief.terms,
        flat=branches[routine.id],
    )
    return entities, offers, _touch(entities, [offer.branch for offer in offers.branches])


def _touch(entities: Mapping[str, Entity], branches: list[FlatBranch]) -> Touch:
    places: dict[str, None] = {}
    moves: dict[str, None] = {}
    finds: dict[str, None] = {}
    unfound: dict[str, None] = {}
    for branch in branches:
        found: set[str] = set()
        for step in (action.step for role in branch.roles for action in role.actions):
            if step.finds is not None:
                found.add(step.finds)
                finds[entities[step.finds].id] = None
            for name in (step.at, step.goes_to):
                if name is not None:
                    places[entities[name].id] = None
                    if name not in found:
                        unfound[entities[name].id] = None
            moves |= {entities[name].id: None for name in step.brings}
            found |= set(step.brings)
    return Touch(tuple(places), tuple(moves), tuple(finds), tuple(unfound))


def _routed(
    entities: Mapping[str, Entity],
    offers: Offers,
    touch: Touch,
    brief: MissionBrief,
    itineraries: Itineraries,
    elsewhere: frozenset[str],
) -> Call:
    """The call with travel; types that can never get where they must are refused."""
    ways: list[Way] = []
    refused = list(offers.refused)
    for offer in offers.branches:
        travels, stuck, types = _travels(offer, entities, brief, itineraries, elsewhere)
        refused += stuck
        if not stuck:
            ways.append(Way(offer, travels))
        elif not all(types):
            refused += _lost(offer, types)
        elif (reason := shortage(offer.branch, types, brief.team, offer.task)) is not None:
            refused.append(reason)
        else:
            ways.append(Way(replace(offer, types=types), travels))
    return Call(entities, tuple(ways), touch, tuple(dict.fromkeys(refused)), offers.assumptions)


def _travels(
    offer: BranchOffer,
    entities: Mapping[str, Entity],
    brief: MissionBrief,
    itineraries: Itineraries,
    elsewhere: frozenset[str],
) -> tuple[Travels, list[Reason], tuple[tuple[str, ...], ...]]:
    """Travel by role and type; why types are stuck; and the types that are not."""
    travels: dict[tuple[int, str], tuple[Travel, ...]] = {}
    stuck: list[Reason] = []
    for index, role in enumerate(offer.branch.roles):
        uncertain = elsewhere | _moved_by_others(offer.branch, role, entities)
        for type_id in offer.types[index]:
            robot_type = brief.team.by_id[type_id]
            travel = itineraries.walk(role, robot_type, entities, uncertain)
            if isinstance(travel, Reason):
                stuck.append(unreachable(travel, robot_type, offer.task))
            else:
                travels[index, type_id] = travel
    able = tuple(
        tuple(type_id for type_id in types if (index, type_id) in travels) for index, types in enumerate(offer.types)
    )
    return travels, stuck, able


def _moved_by_others(branch: FlatBranch, role: FlatRole, entities: Mapping[str, Entity]) -> frozenset[str]:
    """Entities that other roles of the branch bring along, and this one does not."""
    brought = {
        each: {entities[name].id for action in each.actions for name in action.step.brings} for each in branch.roles
    }
    return frozenset(set().union(*(brought[each] for each in branch.roles)) - brought[role])


def _lost(offer: BranchOffer, types: tuple[tuple[str, ...], ...]) -> list[Reason]:
    if len(types) == 1:
        return []
    return [
        Reason(
            rule="no_robot_able",
            message=f"{offer.task} needs a robot as {role.name}, and none can get where it must.",
            found="no robot type",
            needed=role.name,
        )
        for role, able in zip(offer.branch.roles, types, strict=True)
        if not able
    ]
