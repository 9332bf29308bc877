"""The order between routines that a suite writes, and when it means nothing."""

from __future__ import annotations

from collections.abc import Sequence

from missiontree.evaluation.closure import closure
from missiontree.evaluation.notation import Order


def check_order(texts: Sequence[str], relations: Sequence[Order], count: int, what: str = "the plan has") -> None:
    """
    Refuse an order that cannot be kept.

    Parameters
    ----------
    texts, relations
        The relations as they are written, and what they mean.
    count
        How many routines there are to be related.
    what
        Whose routines they are, for the message.

    Raises
    ------
    ValueError
        If a relation names a routine that there is not, stands twice or contradicts the others; quotes it.
    """
    for text, order in zip(texts, relations, strict=True):
        for number in (order.first, order.second):
            if number > count:
                raise ValueError(f"{text!r} names routine {number}; {what} {count}.")
    if len(set(relations)) < len(relations):
        twice = next(text for place, text in enumerate(texts) if relations[place] in relations[:place])
        raise ValueError(f"{twice!r} stands twice.")
    before = closure({(order.first, order.second) for order in relations if order.relation == "<"})
    for text, order in zip(texts, relations, strict=True):
        if order.relation == "<" and (order.second, order.first) in before:
            raise ValueError(
                f"{text!r} contradicts the rest of the order, which puts {order.second} before {order.first}."
            )
