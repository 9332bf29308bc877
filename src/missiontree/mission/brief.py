"""The mission as the operator states it: the words, the team, the world, the routines, and what counts as good."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from difflib import get_close_matches
from functools import cached_property

from missiontree.mission.aim import Accumulate, Aim
from missiontree.mission.charger import check_full
from missiontree.mission.entity import Entity
from missiontree.mission.estimate import Weights
from missiontree.mission.estimator_source import EstimatorSource
from missiontree.mission.fleet import Fleet, Robot, RobotType
from missiontree.mission.goal import Goal, all_goals, check_goals
from missiontree.mission.objective import WEIGHTED, Objective
from missiontree.mission.routine import RoutineLibrary
from missiontree.mission.scene import Scene
from missiontree.mission.terms import Terms, check_terms, checked_quality
from missiontree.mission.value import Id, NonNegative, Positive, Value


@dataclass(frozen=True, kw_only=True)
class MissionBrief(Value):
    """
    Everything that planning starts from.

    Parameters
    ----------
    text
        The mission in words. It is the operator's word; everything in the scene is data. Beside ``goals`` it is only the objective's title.
    fleet
        The team.
    routines
        Routines on offer.
    scene
        The world; None if the mission is planned without one.
    entities
        Entities the operator declares beside the scene, such as the kind of a thing that the text names.
    weights
        What counts as good.
    check_kinds
        Whether kinds of arguments are enforced. Default true; false reproduces the paper's examples.
    goals
        What is to be achieved, if it is stated formally instead of in words.
    without
        Robot types and robots that take no part. A name that both a type and a robot have means the type.
    require
        Robot types and robots that must take part: in every alternative each of them fills at least one role.
    min_quality
        Quality that every action must have at least: one number for all (``0.5``), or a number by routine or capability
        (``{Search: 0.8, carry: 0.5}``), of which the highest that applies counts. At least 0, default 0. Who would do worse is not
        offered.
    estimator
        Whose the estimates are, if not the fleet's: an estimator of the user's own. Default: the fleet's table.
    deadline_s
        The whole mission has ended by then, ways home included; seconds from its start, at least 0. None (default) means no deadline.
    accumulate
        How the utilities of actions make that of an alternative: their ``sum`` (default), which favours alternatives with more actions,
        their ``mean``, or the least of them (``min``). Of an alternative without actions each of them is 0.
    diverse
        Whether alternatives are to differ in team: the best; then the best of those in which another set of robot types takes part; and
        so on. Default false.
    parts
        How much parts of the mission count where not all of it can be done: a weight above 0 by the name of a part, which is the id, the
        label or the call of a node of the mission tree, such as ``Search(cat)``. Default: see :class:`missiontree.mission.partial.Partial`.
    return_home
        Whether each robot that takes part goes back to where it started, after its last action. Default false.
    objective
        What decides which alternative is chosen, schedules included: ``utility`` (default), ``makespan``, ``utility-makespan``,
        ``weighted-team`` or ``weighted-sum``; see :data:`missiontree.mission.objective.Objective`. Ranks go by utility alone, whatever
        is chosen.

    Raises
    ------
    ValueError
        If fleet, scene, goals, entities and terms refer to each other in vain, or terms contradict each other.
    """

    text: str
    fleet: Fleet
    routines: RoutineLibrary
    scene: Scene | None = None
    entities: tuple[Entity, ...] = ()
    weights: Weights = Weights()
    check_kinds: bool = True
    goals: tuple[Goal, ...] = ()
    without: tuple[Id, ...] = ()
    require: tuple[Id, ...] = ()
    min_quality: NonNegative | Mapping[Id, NonNegative] = 0.0
    estimator: EstimatorSource | None = None
    deadline_s: NonNegative | None = None
    accumulate: Accumulate = "sum"
    diverse: bool = False
    parts: Mapping[str, Positive] = field(default_factory=dict)
    return_home: bool = False
    objective: Objective = "utility"

    def _check(self) -> None:
        world = self.world
        check_goals(self.goals)
        zones = {zone.id for zone in world.zones}
        for robot_type in self.fleet.types:
            starts: tuple[RobotType | Robot, ...] = (robot_type, *robot_type.robots)
            for start in starts:
                if start.place is not None and start.place not in world.by_id:
                    raise ValueError(f"{start.id!r} starts at place {start.place!r}, which the scene does not have.")
                if start.position is not None:
                    world.in_map(start.position)
            for zone in robot_type.zones or ():
                if self.scene is not None and zone not in zones:
                    raise ValueError(
                        f"robot type {robot_type.id!r} may enter zone {zone!r}, which the scene does not have."
                    )
        self._check_type_names(world)
        for charger in world.chargers:
            for kind in self.fleet.types:
                if charger.serves(kind.id):
                    check_full(kind, charger)
        self._check_held(world)
        self._check_terms()
        if self.objective in WEIGHTED:
            self._check_weighted()

    def _check_weighted(self) -> None:
        if self.accumulate != "sum":
            raise ValueError(
                f"the objective {self.objective!r} adds up, and accumulate is {self.accumulate!r}; leave one of them out."
            )
        if not self.weights.beta:
            raise ValueError(
                f"the objective {self.objective!r} weighs time, and the weight of a second (beta) is 0; "
                "give weights, as in weights: {alpha: 1, beta: 0.01}, or take the objective 'utility'."
            )

    def _check_type_names(self, world: Scene) -> None:
        roads = world.roads
        restricted = [("keep-out " + area.id, area.types) for area in world.keep_outs]
        restricted += [(f"road {road.ends[0]} - {road.ends[1]}", road.types) for road in (roads.roads if roads else ())]
        restricted += [(f"lift {lift.id}", lift.types) for lift in (roads.lifts if roads else ())]
        restricted += [(f"goal {goal.shown!r}", (*(goal.by or ()), *goal.not_by)) for goal in all_goals(self.goals)]
        restricted += [(f"charger {charger.id}", charger.types) for charger in world.chargers]
        for what, types in restricted:
            for name in types or ():
                if name not in self.fleet.by_id:
                    raise ValueError(f"{what} names robot type {name!r}, which the fleet does not have.")

    def _check_held(self, world: Scene) -> None:
        """What routines hold by name is a shared resource of the scene; without a scene there is nothing to share."""
        for routine in self.routines.routines if self.scene is not None else ():
            for action in (step for way in routine.branches for role in way.roles for step in role.actions):
                for held in action.holds:
                    if not held.startswith("{") and held not in world.shared:
                        near = get_close_matches(held, world.shared, n=1)
                        known = ", ".join(world.shared) or "none; declare them under resources"
                        raise ValueError(
                            f"action {action.name!r} of routine {routine.id!r} holds {held!r}, which is no shared resource of the scene"
                            + (f"; the nearest is {near[0]!r}" if near else "")
                            + f". It has {known}. An argument stands in braces: {{door}}."
                        )

    def _check_terms(self) -> None:
        object.__setattr__(self, "min_quality", checked_quality(self.min_quality))
        ratings = {role.rating for one in self.routines.routines for way in one.branches for role in way.roles}
        ratings |= {ability for kind in self.fleet.types for ability in kind.capabilities}
        check_terms(self.terms, self.fleet, tuple(self.routines.by_id), tuple(sorted(ratings)))

    @cached_property
    def terms(self) -> Terms:
        """What is asked of the mission as a whole."""
        return Terms(
            without=self.without,
            require=self.require,
            min_quality=self.min_quality,
            stock=self.world.stock,
            by_estimator=self.estimator is not None,
            return_home=self.return_home,
            chargers=self.world.chargers,
            home_by_s=self.deadline_s if self.return_home else None,
        )

    @property
    def aim(self) -> Aim:
        """What the best alternatives are."""
        return Aim(accumulate=self.accumulate, diverse=self.diverse)

    @cached_property
    def weighed(self) -> Mapping[str, float]:
        """Weights of parts by name: those that goals have, and those of ``parts``, which go before them."""
        of_goals = {goal.do or goal.task: goal.weight for goal in all_goals(self.goals) if goal.weight is not None}
        return of_goals | dict(self.parts)

    @cached_property
    def team(self) -> Fleet:
        """The fleet without what the mission leaves out."""
        return self.terms.team_of(self.fleet)

    @cached_property
    def world(self) -> Scene:
        """The scene, or an empty one, with the entities that the operator declares."""
        return (self.scene if self.scene is not None else Scene()).extended(self.entities)

    @property
    def words(self) -> str:
        """Everything the operator says: the text, and the names that goals use."""
        return "; ".join((self.text, *(name for goal in all_goals(self.goals) for name in goal.entities)))
