"""Costs as a command line gives them."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import replace

from missiontree.errors import InputError
from missiontree.mission.costs import Costs, Price


def priced(texts: Iterable[str], costs: Costs) -> Costs:
    """
    Costs with those of the command line put in: ``add_robot=4`` for a kind, ``add_robot.rover=1`` for one thing of that kind.

    Raises
    ------
    InputError
        If a text is none of the two, or a number is negative or none.
    """
    prices = {kind: price for kind, price in costs.prices.items() if isinstance(price, Price)}
    for text in texts:
        key, equals, number = (piece.strip() for piece in text.partition("="))
        kind, _, target = key.partition(".")
        amount = _number(number)
        if not (kind and equals) or amount is None:
            raise InputError(f"--cost {text!r}", accepted="a kind of change and a number, as in add_robot=4")
        price = prices.get(kind, Price())
        fixed = replace(price, fixed=amount, per_share=0.0)
        prices[kind] = replace(price, of={**price.of, target: amount}) if target else fixed
    try:
        return Costs(prices)
    except ValueError as error:
        raise InputError(f"--cost: {error}", accepted="kinds of change, as in add_robot=4") from error


def _number(text: str) -> float | None:
    try:
        number = float(text)
    except ValueError:
        return None
    return number if math.isfinite(number) and number >= 0 else None
