"""The routines on offer: the built-in ones, which are files like everybody's, and those of the user."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from functools import cache
from importlib import resources
from pathlib import Path

from missiontree.errors import InputError
from missiontree.formats.document import read_file, read_text
from missiontree.mission.routine import Routine, RoutineLibrary
from missiontree.routines.compose import flatten
from missiontree.routines.python import collect

BUILT_IN_FILES = ("search", "follow", "reach", "transport", "combined")


@cache
def built_in() -> RoutineLibrary:
    """The paper's six: Search, Follow, Reach, Transport, SearchAndFollow, ReachAndTransport."""
    folder = resources.files("missiontree.routines") / "library"
    files = (
        read_text((folder / f"{name}.yaml").read_text(encoding="utf-8"), "routines", f"{name}.yaml")
        for name in BUILT_IN_FILES
    )
    return RoutineLibrary(routines=tuple(routine for file in files for routine in file.routines))


def load(paths: Iterable[Path | str]) -> RoutineLibrary:
    """
    The built-in routines and those of the user's files.

    Parameters
    ----------
    paths
        YAML or JSON files of routines, or Python files that define routines (see :mod:`missiontree.routines.python`; such a
        file is run). A file named twice is read once. Composed routines may use the routines of any of the files.

    Raises
    ------
    InputError
        If a file cannot be read, or a routine contradicts another.
    """
    found: list[Routine] = []
    origin: dict[str, str] = {}
    for path in {Path(path).resolve(): Path(path) for path in paths}.values():
        for routine in collect(path) if path.suffix == ".py" else read_file(path, "routines").routines:
            if routine.id in origin:
                raise _twice(routine, f"{origin[routine.id]} defines it too", str(path))
            origin[routine.id] = str(path)
            found.append(routine)
    return with_routines(built_in(), found, origin) if found else built_in()


def with_routines(
    library: RoutineLibrary, routines: Iterable[Routine], origin: Mapping[str, str] | None = None
) -> RoutineLibrary:
    """
    The library with more routines.

    Parameters
    ----------
    library
        Routines there are.
    routines
        Routines to add. None may have the name of one there is.
    origin
        File by routine id, for messages.

    Raises
    ------
    InputError
        If a name is taken, a part is not known or gets wrong arguments, or a composition cannot be flattened.
    """
    added, origin = tuple(routines), origin or {}
    for routine in added:
        if library.find(routine.id) is not None or library.find(routine.wire_name) is not None:
            raise _twice(routine, "a routine of that name is there already", origin.get(routine.id, ""))
    try:
        both = RoutineLibrary(routines=(*library.routines, *added))
    except ValueError as error:
        guilty = next((routine.id for routine in added if repr(routine.id) in str(error)), "")
        raise InputError(str(error), file=origin.get(guilty, "")) from error
    for routine in added:
        flatten(routine, both)
    return both


def _twice(routine: Routine, why: str, file: str) -> InputError:
    return InputError(
        f"routine {routine.id!r} cannot be added: {why}.", file=file, where=routine.id, hint="Give it another id."
    )
