"""What the best alternatives are: how the utilities of actions make that of an alternative, and whether teams are to differ."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

Accumulate = Literal["sum", "mean", "min"]

_WORTH: dict[Accumulate, str] = {"sum": "utility", "mean": "mean utility", "min": "least utility"}


@dataclass(frozen=True, slots=True, kw_only=True)
class Aim:
    """
    What a ranking is after.

    Parameters
    ----------
    accumulate
        The utility of an alternative is the ``sum``, the ``mean`` or the least (``min``) of the utilities of its actions. A sum favours
        alternatives with more actions, a mean does not, and a minimum looks at the weakest action alone. Of an alternative without
        actions each of them is 0. Default ``sum``.
    diverse
        Whether the teams of any two listed alternatives differ. The team of an alternative is the set of robot types that take part.
        Default false.
    """

    accumulate: Accumulate = "sum"
    diverse: bool = False

    @property
    def worth(self) -> str:
        """What the utility of an alternative is called: "utility", "mean utility", "least utility"."""
        return _WORTH[self.accumulate]

    @property
    def in_words(self) -> str:
        """The aim as a phrase, such as "mean utility, different teams"; "utility" is the plain one."""
        return f"{self.worth}, different teams" if self.diverse else self.worth


PLAIN_AIM = Aim()
