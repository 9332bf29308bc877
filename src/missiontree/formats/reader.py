"""The one door for text from outside: YAML or JSON in, plain data with lines out."""

from __future__ import annotations

from missiontree.errors import InputError
from missiontree.formats.json_reader import NotJsonError, parse_json
from missiontree.formats.parsed import Parsed
from missiontree.formats.source import MAX_JSON_BYTES, MAX_YAML_BYTES, clean, too_large
from missiontree.formats.yaml_reader import parse_yaml


def parse(text: str, source: str = "<text>") -> Parsed:
    """
    Read one document. A source that ends in ``.json`` must be JSON; anything else may be either.

    Raises
    ------
    InputError
        If it is neither, or is not safe; see :mod:`~missiontree.formats.yaml_reader`.
    """
    if len(text) > MAX_JSON_BYTES:
        raise too_large(source, MAX_JSON_BYTES)
    text = clean(text, source)
    if not text.strip():
        raise InputError("the file is empty", file=source, accepted="a YAML or JSON document")
    is_json = source.lower().endswith(".json")
    if is_json or text.lstrip()[0] in "{[":
        try:
            return parse_json(text, source)
        except NotJsonError as error:
            if is_json:
                raise error.refusal from None
    if len(text) > MAX_YAML_BYTES:
        raise too_large(source, MAX_YAML_BYTES)
    return parse_yaml(text, source)
