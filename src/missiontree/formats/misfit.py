"""
Where files that are sound by themselves do not fit together: in which of them the name stands that nothing else has.

The rules that join files know values, not lines. A name that such a refusal quotes and that none of its kind bears is looked for
in the text of the files, so that a person gets the line to mend, and the names there are.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from difflib import get_close_matches
from pathlib import Path

from missiontree.errors import InputError

MISSED = "does not have"
"""How rules say that a name of one file stands in no other; what else they say of names is not about spelling."""
_MOST_LISTED = 12
_LARGEST = 2_000_000  # characters of a file that is looked through


def misfit(message: str, files: Sequence[Path], names: Mapping[str, Sequence[str]], hint: str) -> InputError:
    """
    A refusal with the place of what does not fit, as far as it can be told.

    Parameters
    ----------
    message
        What is wrong, with names in quotes: ``'truck' starts at place 'bse', which the scene does not have.``
    files
        The files that have to fit together, that which names things of the others first.
    names
        What there is of each kind, as the message calls it: ``place``, ``robot type``, ``zone``.
    hint
        What to do where no place is found, or there is no name to be taken instead.
    """
    for kind, known in names.items() if MISSED in message else ():
        for name in re.findall(rf"\b{kind} '([^'\n]+)'", message):
            if name not in known:
                file, line = _place(name, files)
                near = get_close_matches(name, known, n=1)
                listed = ", ".join(known[:_MOST_LISTED]) + (", …" if len(known) > _MOST_LISTED else "")
                return InputError(
                    message,
                    file=file,
                    line=line,
                    accepted=listed,
                    hint=f"Did you mean {near[0]!r}?" if near else "" if file and known else hint,
                )
    return InputError(message, hint=hint)


def _place(name: str, files: Sequence[Path]) -> tuple[str, int]:
    """The first file and line in which the name stands by itself; an empty name and 0 if there is none."""
    alone = re.compile(rf"(?<![\w-]){re.escape(name)}(?![\w-])")
    for file in files:
        try:
            lines = file.read_text(encoding="utf-8-sig")[:_LARGEST].splitlines()
        except (OSError, UnicodeDecodeError):
            continue
        for number, line in enumerate(lines, start=1):
            if not line.lstrip().startswith("#") and alone.search(line):
                return str(file), number
    return "", 0
