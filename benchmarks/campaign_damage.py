"""
What can go wrong with a call on its way: 25 kinds of damage, each made from a sound call.

A damage says whether the call can still be taken; most calls can not, whoever reads them, and are to be refused.
"""

from __future__ import annotations

import copy
import json
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from random import Random
from typing import Any

from benchmarks.campaign_damaged_text import (
    commented,
    concatenated,
    fenced,
    keys_unquoted,
    marked,
    trailing,
    twice,
    unquote,
    wrong_bracket,
)
from benchmarks.campaign_dialogues import Call
from benchmarks.campaign_letters import LOOK_ALIKES
from missiontree.authoring.tools import BY_NAME

TRUNCATED = "cut short"


@dataclass(frozen=True, slots=True)
class Damaged:
    """
    A damaged call.

    Parameters
    ----------
    name, arguments
        What is sent.
    hopeless
        Whether it must be refused.
    """

    name: str
    arguments: str
    hopeless: bool = True


Damage = Callable[[Random, str, dict[str, Any], str], Damaged]
"""Damages a call: luck, its function, its arguments, and the same as text."""


def written(arguments: Mapping[str, Any]) -> str:
    """The arguments as a sound model writes them."""
    return json.dumps(dict(arguments), ensure_ascii=False)


def cut_short(call: Call, length: int) -> Damaged:
    """The call cut after so many bytes. Half a letter is what is left of it: nothing but a sign that something is missing."""
    name, arguments = call
    left = (
        written(arguments)
        .encode(errors="surrogatepass")[:length]
        .decode(errors="replace" if length % 2 else "surrogateescape")
    )
    return Damaged(name, left, hopeless=length > 0 or _needs_arguments(name))


def damaged(rng: Random, kind: str, call: Call) -> Damaged:
    """The call with damage of that kind."""
    name, arguments = call
    if kind == TRUNCATED:
        return cut_short(call, rng.randrange(len(written(arguments))))
    return DAMAGES[kind](rng, name, copy.deepcopy(dict(arguments)), written(arguments))


def _needs_arguments(name: str) -> bool:
    return any(not parameter.optional for parameter in BY_NAME[name].parameters)


def _text(change: Callable[[Random, str], str]) -> Damage:
    """Damage of the text alone, after which it is no JSON object."""
    return lambda rng, name, arguments, text: Damaged(name, change(rng, text))


def _encoded_twice(rng: Random, name: str, arguments: dict[str, Any], text: str) -> Damaged:
    lists = [key for key, value in arguments.items() if isinstance(value, list) and value]
    if lists and rng.random() < 0.7:
        key = rng.choice(lists)
        return Damaged(name, written(arguments | {key: json.dumps(arguments[key])}))
    return Damaged(name, json.dumps(text))


def _no_object(rng: Random, name: str, arguments: dict[str, Any], text: str) -> Damaged:
    values = list(arguments.values())
    return Damaged(name, rng.choice((json.dumps(values), json.dumps([arguments]), "null", "true", "7", '"AND"')))


def _empty(rng: Random, name: str, arguments: dict[str, Any], text: str) -> Damaged:
    return Damaged(name, rng.choice(("", " ", "\n", "{}", "{ }", "undefined", "None")), hopeless=_needs_arguments(name))


def _value(make: Callable[[Random], str]) -> Damage:
    """One value, anywhere in the arguments, replaced by a text that stands for none."""

    def damage(rng: Random, name: str, arguments: dict[str, Any], text: str) -> Damaged:
        holder, key = rng.choice(list(_slots(arguments)))
        holder[key] = "@@@"
        return Damaged(name, written(arguments).replace('"@@@"', make(rng), 1))

    return damage


def _slots(value: Any) -> Iterator[tuple[Any, Any]]:
    """Every value within, as the object or list that holds it, and its key."""
    for key, inner in list(value.items() if isinstance(value, dict) else enumerate(value)):
        yield value, key
        if isinstance(inner, dict | list):
            yield from _slots(inner)


def _other_type(rng: Random, name: str, arguments: dict[str, Any], text: str) -> Damaged:
    """Numbers and truths as texts, texts as numbers."""
    plain = [slot for slot in _slots(arguments) if isinstance(slot[0][slot[1]], str | int)]
    if not plain:
        return _no_object(rng, name, arguments, text)
    holder, key = rng.choice(plain)
    given = holder[key]
    holder[key] = rng.choice((0, 1.5, True)) if isinstance(given, str) else f"{given}".lower()
    numbered = holder[key] is not True and isinstance(holder[key], int)  # may be the number of a node of this call
    return Damaged(name, written(arguments), hopeless=not numbered)


def _misnamed(rng: Random, name: str, arguments: dict[str, Any], text: str) -> Damaged:
    """A function that there is not, or, now and then, another one, which may take the same arguments."""
    if rng.random() < 0.2:
        return Damaged(rng.choice([other for other in BY_NAME if other != name]), text, hopeless=False)
    bent = (
        name + "s",
        name[:-1],
        name.swapcase(),
        f"functions.{name}",
        f" {name}",
        "",
        "eval",
        name * 50,
        "attach_multi_sub_trees",
    )
    return Damaged(rng.choice(bent), text)


def _look_alike(rng: Random, name: str, arguments: dict[str, Any], text: str) -> Damaged:
    """A function, an argument, or a name within, written with letters that only look the same."""
    change = LOOK_ALIKES[rng.choice(list(LOOK_ALIKES))]
    where = rng.choice(("function", "key", "value"))
    if where == "function":
        bent = change(rng, name)
        return Damaged(bent, text, hopeless=bent != name)
    key = rng.choice(list(arguments))
    if where == "key":
        bent = change(rng, key)
        changed = {bent if known == key else known: value for known, value in arguments.items()}
        return Damaged(name, written(changed), hopeless=bent != key)
    slots = [slot for slot in _slots({key: arguments[key]}) if isinstance(slot[0][slot[1]], str)]
    if slots:
        holder, at = rng.choice(slots)
        holder[at] = change(rng, holder[at])
    return Damaged(name, written(arguments), hopeless=False)  # names are judged by the campaign of names


def _argument_missing(rng: Random, name: str, arguments: dict[str, Any], text: str) -> Damaged:
    needed = [parameter.name for parameter in BY_NAME[name].parameters if not parameter.optional]
    del arguments[rng.choice(needed)]
    return Damaged(name, written(arguments))


def _argument_added(rng: Random, name: str, arguments: dict[str, Any], text: str) -> Damaged:
    more = rng.choice(("approved", "robots", "__class__", "parentstring", "draw", "self", "", "LogicalConstraint "))
    return Damaged(name, written(arguments | {more: rng.choice((True, "yes", [], {}))}))


def _null(rng: Random, name: str, arguments: dict[str, Any], text: str) -> Damaged:
    arguments[rng.choice([parameter.name for parameter in BY_NAME[name].parameters if not parameter.optional])] = None
    return Damaged(name, written(arguments))


def _deep(rng: Random) -> str:
    inner, depth = rng.choice((("[", "]"), ('{"a":', "}"))), rng.choice((33, 1_000, 100_000))
    return inner[0] * depth + "1" + (inner[1] * depth if rng.random() < 0.7 else "")


DAMAGES: Mapping[str, Damage] = {
    "quotes flipped": _text(unquote),
    "single quotes": lambda rng, name, arguments, text: Damaged(name, repr(arguments)),
    "keys twice": _text(twice),
    "not finite": _value(lambda rng: rng.choice(("NaN", "Infinity", "-Infinity", "1e999", "-1e400", "nan"))),
    "nested deep": _value(_deep),
    "lone surrogates": _value(
        lambda rng: rng.choice((r'"\ud83c"', r'"a\udfffb"', '"\ud83c"', r'["\udc00"]', r'{"\ud800": 1}'))
    ),
    "encoded twice": _encoded_twice,
    "other type": _other_type,
    "trailing commas": _text(trailing),
    "comments": _text(commented),
    "keys unquoted": _text(keys_unquoted),
    "wrong bracket": _text(wrong_bracket),
    "wrong function": _misnamed,
    "look-alike letters": _look_alike,
    "argument missing": _argument_missing,
    "argument too many": _argument_added,
    "null": _null,
    "two objects": _text(concatenated),
    "fences and prose": _text(fenced),
    "byte-order mark": _text(marked),
    "huge text": _value(
        lambda rng: json.dumps(rng.choice(("x", "é", "the ", "🍵")) * rng.choice((200_001, 1_000_001)))
    ),
    "huge integer": _value(lambda rng: "9" * rng.choice((19, 40, 400, 4_299, 4_301, 100_000))),
    "no object": _no_object,
    "empty": _empty,
}
KINDS = (TRUNCATED, *DAMAGES)
