"""
Sets of teams, split into smaller ones around a team that is done with.

A team is a set of robot types. A set of teams is given by types that all of them lack and types that all of them have. Around one of
its teams it falls into parts that do not overlap and hold all its other teams: the i-th agrees with that team on the first i - 1 of the
types that are left open, and differs on the i-th (Murty, 1968; Lawler, "A procedure for computing the k best solutions", 1972).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from missiontree.allocation.flat import Flat
from missiontree.allocation.narrowing import kept, with_required

Team = frozenset[str]


@dataclass(frozen=True, slots=True)
class Teams:
    """
    A set of teams.

    Parameters
    ----------
    without
        Types that none of them has.
    within
        Types that all of them have.
    """

    without: Team = frozenset()
    within: Team = frozenset()

    def around(self, team: Team, types: Sequence[str]) -> Iterator[Teams]:
        """The parts without a team; those that lack a type of it come first."""
        without, within = self.without, self.within
        for name in types:
            if name in team and name not in within:
                yield Teams(without | {name}, within)
                within |= {name}
        for name in types:
            if name not in team and name not in without:
                yield Teams(without, within | {name})
                without |= {name}

    def problem(self, flat: Flat) -> Flat:
        """All alternatives with one of these teams."""
        return with_required(kept(flat, lambda leaf: flat.robot_type[leaf] not in self.without), sorted(self.within))
