"""Looking for circles of garbage, which long work makes hardly any of."""

from __future__ import annotations

import gc

SELDOM = (200_000, 50, 100)


def collect_seldom() -> None:
    """
    Look for circles of garbage seldom, in this process and from now on.

    A tree of a million nodes makes none, and looking takes a third of the time. It comes at any moment, too: in a plan of 120 goals it
    took a tenth of a second of those after a signal.
    """
    gc.set_threshold(*SELDOM)
