"""What a mission file holds: the mission, where its inputs are, and how to plan it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from missiontree.mission.aim import Accumulate
from missiontree.mission.costs import Price, check_prices
from missiontree.mission.entity import Entity
from missiontree.mission.estimate import Weights
from missiontree.mission.goal import Goal, check_goals
from missiontree.mission.objective import Objective
from missiontree.mission.terms import checked_quality
from missiontree.mission.value import Count, Id, NonNegative, Positive, Value, require_unique


@dataclass(frozen=True, kw_only=True)
class MissionFile(Value):
    """
    A mission with everything that planning it needs. Paths are relative to the file.

    Parameters
    ----------
    mission
        The mission in words. Needed unless ``goals`` or ``tree`` are given; beside goals it is only what the mission is called.
    goals
        What is to be achieved, stated formally instead of in words.
    tree
        Path of a mission tree that is already there, instead of authoring one.
    fleet
        Path of the fleet; default: ``fleet.yaml`` beside this file, else the paper's sample fleet.
    scene
        Path of the scene; default: ``scene.yaml`` beside this file, else none.
    routines
        Paths of files with routines beside the built-in ones. A file whose name ends in ``.py`` is run.
    methods
        Paths of files with mission methods of the offline author beside the built-in ones.
    estimator
        Path of a Python file with an estimator of one's own, which is run. Default: the fleet's table.
    entities
        What the mission's words mean where the scene does not say it, such as the kind of a thing; corrects what was inferred.
    weights
        What counts as good.
    k
        How many alternatives are wanted, at least 1, default 4.
    check_kinds
        Whether kinds of arguments are enforced. Default true; false reproduces the paper's examples.
    model
        Who authors the tree: ``offline`` or the name of a language model. Default: as the environment says, else ``offline``.
    allocator
        Method of allocation, default ``exact``.
    scheduler
        Method of scheduling: ``greedy``, ``cpsat``, or ``auto``. Default: ``greedy``; ``auto`` if the objective looks at schedules, or a
        front is asked for.
    seed
        Seed of everything random, default 0.
    without
        Robot types and robots that take no part. A name that both a type and a robot have means the type.
    require
        Robot types and robots that must take part: in every alternative each of them fills at least one role.
    min_quality
        Quality that every action must have at least: one number for all (``0.5``), or a number by routine or capability
        (``{Search: 0.8, carry: 0.5}``), of which the highest that applies counts. At least 0, default 0. Who would do worse is not
        offered.
    deadline_s
        The whole mission has ended by then, ways home included; seconds from its start, at least 0. None (default) means no deadline.
    accumulate
        How the utilities of actions make that of an alternative: their ``sum`` (default), which favours alternatives with more actions,
        their ``mean``, or the least of them (``min``). Of an alternative without actions each of them is 0.
    diverse
        Whether alternatives are to differ in team: the best; then the best of those in which another set of robot types takes part; and
        so on. Default false.
    objective
        What decides which alternative is chosen, schedules included: ``utility`` (default), ``makespan``, ``utility-makespan``,
        ``weighted-team`` or ``weighted-sum``. Ranks go by utility alone, whatever is chosen.
    costs
        What changes cost that would make a mission possible, by kind of change, so that `missiontree explain` can put them in an order:
        a number, or more closely a price. Default: those of the documentation.
    parts
        How much parts of the mission count where not all of it can be done: a weight above 0 by the name of a part, which is the id, the
        label or the call of a node of the mission tree: ``{"Search(cat)": 3}``. Default: every routine counts 1.
    return_home
        Whether each robot that takes part goes back to where it started, after its last action. Default false.
    """

    mission: str = ""
    goals: tuple[Goal, ...] = ()
    tree: str | None = None
    fleet: str | None = None
    scene: str | None = None
    routines: tuple[str, ...] = ()
    methods: tuple[str, ...] = ()
    estimator: str | None = None
    entities: tuple[Entity, ...] = ()
    weights: Weights = Weights()
    k: Count = 4
    check_kinds: bool = True
    model: str = ""
    allocator: Id = "exact"
    scheduler: Id | None = None
    seed: int = 0
    without: tuple[Id, ...] = ()
    require: tuple[Id, ...] = ()
    min_quality: NonNegative | Mapping[Id, NonNegative] = 0.0
    deadline_s: NonNegative | None = None
    accumulate: Accumulate = "sum"
    diverse: bool = False
    objective: Objective = "utility"
    costs: Mapping[Id, Price | NonNegative] = field(default_factory=dict)
    parts: Mapping[str, Positive] = field(default_factory=dict)
    return_home: bool = False

    def _check(self) -> None:
        if not self.mission.strip() and not self.goals and self.tree is None:
            raise ValueError("a mission file needs a mission in words, goals, or the path of a tree.")
        if self.goals and self.tree is not None:
            raise ValueError("a mission file has either goals or the path of a tree.")
        object.__setattr__(self, "min_quality", checked_quality(self.min_quality))
        check_goals(self.goals)
        check_prices(self.costs)
        require_unique("entity", tuple(entity.id for entity in self.entities))
