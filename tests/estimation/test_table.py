"""The table estimator: quality from the table, duration and cost from the type's models."""

import pytest

from missiontree.estimation.estimator import Estimator
from missiontree.estimation.table import TableEstimator, working_s
from missiontree.mission.estimate import Estimate
from missiontree.mission.fleet import Capability, CostModel, DurationModel

SLOW_AND_DEAR = Capability(0.8, DurationModel(scale=1.5, plus_s=4), CostModel(fixed=2, per_s=0.5, per_m=0.1))


def test_the_papers_table_gives_quality_and_nominal_duration() -> None:
    assert TableEstimator().estimate(Capability(0.5), 60, 0) == Estimate(0.5, 60, 0)


def test_working_time_follows_the_duration_model() -> None:
    # 4 + 1.5 * 10 = 19
    assert working_s(SLOW_AND_DEAR, 10) == 19


def test_duration_and_cost_add_up() -> None:
    estimate = TableEstimator().estimate(SLOW_AND_DEAR, 10, 3, travel_m=20, travel_s=11)
    # duration 4 + 1.5 * 10 + 11 = 30; cost 3 + 2 + 0.5 * 30 + 0.1 * 20 = 22
    assert estimate == Estimate(0.8, 30, 22)


def test_a_move_whose_travel_is_known_is_that_travel() -> None:
    estimate = TableEstimator().estimate(SLOW_AND_DEAR, None, 3, travel_m=20, travel_s=10)
    # duration 10, nothing added; cost 3 + 2 + 0.5 * 10 + 0.1 * 20 = 12
    assert estimate == Estimate(0.8, 10, 12)


def test_an_estimator_of_ones_own_fits_the_seam() -> None:
    class Careful:
        """Knows that tele-robots search badly."""

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
            doubt = 0.5 if robot_type == "tele_robot" else 1.0
            return Estimate(doubt * capability.quality, (nominal_s or 0) + travel_s, nominal_cost)

    own: Estimator = Careful()
    table: Estimator = TableEstimator()
    given = own.estimate(Capability(0.8), 5, robot_type="tele_robot")
    assert given.quality == pytest.approx(0.4)
    assert table.estimate(Capability(0.8), 5, robot_type="tele_robot").quality == 0.8
