"""From bytes to text that is safe to parse and to show: size, encoding, control characters."""

from __future__ import annotations

import os
import re
from pathlib import Path

from missiontree.errors import InputError

MAX_YAML_BYTES = 20_000_000
MAX_JSON_BYTES = 400_000_000

# All but tab and line ends: what a terminal acts on, what UTF-8 cannot hold, and the two non-characters YAML forbids.
forbidden = re.compile("[\x00-\x08\x0b\x0c\x0e-\x1f\x7f-\x9f\ud800-\udfff\ufffe\uffff]").search

_CONTROLS = bytes({*range(32), 127} - set(b"\t\n\r"))


def max_bytes(source: str) -> int:
    """Size accepted: JSON, which programs write and which is quick to read, may be larger than YAML."""
    return MAX_JSON_BYTES if source.lower().endswith(".json") else MAX_YAML_BYTES


def load_text(path: Path) -> str:
    """
    The text of a file.

    Raises
    ------
    InputError
        If the file cannot be read, is larger than is accepted, or is not UTF-8.
    """
    source, limit = str(path), max_bytes(str(path))
    try:
        with open(path, "rb") as file:
            raw = file.read(limit + 1)
    except (OSError, ValueError) as error:
        raise InputError(
            _reason(path, error), file=_shown(source), accepted="the path of a file that can be read"
        ) from None
    if len(raw) > limit:
        raise too_large(_shown(source), limit)
    return decode(raw, _shown(source))


def too_large(source: str, limit: int) -> InputError:
    """The refusal of a document above its size."""
    return InputError("the file is too large", file=source, accepted=f"at most {limit:,} bytes")


def decode(raw: bytes, source: str) -> str:
    """Text from UTF-8, with or without a byte order mark."""
    if raw.startswith((b"\xff\xfe", b"\xfe\xff")):
        raise InputError("the file is UTF-16", file=source, line=1, accepted="UTF-8", hint="Save it as UTF-8.")
    try:
        return raw.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = raw.count(b"\n", 0, error.start) + 1
        message = f"byte 0x{raw[error.start]:02x} is not UTF-8"
        raise InputError(message, file=source, line=line, accepted="UTF-8", hint="Save the file as UTF-8.") from None


def clean(text: str, source: str) -> str:
    """
    The text without a byte order mark.

    Raises
    ------
    InputError
        If it holds a control character other than tab and line ends.
    """
    text = text.removeprefix("\ufeff")
    if _is_plain(text):
        return text
    if wrong := forbidden(text):
        raise InputError(
            f"the text holds {character_name(wrong[0])}",
            file=source,
            line=text.count("\n", 0, wrong.start()) + 1,
            accepted="text without control characters",
        )
    return text


def _is_plain(text: str) -> bool:
    """Whether it is ASCII without control characters, which files of many megabytes mostly are; quicker than a search."""
    return text.isascii() and len(raw := text.encode("ascii")) == len(raw.translate(None, _CONTROLS))


def character_name(character: str) -> str:
    """How a message names a character that cannot be shown."""
    what = "a NUL character" if character == "\0" else "a character that cannot be shown"
    return f"{what} (U+{ord(character):04X})"


def _shown(source: str) -> str:
    return "".join(character if character.isprintable() else "?" for character in source)


def _reason(path: Path, error: OSError | ValueError) -> str:
    if isinstance(error, FileNotFoundError):
        return "there is no such file"
    if isinstance(error, IsADirectoryError):
        return "this is a folder, not a file"
    if isinstance(error, PermissionError):
        return "the file may not be read"
    if isinstance(error, OSError) and error.errno is not None:
        return f"the file cannot be read: {os.strerror(error.errno)}"
    return "this is no path of a file"
