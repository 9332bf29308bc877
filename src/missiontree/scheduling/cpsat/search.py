"""
Lets the solver search, in a thread of this process or in a process of its own, and hears what it finds while it does.

Small models are solved here. Large ones, whose presolve may not heed a time limit, are solved in a process that can be killed; so is
everything once ``highspy`` has been loaded here, beside which the solver cannot be.
"""

from __future__ import annotations

import contextlib
import json
import math
import queue
import subprocess
import sys
import threading
import time
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Literal, Protocol

from missiontree.mission.aside import Aside
from missiontree.mission.control import Clock
from missiontree.scheduling.cpsat import worker
from missiontree.scheduling.cpsat.model import Model
from missiontree.scheduling.cpsat.text import text_of
from missiontree.scheduling.cpsat.worker import Message, Work
from missiontree.scheduling.sound_solver import SOUND

Verdict = Literal["optimal", "feasible", "infeasible", "unknown"]
WORKERS = 8  # even on few cores: with fewer, the searches that raise the bound hardly run
SMALL = 20_000
"""Size of a model up to which it is solved in this process."""
_LOOK_S = 0.02
_GRACE_S = 0.06
_VERDICTS: dict[str, Verdict] = {"OPTIMAL": "optimal", "FEASIBLE": "feasible", "INFEASIBLE": "infeasible"}


@dataclass(slots=True)
class Found:
    """
    What a search came to.

    Parameters
    ----------
    verdict
        The solver's word.
    values
        Its best answer, one value per variable; empty if there is none.
    bound
        No objective below it, by the solver's word; None if it says nothing.
    objective
        Of the best answer; None if there is none.
    """

    verdict: Verdict = "unknown"
    values: list[int] = field(default_factory=list)
    bound: int | None = None
    objective: int | None = None


@dataclass(frozen=True, slots=True)
class Effort:
    """
    How a model is searched.

    Parameters
    ----------
    seed
        Seed of the search. Default 0.
    deterministic
        The same answer every time, unless time cuts it short: the searches take turns. Default false.
    alone
        In a process of its own, whatever the size. Default false.
    plain
        Without presolve. Default false.
    """

    seed: int = 0
    deterministic: bool = False
    alone: bool = False
    plain: bool = False

    def parameters(self, limit_s: float) -> dict[str, Any]:
        """As the solver takes them."""
        found: dict[str, Any] = {
            "num_workers": WORKERS,
            "random_seed": self.seed % (1 << 31),
            "max_time_in_seconds": max(0.001, limit_s),
            "catch_sigint_signal": False,
            **SOUND,
        }
        if self.deterministic:
            found["interleave_search"] = True
        if self.plain:
            found["cp_model_presolve"] = False
        return found


class _Hands(Protocol):
    def stop(self) -> None:
        """Ask for the end."""

    def kill(self) -> None:
        """End it now, or leave it behind."""


def search(
    model: Model,
    limit_s: float,
    ended: Callable[[], bool],
    effort: Effort = Effort(),
    heard: Callable[[Found], None] | None = None,
    clock: Clock = time.monotonic,
) -> Found:
    """
    Search for the least objective of a model.

    Parameters
    ----------
    model
        With its hint.
    limit_s
        Seconds that it may take.
    ended
        Asked every few milliseconds whether to stop.
    effort
        How.
    heard
        Told of every better answer and bound.
    clock
        Monotonic seconds.
    """
    messages: queue.SimpleQueue[Message] = queue.SimpleQueue()
    begun = clock()

    def over() -> bool:
        return clock() - begun >= limit_s or ended()

    alone = effort.alone or model.size > SMALL or "highspy" in sys.modules
    hands: _Hands = (_Alone if alone else _Here)(model, effort.parameters(limit_s), messages.put)
    return _listen(messages, hands, over, clock, heard)


def _listen(
    messages: queue.SimpleQueue[Message],
    hands: _Hands,
    over: Callable[[], bool],
    clock: Clock,
    heard: Callable[[Found], None] | None,
) -> Found:
    found, asked = Found(), None
    try:
        while True:
            try:
                message = messages.get(timeout=_LOOK_S)
            except queue.Empty:
                message = {}
            if message:
                _take(found, message)
                if "status" in message or "failed" in message:
                    return found
                if heard is not None:
                    heard(found)
            if asked is None and over():
                asked = clock()
                hands.stop()
            if asked is not None and clock() - asked > _GRACE_S:
                return found
    finally:
        hands.stop()
        hands.kill()


def _take(found: Found, message: Message) -> None:
    if message.get("values"):
        found.values = message["values"]
        if message.get("objective") is not None:
            found.objective = round(message["objective"])
        found.verdict = "feasible"
    bound = message.get("bound")
    if bound is not None and math.isfinite(bound) and message.get("status", "") not in {"UNKNOWN", "INFEASIBLE"}:
        found.bound = max(found.bound or -(1 << 62), math.ceil(bound - 1e-6))
    if "status" in message:
        found.verdict = _VERDICTS.get(message["status"], "feasible" if found.values else "unknown")
        if message["status"] == "MODEL_INVALID":
            raise ValueError("the solver finds the model invalid.")
    if "failed" in message:
        found.verdict = "feasible" if found.values else "unknown"


class _Here:
    """In a thread of this process; the solver lets others run while it searches."""

    def __init__(self, model: Model, parameters: dict[str, Any], tell: Callable[[Message], None]) -> None:
        self._tell, self._work = tell, Work(text_of(model), parameters, tell)
        self._aside = Aside(self._run)

    def _run(self) -> None:
        try:
            self._work.run()
        except Exception as error:  # whatever breaks in the thread is said in the main one
            self._tell({"failed": str(error)})

    def stop(self) -> None:
        self._work.stop()

    def kill(self) -> None:
        if not self._aside.over(_LOOK_S):  # it is loading the solver, or in a step that does not hear the stop
            self._aside.leave(whole=True)


class _Alone:
    """In a process of its own, deaf to Ctrl-C, and gone when this one is."""

    def __init__(self, model: Model, parameters: dict[str, Any], tell: Callable[[Message], None]) -> None:
        self._tell, self._model, self._parameters = tell, model, parameters
        command = [sys.executable, "-P", str(Path(worker.__file__))]
        self._child = subprocess.Popen(  # noqa: S603 - our own file
            command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, start_new_session=True
        )
        self._stopped = False
        threading.Thread(target=self._write, daemon=True).start()
        self._reader = threading.Thread(target=self._read, daemon=True)
        self._reader.start()

    def _write(self) -> None:
        assert self._child.stdin is not None
        text = text_of(self._model).encode()  # here, beside the thread that watches the clock
        header = json.dumps({"parameters": self._parameters, "length": len(text)}).encode() + b"\n"
        try:
            self._child.stdin.write(header + text)
            self._child.stdin.flush()
        except (OSError, ValueError):
            pass  # it is gone; what it said is heard by the reader

    def _read(self) -> None:
        assert self._child.stdout is not None
        last: Message = {}
        for line in self._child.stdout:
            try:
                last = json.loads(line)
            except ValueError:
                break  # killed within a line
            self._tell(last)
        if "status" not in last:
            self._tell({"failed": "the solver's process ended without a last word."})

    def stop(self) -> None:
        if not self._stopped:
            self._stopped = True
            threading.Thread(target=self._close, daemon=True).start()

    def _close(self) -> None:
        assert self._child.stdin is not None
        try:
            self._child.stdin.write(b"stop\n")
            self._child.stdin.flush()
        except (OSError, ValueError):
            pass  # it is gone

    def kill(self) -> None:
        self._child.kill()
        self._child.wait()
        self._reader.join()
        for pipe in (self._child.stdin, self._child.stdout):
            if pipe is not None:
                with contextlib.suppress(OSError):
                    pipe.close()
