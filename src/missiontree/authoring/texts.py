"""Which texts may become a name: something to read, of one line, and not too long."""

from __future__ import annotations

import unicodedata

from missiontree.authoring.answer import refuse
from missiontree.authoring.wire import RULE

MAX_NAME = 300
MAX_OBJECTIVE = 100_000


def check_text(text: str, what: str, longest: int) -> None:
    """
    Make sure that a text may be a name.

    Raises
    ------
    RefusalError
        ``malformed_arguments``, if it is empty, longer than that many characters, or holds a control character.
    """
    if not text.strip():
        raise refuse(RULE, f"{what} is empty.", hint="Use words.")
    if len(text) > longest:
        raise refuse(RULE, f"{what} has {len(text)} characters; at most {longest} are taken.", hint="Use fewer words.")
    if odd := next((letter for letter in text if unicodedata.category(letter) in {"Cc", "Cs", "Zl", "Zp"}), None):
        raise refuse(
            RULE, f"{what} holds the control character {odd!r}.", hint="Use letters, digits, blanks, punctuation."
        )
