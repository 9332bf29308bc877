"""The suites that ship with missiontree, by name."""

from __future__ import annotations

import os
from pathlib import Path

from missiontree.errors import InputError
from missiontree.evaluation.suite import MISSIONS, Suite, load_suite

FOLDER = Path(__file__).parent / "suites"


def built_in_suites() -> tuple[str, ...]:
    """Their names."""
    return tuple(sorted(folder.name for folder in FOLDER.iterdir() if any(folder.rglob(MISSIONS))))


def suite_named(name: str) -> tuple[str, Suite]:
    """
    A suite and what it is called.

    Parameters
    ----------
    name
        A built-in suite by name, else a folder of the user's, else a setting of a built-in suite, such as ``paper``.

    Raises
    ------
    InputError
        If there is none, or its files are not what they should be.
    """
    if name in built_in_suites():
        return name, load_suite(FOLDER / name)
    if os.path.isdir(name):
        return Path(name).resolve().name, load_suite(Path(name))
    setting = next((folder for folder in sorted(FOLDER.glob("*/*")) if folder.name == name), None)
    if setting is None:
        raise InputError(
            f"there is no suite {name!r:.100}",
            accepted=f"{', '.join(built_in_suites())}, a setting of one, or a folder with a {MISSIONS} in it",
        )
    return name, load_suite(setting)
