"""Names of users and of models, made harmless where they are shown: no terminal control, no markup, no hidden direction."""

from __future__ import annotations

import re
import unicodedata

_ANSI = re.compile(
    r"(?:\x1b\[|\x9b)[0-?]*[ -/]*[@-~]"  # colours, cursor movements
    r"|(?:\x1b[\]PX^_]|[\x9d\x90\x98\x9e\x9f]).*?(?:\x07|\x1b\\|\x9c)"  # titles, links, device strings, with their content
    r"|\x1b[ -/]*[0-~]",
    re.DOTALL,
)
_BLANKS = frozenset("\t\v\f\r\x85\u2028\u2029")
_JOINERS = frozenset("\u200c\u200d")
_REPLACEMENT = "\ufffd"
_MARKUP = str.maketrans({"&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;", "'": "&#39;"})


def terminal_safe(text: str) -> str:
    """
    Text that a terminal shows and does not obey.

    Whole ANSI sequences go, then every control and format character: bidirectional overrides, zero-width characters, tags.
    Line feeds stay; other white space that breaks lines becomes a blank. The joiners that Persian, Hindi or emoji are written
    with stay. Half a surrogate pair becomes U+FFFD, so that the text can always be encoded.
    """
    if text.isascii() and text.isprintable():  # as most names are
        return text
    plain = _ANSI.sub("", text.replace("\r\n", "\n"))
    return "".join(shown for character in plain if (shown := _shown(character)))


def one_line(text: str) -> str:
    """The same on one line: runs of white space, line feeds included, become one blank."""
    return " ".join(terminal_safe(text).split())


def xml_safe(text: str) -> str:
    """
    Text that may stand in XML or HTML, between tags and in quoted attributes: harmless as in a terminal, never markup.

    Only characters that XML 1.0 allows are left.
    """
    return terminal_safe(text).translate(_MARKUP)


def _shown(character: str) -> str:
    """What stands for a character: itself, a blank, the replacement character, or nothing."""
    if character == "\n" or character in _JOINERS:
        return character
    if character in _BLANKS:
        return " "
    category = unicodedata.category(character)
    if category == "Cs":
        return _REPLACEMENT
    if category in {"Cc", "Cf"} or ord(character) & 0xFFFE == 0xFFFE:  # the last two of each plane are no characters
        return ""
    return character
