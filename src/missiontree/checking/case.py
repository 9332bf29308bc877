"""The plan as the checker reads it: everything derived here, from the inputs, without asking a solver."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from functools import cached_property
from typing import Any, TypeVar

from missiontree.checking.fault import Fault
from missiontree.checking.regrounding import Regrounding, regrounding
from missiontree.checking.staffing import Staffing
from missiontree.checking.timetable import Timetable
from missiontree.checking.ways import Ways
from missiontree.errors import InputError
from missiontree.formats.digest import digest
from missiontree.llm.recording import Recording, read_recording
from missiontree.mission.entity import Entity
from missiontree.mission.estimator_source import Estimated
from missiontree.mission.fleet import Fleet, Robot
from missiontree.mission.grounded import GroundedTree, Grounding
from missiontree.mission.plan import Plan
from missiontree.mission.reason import Reason
from missiontree.mission.scene import Scene
from missiontree.mission.tree import MissionNode, MissionTree

WORKING = ("optimal", "feasible")
About = TypeVar("About")
Made = TypeVar("Made")


class Case:
    """
    One plan under examination.

    Parameters
    ----------
    plan
        Any plan, however damaged. What dangles is left out of the views below and reported by the rules on references.
    known
        Its tree grounded anew beforehand; taken only if it is of this plan. Default: that is done when a rule asks.
    """

    def __init__(self, plan: Plan, known: Regrounding | None = None) -> None:
        self.plan, self._known = plan, known
        self._made: dict[tuple[object, object], Any] = {}

    def once(self, work: Callable[[Case, About], Made], about: About) -> Made:
        """What a function makes of this case and of something in it, worked out for the first rule that asks."""
        key = (work, about)
        if key not in self._made:
            self._made[key] = work(self, about)
        made: Made = self._made[key]
        return made

    @property
    def fleet(self) -> Fleet:
        """The team."""
        return self.plan.brief.fleet

    @cached_property
    def left_out(self) -> frozenset[str]:
        """Robots that take no part: those that the mission leaves out by name, and all of the types that it leaves out."""
        out, fleet = self.plan.brief.without, self.fleet
        return frozenset(
            robot
            for robot, kind in (fleet.type_of.items() if out else ())
            if kind.id in out or (robot in out and robot not in fleet.by_id)
        )

    def at_hand(self, type_id: str) -> tuple[Robot, ...]:
        """Robots of a type that are not left out."""
        return tuple(robot for robot in self.fleet.by_id[type_id].members if robot.id not in self.left_out)

    def most_in_use(self, type_id: str) -> int:
        """How many different robots of a type may take part."""
        most, there = self.fleet.by_id[type_id].max_in_use, len(self.at_hand(type_id))
        return there if most is None else min(most, there)

    @property
    def mission_tree(self) -> MissionTree | None:
        """The tree as authored."""
        return self.plan.tree

    @property
    def tree(self) -> GroundedTree | None:
        """The tree over the fleet."""
        return self.plan.grounding.tree if self.plan.grounding is not None else None

    @cached_property
    def has_times(self) -> bool:
        """Whether anything at all has a release time or a deadline."""
        grounded, authored = self.tree.nodes if self.tree else (), self.plan.tree.nodes if self.plan.tree else ()
        return (
            self.plan.brief.deadline_s is not None
            or any(node.release_s or node.deadline_s is not None for node in grounded)
            or any(node.release_s or node.deadline_s is not None for node in authored)
        )

    @cached_property
    def clash(self) -> str:
        """Why the entities of the tree do not fit into the scene; empty if they do."""
        try:
            self.plan.brief.world.extended(self._introduced)
        except ValueError as error:
            return str(error)
        return ""

    @cached_property
    def scene(self) -> Scene:
        """The world with everything introduced; without the tree's entities if those do not fit."""
        world = self.plan.brief.world
        return world if self.clash else world.extended(self._introduced)

    @property
    def _introduced(self) -> tuple[Entity, ...]:
        return self.plan.tree.entities if self.plan.tree is not None else ()

    @cached_property
    def regrounded(self) -> Grounding | str | None:
        """The mission tree grounded anew; why it cannot be; None if the plan holds no mission tree and grounding to compare."""
        if self.plan.tree is None or self.plan.grounding is None:
            return None
        if self._known is not None and self._known.is_of(self.plan):
            return self._known.found
        return regrounding(self.plan.tree, self.plan.brief, self.plan.grounding.estimates).found

    @cached_property
    def answers(self) -> dict[tuple[str, str, str, str | None], tuple[Estimated, ...]]:
        """What the user's own estimator said, by type, action, capability and where."""
        found: dict[tuple[str, str, str, str | None], tuple[Estimated, ...]] = {}
        for said in self.plan.grounding.estimates if self.plan.grounding is not None else ():
            about = (said.robot_type, said.action, said.rating, said.at)
            found[about] = (*found.get(about, ()), said)
        return found

    @cached_property
    def routine_nodes(self) -> tuple[MissionNode, ...]:
        """Leaves of the mission tree that name a routine."""
        return tuple(node for node in self.plan.tree.nodes if node.routine) if self.plan.tree is not None else ()

    @cached_property
    def staffings(self) -> tuple[Staffing, ...]:
        """Every alternative, with what is selected derived from its choices."""
        if self.tree is None or self.plan.ranking is None:
            return ()
        return tuple(
            Staffing(self.tree, self.mission_tree, alternative) for alternative in self.plan.ranking.alternatives
        )

    @cached_property
    def timetables(self) -> tuple[Timetable, ...]:
        """Every schedule that claims to work and belongs to an alternative."""
        by_rank = {staffing.alternative.rank: staffing for staffing in reversed(self.staffings)}
        return tuple(
            Timetable(by_rank[schedule.rank], schedule)
            for schedule in self.plan.schedules
            if schedule.status in WORKING and schedule.rank in by_rank
        )

    @cached_property
    def recording(self) -> Recording | str | None:
        """The dialogue that built the tree, read; why it cannot be read; None if there is none."""
        lines = self.plan.provenance.transcript
        try:
            return read_recording(lines) if lines else None
        except InputError as error:
            return str(error)

    @cached_property
    def same_inputs(self) -> bool:
        """Whether the dialogue was held about the plan's own mission and inputs."""
        return isinstance(self.recording, Recording) and self.recording.mission == digest(self.plan.brief)

    def ending(self, what: str) -> tuple[Reason, ...]:
        """Reasons or remarks that the dialogue ends with; none if it was held about something else, or if they are no reasons."""
        if not isinstance(self.recording, Recording) or not self.same_inputs:
            return ()
        try:
            return tuple(Reason(**plain) for plain in self.recording.end[what])
        except (TypeError, ValueError):
            return ()

    @cached_property
    def ways(self) -> Ways:
        """The checker's own distances."""
        return Ways(self.scene)


Rule = Callable[[Case], Iterable[Fault]]
