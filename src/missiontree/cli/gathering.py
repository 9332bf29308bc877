"""From the words on a command line to a request."""

from __future__ import annotations

import math
import os
from pathlib import Path
from typing import TYPE_CHECKING, cast, get_args

from missiontree.errors import InputError

if TYPE_CHECKING:
    from missiontree.authoring.budgets import Budgets
    from missiontree.briefing import Request
    from missiontree.mission.aim import Accumulate
    from missiontree.mission.estimate import Weights
    from missiontree.mission.objective import Objective
    from missiontree.mission.terms import MinQuality


def gather(
    mission: str | None,
    sample: str | None,
    *,
    fleet: Path | None,
    scene: Path | None,
    routines: list[Path] | None,
    methods: list[Path] | None,
    weights: str | None,
    without: list[str] | None = None,
    require: list[str] | None = None,
    min_quality: list[str] | None = None,
    estimator: Path | None = None,
    accumulate: str | None = None,
    diverse: bool | None = None,
    return_home: bool | None = None,
    objective: str | None = None,
    front: bool = False,
    k: int | None,
    allocator: str | None,
    model: str | None,
    kinds: bool | None,
    seed: int | None,
    base_url: str | None = None,
    budgets: Budgets | None = None,
    scheduler: str | None = None,
    parts: list[str] | None = None,
) -> Request:
    """
    Gather a request from the command line, the mission file and the folder one stands in.

    Raises
    ------
    InputError
        If anything given is not what it should be.
    """
    from missiontree.briefing import MISSION_FILES, request_from

    source, project = _mission(mission, sample)
    in_words = isinstance(source, str) and not source.endswith(MISSION_FILES) and project is None
    return request_from(
        source,
        fleet=fleet or (_here("fleet.yaml") if in_words else None),
        scene=scene or (_here("scene.yaml") if in_words else None),
        routines=routines or (),
        methods=methods or (),
        weights=_weights(weights),
        check_kinds=kinds,
        without=without or (),
        require=require or (),
        min_quality=least_quality(min_quality),
        estimator=estimator,
        accumulate=accumulate_named(accumulate),
        diverse=diverse,
        return_home=return_home,
        objective=objective_named(objective),
        project=project,
        k=k,
        allocator=allocator,
        scheduler=scheduler,
        front=front,
        model=model,
        base_url=base_url,
        budgets=budgets,
        seed=seed,
        parts=part_weights(parts),
    )


def accumulate_named(text: str | None) -> Accumulate | None:
    """
    What ``--accumulate`` asks for; None if it is not given.

    Raises
    ------
    InputError
        If it is none of those there are.
    """
    from missiontree.mission.aim import Accumulate

    if text is not None and text not in get_args(Accumulate):
        raise InputError(f"--accumulate {text}", accepted="sum, mean or min")
    return cast("Accumulate | None", text)


def objective_named(text: str | None) -> Objective | None:
    """
    What ``--objective`` asks for; None if it is not given.

    Raises
    ------
    InputError
        If it is none of those there are.
    """
    from missiontree.mission.objective import OBJECTIVES

    if text is not None and text not in OBJECTIVES:
        raise InputError(f"--objective {text}", accepted=", ".join(OBJECTIVES))
    return text


def author_named(model: str | None, replay: Path | None) -> str | None:
    """
    Who is to author the mission, of ``--model`` and ``--replay``.

    The environment may name a model as well; a replay that is asked for goes before it, but not before another author that is.

    Raises
    ------
    InputError
        If both are given.
    """
    if replay is None:
        return model
    if model is not None and model != os.environ.get("MISSIONTREE_MODEL"):
        raise InputError("both --model and --replay are given", accepted="one of them")
    return f"recorded:{replay}"


def budgets_from(turns: int | None, tokens: int | None, seconds: float | None) -> Budgets | None:
    """
    Budgets of a dialogue, as far as they are given.

    Raises
    ------
    InputError
        If one of them is not above 0.
    """
    from missiontree.authoring.budgets import Budgets

    given = {"turns": turns, "tokens": tokens, "seconds": seconds}
    for name, value in given.items():
        if value is not None and not value > 0:
            raise InputError(f"--max-{name} {value:g}", accepted="a number above 0")
    named = {name: value for name, value in given.items() if value is not None}
    return Budgets(**named) if named else None  # type: ignore[arg-type]  # each value is of its field's type


def _mission(mission: str | None, sample: str | None) -> tuple[str | Path, Path | None]:
    """The mission, and the mission file of the folder one stands in if the mission is given in words."""
    here = Path("mission.yaml")
    if sample is not None:
        from missiontree.samples.catalogue import sample_file

        if mission is not None:
            raise InputError("both a mission and --sample are given", accepted="one of them")
        return sample_file(sample), None
    if mission is None:
        if not os.path.lexists(here):  # Path.exists fails in a folder that may not be read
            raise InputError(
                "no mission is given, and this folder has no mission.yaml",
                accepted='a sentence ("Reunite mom with her lost child"), a mission file, or --sample NAME',
                hint="`missiontree init FOLDER` writes a folder to start from.",
            )
        return here, None
    if mission.strip() and os.path.isdir(mission):  # Path.is_dir fails on a sentence of a thousand words
        return _of_folder(Path(mission)), None
    return mission, here if os.path.lexists(here) else None


def _of_folder(folder: Path) -> Path:
    file = folder / "mission.yaml"
    if not os.access(folder, os.X_OK):
        raise InputError("this folder may not be read", file=str(folder), accepted="a folder that you may read")
    if not os.path.lexists(file):
        raise InputError(
            "this is a folder without a mission.yaml",
            file=str(folder),
            accepted="a mission in words, a mission file, or a folder that holds mission.yaml",
        )
    return file


def _here(name: str) -> Path | None:
    """The file of that name in the folder one stands in, if there is one."""
    path = Path(name)
    return path if os.path.isfile(path) else None


def _weights(text: str | None) -> Weights | None:
    if text is None:
        return None
    from missiontree.mission.estimate import Weights

    try:
        numbers = [_number(part) for part in text.split(",")]
        if not 1 <= len(numbers) <= 3:
            raise ValueError(f"{len(numbers)} numbers are given.")
        return Weights(*numbers)
    except ValueError as error:
        raise InputError(
            f"--weights {text!r}: {error}",
            accepted="up to three numbers of at least 0, as in 1,0.01,0 (alpha,beta,gamma)",
        ) from error


def least_quality(texts: list[str] | None) -> MinQuality | None:
    """
    What ``--min-quality`` asks for: one number, or numbers by name; None if it is not given.

    Raises
    ------
    InputError
        If a number is none or negative, a name has two numbers, or a number for all stands beside others.
    """
    parts = [part.strip() for text in texts or () for part in text.split(",")]
    if not parts:
        return None
    try:
        if len(parts) == 1 and "=" not in parts[0]:
            return _quality(parts[0])
        named: dict[str, float] = {}
        for part in parts:
            name, equals, number = (piece.strip() for piece in part.partition("="))
            if not equals or not name:
                raise ValueError(f"{part!r} stands beside others and has no name.")
            if name in named:
                raise ValueError(f"{name!r} stands twice.")
            named[name] = _quality(number)
        return named
    except ValueError as error:
        raise InputError(
            f"--min-quality {', '.join(map(repr, texts or ()))}: {error}",
            accepted="a number of at least 0 for all actions, as in 0.5, or numbers by routine or capability, as in Search=0.8,carry=0.5",
        ) from error


def part_weights(texts: list[str] | None) -> dict[str, float] | None:
    """
    What ``--part`` says, by name; None if it is not given.

    Raises
    ------
    InputError
        If a name is missing or stands twice, or a weight is no number above 0.
    """
    named: dict[str, float] = {}
    for text in texts or ():
        name, _, number = (piece.strip() for piece in text.rpartition("="))
        try:
            weight = _number(number)
        except ValueError:
            weight = 0.0
        if not name or name in named or not 0 < weight < math.inf:
            twice = f" ({name!r} stands twice)" if name in named else ""
            raise InputError(
                f"--part {text!r}{twice}", accepted="the name of a part and a number above 0, as in 'Search(cat)=3'"
            )
        named[name] = weight
    return named or None


def _quality(text: str) -> float:
    value = _number(text)
    if not 0 <= value < math.inf:
        raise ValueError(f"{text!r} is not a number of at least 0.")
    return value


def _number(text: str) -> float:
    try:
        return float(text)
    except ValueError:
        raise ValueError(f"{text!r} is not a number.") from None
