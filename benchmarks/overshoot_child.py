"""
``missiontree`` as it is, telling on a pipe when its clock started, what it found on the way, and when it was done with searching.

::

    python -m benchmarks.overshoot_child FD COMMAND …

Lines on the pipe: ``begun T``; ``best PIECE VALUE`` or ``found PIECE COUNT`` for what was reported of a piece of work (``whole``, or
``schedule-N``), ``piece PIECE VALUE`` for what came of a schedule; ``done T`` when everything is searched and checked and only printing is
left. T is the monotonic clock, which all processes share.
"""

from __future__ import annotations

import os
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import replace
from importlib import import_module
from itertools import count
from typing import Any

import missiontree.cli.interrupt
from missiontree.mission.control import Control, Progress


class Telling:
    """
    What is put in place of parts of ``missiontree``.

    Parameters
    ----------
    descriptor
        Of the pipe.
    """

    def __init__(self, descriptor: int) -> None:
        self._pipe = os.fdopen(descriptor, "w", buffering=1)
        self._pieces = count(1)

    def tell(self, line: str) -> None:
        """Write a line on the pipe."""
        self._pipe.write(line + "\n")

    def heard(self, control: Control, piece: str) -> Control:
        """The same control, its news of one piece of work told."""

        def report(progress: Progress) -> None:
            control.report(progress)
            if progress.best is not None:
                self.tell(f"best {piece} {progress.best}")
            elif progress.found:
                self.tell(f"found {piece} {progress.found}")

        listening = replace(control, report=report)
        object.__setattr__(listening, "started", control.started)
        return listening

    def controlled(self, controlled: Callable[..., Any]) -> Callable[..., Any]:
        """Limits of one run whose start is told."""

        @contextmanager
        def told(*given: Any, **named: Any) -> Iterator[Control]:
            with controlled(*given, **named) as control:
                self.tell(f"begun {control.started}")
                yield self.heard(control, "whole")

        return told

    def scheduling(self, schedule: Callable[..., Any]) -> Callable[..., Any]:
        """A scheduler whose answer is told."""

        def told(tree: Any, alternative: Any, fleet: Any, scene: Any, control: Control, *more: Any) -> Any:
            piece = f"schedule-{next(self._pieces)}"
            found = schedule(tree, alternative, fleet, scene, self.heard(control, piece), *more)
            value = found.makespan_s if found.status in {"optimal", "feasible"} else None
            self.tell(f"piece {piece} {value}")
            return found

        return told

    def printing(self, function: Callable[..., Any]) -> Callable[..., Any]:
        """What prints, and so begins when searching and checking are over."""

        def told(*given: Any, **named: Any) -> Any:
            self.tell(f"done {time.monotonic()}")
            return function(*given, **named)

        return told


def main() -> None:
    """Put all that tells in its place, then be ``missiontree``."""
    telling = Telling(int(sys.argv[1]))
    sys.argv = ["missiontree", *sys.argv[2:]]
    missiontree.cli.interrupt.controlled = telling.controlled(
        missiontree.cli.interrupt.controlled
    )  # first, for others take it from there
    door = import_module("missiontree.cli.main")
    for module, name in (("plan", "deliver"), ("rank_view", "json_of"), ("schedule_view", "json_of")):
        names = vars(import_module(f"missiontree.cli.{module}"))
        names[name] = telling.printing(names[name])
    if sys.argv[1] == "plan":
        names = vars(import_module("missiontree.planner"))
        names["SCHEDULERS"] = {name: telling.scheduling(one) for name, one in names["SCHEDULERS"].items()}
    door.main()


if __name__ == "__main__":
    main()
