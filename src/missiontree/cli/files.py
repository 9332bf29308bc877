"""Files that commands write: refused before any work where they could not be written, and written whole."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from missiontree.errors import InputError


def refuse_unwritable(path: Path | None) -> None:
    """
    Refuse, before anything is planned, a file that could not be written afterwards.

    Raises
    ------
    InputError
        If its folder is not there or it is a folder itself.
    """
    if path is not None and (path.is_dir() or not path.parent.is_dir()):
        found = "it is a folder" if path.is_dir() else f"there is no folder {path.parent}"
        raise InputError("the file cannot be written", file=str(path), hint=f"{found[0].upper()}{found[1:]}.")


def refuse_clashing(files: Mapping[str, Path | None]) -> None:
    """
    Refuse one file under two options.

    Parameters
    ----------
    files
        Files by the option that names them; None where an option was not given.

    Raises
    ------
    InputError
        With both options.
    """
    taken: dict[Path, str] = {}
    for option, file in files.items():
        if file is None:
            continue
        if file in taken:
            raise InputError(f"{taken[file]} and {option} name the same file", file=str(file), accepted="two files")
        taken[file] = option


def save(path: Path, content: str | bytes) -> None:
    """
    Write a file whole.

    Raises
    ------
    InputError
        If it cannot be written.
    """
    try:
        path.write_bytes(content.encode("utf-8") if isinstance(content, str) else content)
    except OSError as error:
        raise InputError("the file cannot be written", file=str(path), hint=error.strerror or str(error)) from error
