"""What changes of a mission cost its user, so that repairs can be put in an order."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from difflib import get_close_matches

from missiontree.mission.change import CHANGE_KINDS, Change, ChangeKind
from missiontree.mission.frozen_map import FrozenMap
from missiontree.mission.value import Id, NonNegative, Value

DEFAULTS: Mapping[ChangeKind, tuple[float, float]] = FrozenMap(
    {
        "take_off_without": (1, 0),
        "take_off_require": (1, 0),
        "end_anywhere": (1, 0),
        "allow_type": (1, 0),
        "lower_min_quality": (1, 2),
        "extend_deadline": (1, 2),
        "move_release": (1, 2),
        "open_way": (2, 0),
        "clear_cells": (2, 0),
        "allow_zone": (2, 0),
        "drop_link": (2, 0),
        "extend_stay": (2, 2),
        "come_earlier": (2, 2),
        "raise_in_use": (2, 2),
        "lift_keep_out": (3, 0),
        "raise_capacity": (3, 2),
        "raise_total": (3, 2),
        "raise_stock": (3, 2),
        "lower_limit": (4, 2),
        "raise_limit": (4, 2),
        "raise_quality": (6, 2),
        "add_capability": (8, 0),
        "add_robot": (10, 0),
        "ignore_kinds": (12, 0),
        "drop_part": (12, 0),
    }
)
"""Fixed cost of each kind of change, and what it costs beside per share by which a number grows or shrinks (1 = 100 %)."""
MOST_SHARE = 100.0


@dataclass(frozen=True, slots=True, kw_only=True)
class Price(Value):
    """
    What one kind of change costs, in any unit; the same for all kinds.

    Parameters
    ----------
    fixed
        Whatever its size, at least 0. None (default) leaves the default of the kind.
    per_share
        Beside that, times the share by which a number grows or shrinks: 1 for twice as much. At least 0, default as of the kind.
    of
        Instead of ``fixed``, by what is changed or added: a robot type, a capability, a limit, a node of the tree.
    """

    fixed: NonNegative | None = None
    per_share: NonNegative | None = None
    of: Mapping[Id, NonNegative] = field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class Costs(Value):
    """
    What changes cost.

    Parameters
    ----------
    prices
        By kind of change, a fixed cost or a whole :class:`Price`; kinds that are not named have their defaults.

    Raises
    ------
    ValueError
        If a kind is named that there is not.
    """

    prices: Mapping[Id, Price | NonNegative] = field(default_factory=dict)

    def _check(self) -> None:
        check_prices(self.prices)
        object.__setattr__(self, "prices", FrozenMap({kind: price_of(given) for kind, given in self.prices.items()}))

    def of(self, change: Change, times: int = 1) -> float:
        """
        What a change costs, in steps of 1e-6.

        Parameters
        ----------
        change
            The change.
        times
            How many routines it concerns: a part of the mission costs by the routines that are left out. Default 1.
        """
        fixed, per_share = DEFAULTS[change.kind]
        price = self.prices.get(change.kind)
        if isinstance(price, Price):
            fixed = fixed if price.fixed is None else price.fixed
            per_share = per_share if price.per_share is None else price.per_share
            fixed = price.of.get(change.target, price.of.get(change.name, fixed))
        return round(fixed * times + per_share * _share(change), 6)


def price_of(given: Price | float) -> Price:
    """A price, also of its short form, which is the fixed cost alone: then the size of a change costs nothing."""
    return given if isinstance(given, Price) else Price(fixed=given, per_share=0.0)


def check_prices(prices: Mapping[str, object]) -> None:
    """
    Refuse prices of what is no kind of change.

    Raises
    ------
    ValueError
        Naming those there are.
    """
    for kind in prices:
        if kind not in CHANGE_KINDS:
            near = get_close_matches(kind, CHANGE_KINDS, n=1)
            nearest = f" the nearest is {near[0]!r};" if near else ""
            raise ValueError(f"costs name {kind!r};{nearest} changes are {', '.join(CHANGE_KINDS)}.")


def _share(change: Change) -> float:
    """By how much a number grows or shrinks, as a share of what it was; what was nothing counts as doubled."""
    if change.was is None or change.to is None or change.was == change.to:
        return 0.0
    return 1.0 if change.was == 0 else min(MOST_SHARE, abs(change.to - change.was) / change.was)


DEFAULT_COSTS = Costs()
