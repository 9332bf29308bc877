"""Which missions are set aside: a third of each setting, drawn by a seed, that nobody looks at while an author is worked on."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from random import Random

SHARE = 3


def set_aside(ids: Mapping[str, Sequence[str]], seed: int) -> frozenset[str]:
    """
    Draw a third of the missions of each setting.

    Each setting has a draw of its own, so that a setting that is added or changed leaves the others' draws as they were.

    Parameters
    ----------
    ids
        Mission ids by setting, in any order.
    seed
        Same seed and same ids, same draw.
    """
    drawn: set[str] = set()
    for setting, missions in ids.items():
        drawn.update(Random(f"{seed} {setting}").sample(sorted(missions), round(len(missions) / SHARE)))  # noqa: S311
    return frozenset(drawn)
