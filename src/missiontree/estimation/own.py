'''
A user's own estimator: a Python object, or a Python file, which is run.

A file names its estimator by an object ``estimator`` with a method ``estimate``, or by a function ``estimate``. Either takes what
:meth:`missiontree.estimation.estimator.Estimator.estimate` takes and returns an :class:`Estimate`::

    from missiontree.estimation.table import TableEstimator
    from missiontree.mission.estimate import Estimate

    def estimate(*question, robot_type, action, **where):
        """As the fleet says, but wheels do half as well in the sand."""
        usual = TableEstimator().estimate(*question)
        sandy = robot_type == "rover" and where["at"] == "beach"
        return Estimate(usual.quality * (0.5 if sandy else 1), usual.duration_s, usual.cost)
'''

from __future__ import annotations

import hashlib
import traceback
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from missiontree.errors import InputError
from missiontree.estimation.table import TableEstimator
from missiontree.formats.python_file import run_file
from missiontree.mission.estimate import Estimate
from missiontree.mission.estimator_source import EstimatorSource
from missiontree.mission.fleet import Capability
from missiontree.mission.magnitude import MOST

DEFINES = "an object 'estimator' with a method estimate(), or a function estimate()"
ASKED = (
    "It is called as estimate(capability, nominal_s, nominal_cost, travel_m, travel_s, robot_type=…, action=…, rating=…, at=…) "
    "and returns an Estimate(quality, duration_s, cost)."
)


@dataclass(frozen=True, slots=True)
class OwnEstimator:
    """
    A user's own estimator, whose answers are looked at before anything relies on them.

    Parameters
    ----------
    ask
        The user's code.
    source
        What plans call it.
    file
        Its file, as the user named it; empty for a Python object.
    """

    ask: Callable[..., object]
    source: EstimatorSource
    file: str = ""

    def estimate(
        self,
        capability: Capability,
        nominal_s: float | None,
        nominal_cost: float = 0.0,
        travel_m: float = 0.0,
        travel_s: float = 0.0,
        *,
        robot_type: str = "",
        action: str = "",
        rating: str = "",
        at: str = "",
    ) -> Estimate:
        """
        Ask the user's code; see :meth:`missiontree.estimation.estimator.Estimator.estimate`.

        Raises
        ------
        InputError
            If the user's code fails, or does not answer with an estimate whose numbers can be worked with.
        """
        who: dict[str, str] = {"robot_type": robot_type, "action": action, "rating": rating, "at": at}
        about = f"action {action!r} by robot type {robot_type!r}{f' at {at!r}' if at else ''}"
        try:
            said = self.ask(capability, nominal_s, nominal_cost, travel_m, travel_s, **who)
        except (Exception, SystemExit) as error:  # the user's own code may fail, or end the program, in any way
            raise self._failed(error, about) from error
        if not isinstance(said, Estimate):
            raise InputError(
                f"the estimator answers {about} with {_a(said)}",
                file=self.file or self.source.name,
                accepted="an Estimate(quality, duration_s, cost)",
                hint="from missiontree.mission.estimate import Estimate",
            )
        # What is plain, whatever kind of number was given: -0.0, whole numbers and those of other libraries among them.
        plain = Estimate(float(said.quality) + 0.0, float(said.duration_s) + 0.0, float(said.cost) + 0.0)
        if max(plain.quality, plain.duration_s, plain.cost) > MOST:
            raise InputError(
                f"the estimator answers {about} with {plain.quality:g}, {plain.duration_s:g} s and {plain.cost:g}",
                file=self.file or self.source.name,
                accepted=f"numbers of at most {MOST:,.0f}",
            )
        return plain

    def _failed(self, error: BaseException, about: str) -> InputError:
        """The refusal of code that failed: with the line in the user's own file that the error came by last."""
        frames = traceback.extract_tb(error.__traceback__)[1:]  # the first is ours
        own = [frame for frame in frames if frame.filename == frames[0].filename]
        known = own and self.file and Path(own[0].filename) == Path(self.file).absolute()
        return InputError(
            f"the estimator fails for {about}: {type(error).__name__}: {error}",
            file=own[0].filename if own and not known else self.file or self.source.name,
            line=(own[-1].lineno or 0) if own else 0,
            hint="" if own else ASKED,
        )


def own_estimator(given: Any) -> OwnEstimator | None:
    """
    The estimator that somebody hands in, ready to be asked; None if it is the fleet's table, which is the default.

    Parameters
    ----------
    given
        Anything with a method ``estimate``, a function, or the path of a Python file, which is run.

    Raises
    ------
    InputError
        If it is none, or its file cannot be run or does not name one.
    """
    if type(given) is TableEstimator:
        return None
    if isinstance(given, str | Path):
        return _of_file(Path(given))
    ask = _asked(given)
    if ask is None:
        raise InputError(
            f"estimator is {_a(given)}",
            accepted="an object with a method estimate(), a function, or the path of a Python file",
            hint=_make_one(given),
        )
    name = getattr(given, "__qualname__", None) or type(given).__qualname__
    return OwnEstimator(ask, EstimatorSource(name=str(name)))


def _of_file(path: Path) -> OwnEstimator:
    if path.suffix != ".py":
        raise InputError("this is no estimator", file=str(path), accepted="a Python file, whose name ends in .py")
    module = run_file(path, "estimator")
    named = {name: getattr(module, name) for name in ("estimator", "estimate") if hasattr(module, name)}
    if len(named) > 1:
        raise InputError(
            "the file names both 'estimator' and 'estimate'", file=str(path), accepted=f"one of them: {DEFINES}"
        )
    if not named:
        raise InputError("the file names no estimator", file=str(path), accepted=DEFINES, hint=ASKED)
    ((name, found),) = named.items()
    ask = _asked(found)
    if ask is None or (name == "estimate" and not callable(found)):
        raise InputError(f"it is {_a(found)}", file=str(path), where=name, accepted=DEFINES, hint=_make_one(found))
    shown = "".join(character if character.isprintable() else "?" for character in path.name)
    digest = hashlib.sha256(path.read_bytes()).hexdigest()
    return OwnEstimator(ask, EstimatorSource(name=shown, digest=digest), str(path))


def _asked(given: Any) -> Callable[..., object] | None:
    """What is called; None if nothing can be."""
    if isinstance(given, type):
        return None
    method = getattr(given, "estimate", None)
    if callable(method):
        return method  # type: ignore[no-any-return]  # anything that can be called will do
    return given if callable(given) else None


def _a(given: object) -> str:
    return f"the class {given.__qualname__}" if isinstance(given, type) else f"a {type(given).__name__}"


def _make_one(given: object) -> str:
    return f"Make an object of it: {given.__qualname__}()." if isinstance(given, type) else ""
