"""A document once it is read and before it is understood: plain data that knows its lines."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from missiontree.errors import InputError
from missiontree.formats.place import Path, where


@dataclass(frozen=True)
class Parsed:
    """
    Plain data and where it came from.

    Parameters
    ----------
    data
        Mappings, lists, text, numbers, truth values and None.
    source
        File it was read from, as messages name it.
    line_of
        Line, from 1, of what stands at a path; for a path that there is not, of the nearest thing above it.
    """

    data: Any
    source: str
    line_of: Callable[[Path], int]

    def refusal(self, message: str, path: Path = (), accepted: str = "", hint: str = "") -> InputError:
        """The error that says so, with file and line."""
        return InputError(
            message, file=self.source, line=self.line_of(path), where=where(path), accepted=accepted, hint=hint
        )
