"""Where entities are while a schedule is carried out: at their start, then where those who bring them take them."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field

from missiontree.mission.grounded import Action, GroundedTree
from missiontree.mission.position import Position
from missiontree.mission.scene import Scene
from missiontree.mission.schedule import Schedule, ScheduledAction, TravelLeg


@dataclass(frozen=True, slots=True)
class Deed:
    """
    A scheduled action with all that is known of its place.

    Parameters
    ----------
    scheduled
        The action with its robot and time.
    action
        What is done.
    leg
        The travel that it is or needs; None if there is none, or where from is not known.
    at
        Where it is done, for a move where it ends; None if anywhere, or not known.
    """

    scheduled: ScheduledAction
    action: Action
    leg: TravelLeg | None
    at: Position | None


@dataclass(slots=True)
class Whereabouts:
    """
    A schedule's actions with their places.

    Parameters
    ----------
    deeds
        By start, then end, then leaf.
    brought
        Of every entity that is moved, the moves that bring it, in order.
    """

    deeds: list[Deed] = field(default_factory=list)
    brought: dict[str, list[Deed]] = field(default_factory=dict)

    def by_robot(self) -> Iterator[tuple[str, list[Deed]]]:
        """Robots in the order in which they begin, each with its deeds."""
        own: dict[str, list[Deed]] = {}
        for deed in self.deeds:
            own.setdefault(deed.scheduled.robot, []).append(deed)
        yield from own.items()


def whereabouts_of(schedule: Schedule, tree: GroundedTree, scene: Scene) -> Whereabouts:
    """
    Tell where every action of a schedule is done.

    A leg says it; else it is where the entity is that the action is done at, as far as the moves before have taken it.
    """
    legs = {(leg.robot, leg.leaf): leg for leg in schedule.legs}
    moved: dict[str, list[tuple[float, Position | None]]] = {}
    found: dict[int, Position | None] = {}
    for one in sorted(schedule.actions, key=lambda one: (one.end_s, one.start_s, one.leaf)):
        action = tree.action(one.leaf)
        leg = legs.get((one.robot, one.leaf))
        found[one.leaf] = leg.destination if leg is not None else _spot(action.at, one.start_s, moved, scene)
        for name in action.brings if action.moves else ():
            moved.setdefault(name, []).append((one.end_s, found[one.leaf]))
    result = Whereabouts()
    for one in sorted(schedule.actions, key=lambda one: (one.start_s, one.end_s, one.leaf)):
        action = tree.action(one.leaf)
        deed = Deed(one, action, legs.get((one.robot, one.leaf)), found[one.leaf])
        result.deeds.append(deed)
        for name in dict.fromkeys(action.brings) if action.moves else ():
            moves = result.brought.setdefault(name, [])
            if action.sync is None or all(action.sync != other.action.sync for other in moves):
                moves.append(deed)  # of those who carry together, the first stands for all
    return result


def _spot(
    entity: str | None, time_s: float, moved: dict[str, list[tuple[float, Position | None]]], scene: Scene
) -> Position | None:
    """Where an entity is at a time, by the moves that ended until then."""
    if entity is None:
        return None
    for end_s, spot in reversed(moved.get(entity, ())):
        if end_s <= time_s:
            return spot
    known = scene.by_id.get(entity)
    return scene.whereabouts(known).position if known is not None else None
