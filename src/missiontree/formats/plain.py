"""A value as JSON-able data: what a person would have written, defaults left out."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import MISSING, fields, is_dataclass
from typing import Any

from missiontree.formats.per_class import per_class
from missiontree.mission.fleet import Capability

_EXACT = 2**53
NO_DEFAULT = object()


def to_plain(value: Any) -> Any:
    """
    Plain data that reads back as an equal value.

    Fields at their default are left out, and so is a label that is the id. Whole numbers are written without a decimal
    point, and a capability that is only a quality as that number, so that equal values give equal data.
    """
    if isinstance(value, Capability) and value == Capability(value.quality):
        return to_plain(value.quality)
    if isinstance(value, float):
        return int(value) if value.is_integer() and abs(value) < _EXACT else value
    if value is None or isinstance(value, str | int):
        return value
    if isinstance(value, Mapping):
        return {key: to_plain(member) for key, member in value.items()}
    if isinstance(value, list | tuple):
        return [to_plain(member) for member in value]
    if is_dataclass(value) and not isinstance(value, type):
        return _fields(value)
    raise TypeError(f"a {type(value).__name__} has no place in a document.")


def _fields(value: Any) -> dict[str, Any]:
    plain = {}
    for name, default in defaults_of(type(value)):
        given = getattr(value, name)
        if default is not NO_DEFAULT and (given == default or (name == "label" and given == getattr(value, "id", ""))):
            continue
        plain[name] = to_plain(given)
    return plain


@per_class
def defaults_of(cls: type[Any]) -> tuple[tuple[str, Any], ...]:
    """Every field of a value with its default."""
    found = []
    for field in fields(cls):
        default: Any = NO_DEFAULT
        if field.default is not MISSING:
            default = field.default
        elif field.default_factory is not MISSING:
            default = field.default_factory()
        found.append((field.name, default))
    return tuple(found)
