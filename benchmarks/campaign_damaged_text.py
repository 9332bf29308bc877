"""Damage of the text of a call, after which it is no object of JSON, whoever reads it."""

from __future__ import annotations

import json
from random import Random

_FENCES = (
    "```json\n{}\n```",
    "```\n{}```",
    "Here is the call:\n{}",
    "{}\n\nThis adds the task.",
    "<tool_call>{}</tool_call>",
    "json{}",
)


def unquote(rng: Random, text: str) -> str:
    """A quote left out, or another sign in its place."""
    place = rng.choice([at for at, letter in enumerate(text) if letter == '"'])
    return text[:place] + rng.choice(("", "'", '""', '\\"', "”", "`")) + text[place + 1 :]


def twice(rng: Random, text: str) -> str:
    """A key given again, with the same value or another."""
    key, value = rng.choice(list(json.loads(text).items()))
    again = f'"{key}": {json.dumps(rng.choice((value, "AND", None)), ensure_ascii=False)}'
    return "{" + again + ", " + text[1:] if rng.random() < 0.5 else text[:-1] + ", " + again + "}"


def trailing(rng: Random, text: str) -> str:
    """A comma before a closing bracket."""
    place = rng.choice([at for at, letter in enumerate(text) if letter in "]}" and text[at - 1] not in "[{"])
    return text[:place] + rng.choice((",", ", ", ",,", ";")) + text[place:]


def commented(rng: Random, text: str) -> str:
    """A comment, before, within or after."""
    note = rng.choice(("// the parent\n", "/* as asked */", "# see above\n", "<!-- note -->"))
    place = rng.choice([0, 1, len(text) - 1, len(text)])
    return text[:place] + note + text[place:]


def keys_unquoted(rng: Random, text: str) -> str:
    """A key without its quotes."""
    key = rng.choice(list(json.loads(text)))
    return text.replace(f'"{key}":', f"{key}:", 1)


def wrong_bracket(rng: Random, text: str) -> str:
    """One bracket that does not fit the others."""
    quoted, places = False, []
    for place, letter in enumerate(text):
        quoted ^= letter == '"'
        if letter in "[]{}" and not quoted:
            places.append(place)
    place = rng.choice(places)
    return text[:place] + rng.choice([letter for letter in "[]{}()<" if letter != text[place]]) + text[place + 1 :]


def fenced(rng: Random, text: str) -> str:
    """A fence, a tag or prose around it."""
    return rng.choice(_FENCES).replace("{}", text)


def marked(rng: Random, text: str) -> str:
    """A byte-order mark, or another sign that is not seen, before or after."""
    mark = rng.choice(("\ufeff", "ï»¿", "\x00", "\u2028", "\u200b"))
    return mark + text if rng.random() < 0.7 else text + mark


def concatenated(rng: Random, text: str) -> str:
    """Something more after it."""
    return text + rng.choice(("", "\n", ",", " ")) + rng.choice((text, "{}", "[]", "null"))
