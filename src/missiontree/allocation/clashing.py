"""
Which limits clash, where a mission cannot be done: few that cannot be kept together, and none of which is idle.

A deletion filter (Chinneck and Dravnieks, "Locating minimal infeasible constraint sets in linear programs", ORSA Journal on Computing 3,
1991): limits are dropped, halves before single ones, as long as the mission stays impossible. What remains is an irreducible
infeasible subset: it cannot be kept, and it could be without any one of its limits. Each question is an exact search. A question
that cannot be decided leaves its limits in, and then nobody says that the subset is irreducible.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from missiontree.allocation.any_alternative import any_alternative
from missiontree.allocation.flat import Flat
from missiontree.allocation.limits import Limit, limits_of, without_limits
from missiontree.allocation.possible import possible_nodes, structurally_possible
from missiontree.mission.control import Control

MOST_NODES = 20_000  # of a tree whose clashes are sought
MOST_WORK = 400_000  # nodes times questions
SHARE = 0.2  # of the time that is left, for one question


@dataclass(frozen=True, slots=True)
class Clash:
    """
    Limits that cannot be kept together.

    Parameters
    ----------
    limits
        The limits, in the order of :func:`missiontree.allocation.limits.limits_of`.
    irreducible
        Whether it is proven that all of them are needed for the clash.
    enough
        Those of them each of which, dropped alone, leaves a mission that can be done; None if that was not decided of all.
    """

    limits: tuple[Limit, ...]
    irreducible: bool
    enough: tuple[Limit, ...] | None


def too_large(flat: Flat) -> bool:
    """Whether a tree has too many nodes for its clashes to be sought."""
    return len(flat.kind) > MOST_NODES


def clash_of(flat: Flat, control: Control) -> Clash | None:
    """
    Find limits that clash.

    Parameters
    ----------
    flat
        A problem without an alternative.
    control
        How long it may take.

    Returns
    -------
    Clash or None
        None if no limit is to blame, or if nothing was found out.
    """
    limits = limits_of(flat)
    if not limits or not structurally_possible(flat)[0]:
        return None
    return _Filter(flat, limits, control).clash()


class _Filter:
    """The questions asked about one problem, within what they may cost."""

    def __init__(self, flat: Flat, limits: tuple[Limit, ...], control: Control) -> None:
        self.flat, self.limits, self.control = flat, limits, control
        self.left = MOST_WORK // len(flat.kind)

    def clash(self) -> Clash | None:
        if self._possible(self.limits) is not True:
            return None
        alone = self._one_alone()
        kept, irreducible = ([alone], True) if alone is not None else self._filtered()
        answers = [self._possible([limit]) for limit in kept]
        enough = tuple(limit for limit, answer in zip(kept, answers, strict=True) if answer)
        return Clash(tuple(kept), irreducible, None if None in answers else enough)

    def _possible(self, dropped: Iterable[Limit]) -> bool | None:
        """Whether there is an alternative without some limits; None as well where nothing more may be asked."""
        self.left -= 1
        if self.left < 0 or self.control.ended():
            return None
        return any_alternative(without_limits(self.flat, tuple(dropped)), self.control.part(SHARE))

    def _one_alone(self) -> Limit | None:
        """A limit that one sweep shows to be too tight by itself, which says more than any subset."""
        for limit in self.limits:
            self.left -= 1
            if self.left < len(self.limits) or self.control.ended():
                return None
            if not possible_nodes(only(self.flat, limit)).possible[0]:
                return limit
        return None

    def _filtered(self) -> tuple[list[Limit], bool]:
        """
        Drop what can be dropped.

        A limit that had to stay when more limits were there than now has to stay now: so one question for each is enough.
        """
        dropped: set[Limit] = set()
        kept: list[Limit] = []
        irreducible = True
        waiting = [self.limits]
        while waiting:
            chunk = waiting.pop()
            answer = self._possible((*dropped, *chunk)) if chunk != self.limits else True
            if answer is False:
                dropped.update(chunk)
            elif len(chunk) == 1:
                kept.extend(chunk)
                irreducible = irreducible and answer is True
            else:
                waiting += [chunk[len(chunk) // 2 :], chunk[: len(chunk) // 2]]
        return kept, irreducible


def only(flat: Flat, *limits: Limit) -> Flat:
    """The same problem with no limits but these."""
    return without_limits(flat, [limit for limit in limits_of(flat) if limit not in limits])
