"""Short readable ids made from labels, which may be any Unicode."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Container

_LONGEST = 40


def make_id(label: str, taken: Container[str], fallback: str) -> str:
    """
    An id for a label: its words in ASCII joined by hyphens, numbered from 2 if the id is taken.

    Parameters
    ----------
    label
        What people read.
    taken
        Ids that are in use.
    fallback
        The word to use if nothing of the label can be written in ASCII.
    """
    base = _slug(label) or fallback
    number, made = 1, base
    while made in taken:
        number += 1
        made = f"{base}-{number}"
    return made


def _slug(label: str) -> str:
    plain = unicodedata.normalize("NFKD", label[:400]).encode("ascii", "ignore").decode()
    words = re.findall("[a-z0-9]+", re.sub("(?<=[a-z])(?=[A-Z])", " ", plain).lower())
    while words and not words[0][0].isalpha():
        words = words[1:] if len(words) > 1 else []
    slug = ""
    for word in words:
        longer = f"{slug}-{word}" if slug else word
        if len(longer) > _LONGEST:
            break
        slug = longer
    return slug or (words[0][:_LONGEST] if words else "")
