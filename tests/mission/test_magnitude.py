"""Numbers with which utilities could not be told apart are refused, whichever of them is the large one."""

from __future__ import annotations

import pytest

from missiontree.mission.estimate import Weights
from missiontree.mission.fleet import Capability, CostModel, DurationModel, Fleet, RobotType
from missiontree.mission.magnitude import refuse_huge
from missiontree.routines.library import built_in


def refuse(capability: Capability, weights: Weights) -> None:
    refuse_huge(Fleet((RobotType(id="walker", count=1, capabilities={"search": capability}),)), built_in(), weights)


@pytest.mark.parametrize(
    ("capability", "weights"),
    [
        (Capability(quality=1e300), Weights()),
        (Capability(quality=1e308), Weights(alpha=1e308)),  # the product is infinite
        (Capability(quality=1.0), Weights(alpha=1.1e9)),
        (Capability(quality=1.0, duration=DurationModel(plus_s=1e10)), Weights(beta=1.0)),
        (Capability(quality=1.0, duration=DurationModel(scale=1e8)), Weights(beta=1.0)),  # times 60 s and more
        (Capability(quality=1.0, cost=CostModel(fixed=1e10)), Weights(gamma=1.0)),
        (Capability(quality=1.0, cost=CostModel(per_s=1e308)), Weights(gamma=0.0)),  # 0 times infinity is no number
    ],
)
def test_what_is_too_large_is_named(capability: Capability, weights: Weights) -> None:
    with pytest.raises(ValueError, match="'search' of robot type 'walker' counts for more than 1,000,000,000"):
        refuse(capability, weights)


@pytest.mark.parametrize(
    ("capability", "weights"),
    [
        (Capability(quality=1e8), Weights()),
        (Capability(quality=1.0), Weights(alpha=9e8)),
        (Capability(quality=1.0, duration=DurationModel(plus_s=1e12)), Weights()),  # seconds do not count
    ],
)
def test_what_is_large_is_taken(capability: Capability, weights: Weights) -> None:
    refuse(capability, weights)
