"""The file of a local model, looked at before an engine is: is it there, is it a GGUF file, are all its parts there."""

from __future__ import annotations

import re
from pathlib import Path

from missiontree.errors import InputError

_MAGIC = b"GGUF"
_PART = re.compile(r"(?P<stem>.+)-(?P<number>\d{5})-of-(?P<count>\d{5})(?P<ending>\.gguf)", re.IGNORECASE)
_ACCEPTED = "a GGUF file of a chat model, as for llama.cpp"
_HINT = "Name the file as local:PATH.gguf. It must be on this machine; nothing is downloaded."


def model_files(path: Path) -> tuple[Path, ...]:
    """
    The files of the model whose file, or one of whose parts, is named.

    Parameters
    ----------
    path
        The file. Of a model in parts (``x-00001-of-00003.gguf``), any part.

    Returns
    -------
    tuple[Path, ...]
        Absolute paths; all parts, in order.

    Raises
    ------
    InputError
        With the file that is missing, cannot be read, or is no GGUF file.
    """
    _check(path)
    part = _PART.fullmatch(path.name)
    if part is None:
        return (path.absolute(),)
    count = int(part["count"])
    parts = [
        path.absolute().with_name(f"{part['stem']}-{number:05d}-of-{count:05d}{part['ending']}")
        for number in range(1, count + 1)
    ]
    for other in parts:
        _check(other)
    return tuple(parts)


def _check(path: Path) -> None:
    try:
        with path.open("rb") as file:
            start = file.read(len(_MAGIC))
    except FileNotFoundError:
        raise _refused(path, "there is no such file") from None
    except OSError as error:
        raise _refused(path, f"the file cannot be read: {error.strerror or error}") from error
    except ValueError as error:
        raise _refused(path, f"this is no path: {error}") from error
    if start != _MAGIC:
        raise _refused(path, "this is not a GGUF file: it does not begin with GGUF")


def _refused(path: Path, found: str) -> InputError:
    return InputError(found, file=str(path), accepted=_ACCEPTED, hint=_HINT)
