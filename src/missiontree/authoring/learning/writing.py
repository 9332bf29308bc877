"""Methods as a person would write them in YAML, and one more added to a file without touching the rest of it."""

from __future__ import annotations

import re
from typing import Any

import yaml

from missiontree.authoring.methods.method import Method, MethodFile, read_methods
from missiontree.errors import InputError
from missiontree.formats.json_text import json_text
from missiontree.formats.plain import to_plain

_HEAD = "format: methods/1\nmethods:\n"
_ITEM = re.compile(r"^( *)- +\S", re.MULTILINE)
_LAST = "steps"  # what is long stands behind what is short
_WIDTH = 140


def methods_text(method: Method) -> str:
    """A file of one method, in YAML."""
    return _HEAD + _item(method, "  ")


def added(text: str, method: Method, source: str) -> str:
    """
    The text of a methods file with one more method.

    Parameters
    ----------
    text
        The file so far, in YAML or JSON; empty for a new one.
    method
        The method.
    source
        What the file is called.

    Raises
    ------
    InputError
        If it is no file of methods, or has a method of that id.
    """
    is_json = source.lower().endswith(".json")
    methods = read_methods(text, source).methods if text.strip() else ()
    if method.id in {known.id for known in methods}:
        raise InputError(
            f"method {method.id!r} is in the file already",
            file=source,
            where=method.id,
            hint="Give the new one another id (--as ID), or remove the old one.",
        )
    wanted = MethodFile(methods=(*methods, method))
    if is_json:
        return json_text({"format": "methods/1", **to_plain(wanted)})
    made = f"{text.rstrip()}\n{_item(method, _indent(text))}" if methods else methods_text(method)
    try:
        fits = read_methods(made, source) == wanted
    except InputError:
        fits = False
    if not fits:
        message = "nothing can be added behind the last method of this file"
        raise InputError(
            message, file=source, hint="Write its methods as a list with one '- ' each, or give another file."
        )
    return made


def _indent(text: str) -> str:
    """How far the entries of the list of methods are indented."""
    behind = text.partition("methods:")[2]
    found = _ITEM.search(behind)
    return found[1] if found else "  "


def _item(method: Method, indent: str) -> str:
    plain = [_in_order(to_plain(method))]
    dumped = yaml.safe_dump(plain, sort_keys=False, allow_unicode=True, default_flow_style=None, width=_WIDTH)
    return "".join(f"{indent}{line}\n" if line else "\n" for line in str(dumped).splitlines())


def _in_order(plain: Any) -> Any:
    if isinstance(plain, dict):
        keys = sorted(plain, key=lambda key: key == _LAST)
        return {key: _in_order(plain[key]) for key in keys}
    return [_in_order(member) for member in plain] if isinstance(plain, list) else plain
