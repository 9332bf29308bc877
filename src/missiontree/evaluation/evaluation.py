"""
Put models to a suite: every mission by every model, as often as asked, side by side, going on where it was left.

Runs come back in one order, model by model, mission by mission, whichever was done first.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from threading import Event

from missiontree.authoring.methods.method import built_in_methods
from missiontree.evaluation.contestant import Contestant
from missiontree.evaluation.examiner import Examiner, Task
from missiontree.evaluation.run import Key, Run
from missiontree.evaluation.side_by_side import side_by_side
from missiontree.evaluation.suite import Setting
from missiontree.evaluation.suite_file import SuiteMission

MISCONFIGURED = frozenset({"provider_unauthorised", "provider_not_installed", "provider_no_such_model"})
"""Faults that every further run would meet as well."""
NOT_THE_MODELS = MISCONFIGURED | {
    f"provider_{kind}" for kind in ("unreachable", "timed_out", "rate_limited", "overloaded")
}
"""Faults that say nothing about the model; such a run is made again when an evaluation goes on."""
PATIENCE = 3


@dataclass(frozen=True, slots=True, kw_only=True)
class Evaluation:
    """
    What models came to.

    Parameters
    ----------
    suite
        Name of the suite.
    missions
        The missions they were put to, with their settings.
    models
        Names of the models.
    asked
        Runs asked for of each mission by each model.
    runs
        Runs that are done: by model, mission and number, each in order.
    stopped
        Models that were given up, with the reason.
    interrupted
        Whether it was ended before all was done.
    """

    suite: str
    missions: tuple[tuple[Setting, SuiteMission], ...]
    models: tuple[str, ...]
    asked: int
    runs: tuple[Run, ...]
    stopped: Mapping[str, str] = field(default_factory=dict)
    interrupted: bool = False

    @property
    def size(self) -> int:
        """Runs asked for in all."""
        return len(self.missions) * len(self.models) * self.asked

    def of(self, model: str, mission: str | None = None) -> tuple[Run, ...]:
        """The runs by a model, of one mission if that is given."""
        return tuple(run for run in self.runs if run.model == model and mission in {None, run.mission})


@dataclass(frozen=True, slots=True, kw_only=True)
class Course:
    """
    How models are put to a suite.

    Parameters
    ----------
    runs
        Runs of each mission by each model. Default 1.
    jobs
        Most runs at a time. Default 1.
    known
        Runs that are done already; those of the same model, mission, number and digest are not made again, unless a fault that says
        nothing about the model ended them.
    keep
        Given each run as it is done.
    report
        Told how many runs are done, of how many, and which was the last; None at first.
    examiner
        Makes the runs.

    Raises
    ------
    ValueError
        If ``runs`` or ``jobs`` is below 1.
    """

    runs: int = 1
    jobs: int = 1
    known: Mapping[Key, Run] = field(default_factory=dict)
    keep: Callable[[Run], None] = lambda run: None
    report: Callable[[int, int, Run | None], None] = lambda done, size, run: None
    examiner: Examiner = field(default_factory=Examiner)

    def __post_init__(self) -> None:
        if min(self.runs, self.jobs) < 1:
            raise ValueError(f"runs and jobs must be at least 1, got {self.runs} and {self.jobs}.")


def evaluate(
    name: str,
    missions: Sequence[tuple[Setting, SuiteMission]],
    contestants: Sequence[Contestant],
    course: Course = Course(),
) -> Evaluation:
    """
    Put models to missions.

    A model that fails with the same fault of its set-up three times in a row is given up. An interruption (Ctrl-C) ends it with
    what is done; runs under way are lost.

    Parameters
    ----------
    name
        What the suite is called.
    missions
        Missions of the suite, those that are wanted.
    contestants
        The models; their names differ.
    course
        How often, how many at a time, and what is done already.

    Raises
    ------
    InputError
        If there is no such model.
    """
    tasks = _tasks(missions, contestants, course)
    done = {task.key: run for task in tasks if (run := course.known.get(task.key)) and run.fault not in NOT_THE_MODELS}
    doubts, halt, interrupted = _Doubts(), Event(), False
    examiner = replace(course.examiner, stop=lambda: halt.is_set() or course.examiner.stop())
    course.report(len(done), len(tasks), None)
    built_in_methods()  # once, before threads ask for it side by side: the offline author tells its own methods by identity
    try:
        left = [task for task in tasks if task.key not in done]
        wanted = (task for task in left if task.contestant.name not in doubts.stopped)
        for task, run in side_by_side(wanted, examiner, course.jobs):
            course.keep(run)
            done[task.key] = run
            doubts.hear(run)
            course.report(len(done), len(tasks), run)
    except KeyboardInterrupt:
        interrupted = True
    finally:
        halt.set()
    model_place = {contestant.name: place for place, contestant in enumerate(contestants)}
    mission_place = {mission.id: place for place, (_, mission) in enumerate(missions)}
    return Evaluation(
        suite=name,
        missions=tuple(missions),
        models=tuple(contestant.name for contestant in contestants),
        asked=course.runs,
        runs=tuple(
            sorted(done.values(), key=lambda run: (model_place[run.model], mission_place[run.mission], run.number))
        ),
        stopped=doubts.stopped,
        interrupted=interrupted,
    )


def _tasks(
    missions: Sequence[tuple[Setting, SuiteMission]], contestants: Sequence[Contestant], course: Course
) -> list[Task]:
    """All runs, in the order in which they are made: each model goes through the missions once before it does so again."""
    put = [
        (mission, setting.brief(mission), setting.digest(mission, course.examiner.whole))
        for setting, mission in missions
    ]
    return [
        Task(contestant, *each, number)
        for contestant in contestants
        for number in range(1, course.runs + 1)
        for each in put
    ]


class _Doubts:
    """Whether a model's runs go on failing for the same reason, which no further run would change."""

    def __init__(self) -> None:
        self.stopped: dict[str, str] = {}
        self._last: dict[str, tuple[str, int]] = {}

    def hear(self, run: Run) -> None:
        fault, count = self._last.get(run.model, ("", 0))
        count = count + 1 if run.fault == fault else 1
        self._last[run.model] = run.fault, count
        if run.fault in MISCONFIGURED and count == PATIENCE:
            self.stopped[run.model] = run.reasons[0] if run.reasons else run.fault
