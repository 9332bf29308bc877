"""Looking for circles of garbage, which long work makes hardly any of."""

from __future__ import annotations

import gc
from collections.abc import Iterator
from contextlib import contextmanager

SELDOM = (200_000, 50, 100)


@contextmanager
def seldom_collected() -> Iterator[None]:
    """
    Look for circles of garbage seldom.

    A tree of a million nodes makes none, and looking takes a third of the time. It comes at any moment, too: in a plan of 120 goals it
    took a tenth of a second of those after a signal.
    """
    before = gc.get_threshold()
    gc.set_threshold(*SELDOM)
    try:
        yield
    finally:
        gc.set_threshold(*before)
