"""What an estimator was asked and what it said, written down, and read out again in its place."""

from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple

from missiontree.errors import InputError
from missiontree.estimation.estimator import Estimator
from missiontree.mission.estimate import Estimate
from missiontree.mission.estimator_source import Estimated
from missiontree.mission.fleet import Capability


class Question(NamedTuple):
    """What tells one question from another. What the type declares is not in it: type and rating determine that."""

    robot_type: str
    action: str
    rating: str
    at: str
    nominal_s: float | None
    nominal_cost: float
    travel_m: float
    travel_s: float


class WritingDown:
    """
    An estimator that asks another one each question once, and keeps the answers.

    Parameters
    ----------
    estimator
        Who is asked.
    """

    def __init__(self, estimator: Estimator) -> None:
        self._estimator = estimator
        self._answers: dict[Question, Estimate] = {}

    def estimate(
        self,
        capability: Capability,
        nominal_s: float | None,
        nominal_cost: float = 0.0,
        travel_m: float = 0.0,
        travel_s: float = 0.0,
        *,
        robot_type: str = "",
        action: str = "",
        rating: str = "",
        at: str = "",
    ) -> Estimate:
        """Pass the question on if it is new; see :meth:`missiontree.estimation.estimator.Estimator.estimate`."""
        question = Question(robot_type, action, rating, at, nominal_s, nominal_cost, travel_m, travel_s)
        if question not in self._answers:
            self._answers[question] = self._estimator.estimate(
                capability,
                nominal_s,
                nominal_cost,
                travel_m,
                travel_s,
                robot_type=robot_type,
                action=action,
                rating=rating,
                at=at,
            )
        return self._answers[question]

    @property
    def answers(self) -> tuple[Estimated, ...]:
        """All answers, in the order of the questions."""
        return tuple(
            Estimated(**question._asdict() | {"at": question.at or None}, estimate=estimate)
            for question, estimate in self._answers.items()
        )


class ReadingOut:
    """
    An estimator that says again what another one said.

    Parameters
    ----------
    answers
        All answers that there are; of several to one question the last counts.
    """

    def __init__(self, answers: Iterable[Estimated]) -> None:
        self._answers = {
            Question(
                said.robot_type,
                said.action,
                said.rating,
                said.at or "",
                said.nominal_s,
                said.nominal_cost,
                said.travel_m,
                said.travel_s,
            ): said.estimate
            for said in answers
        }

    def estimate(
        self,
        capability: Capability,
        nominal_s: float | None,
        nominal_cost: float = 0.0,
        travel_m: float = 0.0,
        travel_s: float = 0.0,
        *,
        robot_type: str = "",
        action: str = "",
        rating: str = "",
        at: str = "",
    ) -> Estimate:
        """
        Look the answer up; see :meth:`missiontree.estimation.estimator.Estimator.estimate`.

        Raises
        ------
        InputError
            If the question was never asked.
        """
        del capability  # type and rating determine it
        question = Question(robot_type, action, rating, at, nominal_s, nominal_cost, travel_m, travel_s)
        if question not in self._answers:
            where = f" at {at!r}" if at else ""
            raise InputError(f"there is no estimate of action {action!r} by robot type {robot_type!r}{where}")
        return self._answers[question]
