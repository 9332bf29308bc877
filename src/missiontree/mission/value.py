"""
What makes a value: frozen, and checked at birth against what its annotations declare.

A constraint is written once, in the annotation (``Id``, ``NonNegative``, ``Positive``, ``Count``). It holds for values
built in Python, through ``Value.__post_init__``, and for values read from files, since pydantic and the JSON Schemas read
the same annotation.
"""

from __future__ import annotations

import math
import re
import sys
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from types import NoneType, UnionType
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Union, get_args, get_origin, get_type_hints

from annotated_types import Ge, Gt

from missiontree.mission.frozen_map import FrozenMap

if TYPE_CHECKING:
    from pydantic import GetCoreSchemaHandler
    from pydantic_core import CoreSchema

ID_PATTERN = "[A-Za-z][A-Za-z0-9_-]{0,63}"
_is_id = re.compile(ID_PATTERN, re.ASCII).fullmatch


@dataclass(frozen=True)
class IdPattern:
    """Marks a string that names something; free text is kept in labels."""

    def __get_pydantic_core_schema__(self, source: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        from pydantic_core import core_schema  # noqa: PLC0415 - pydantic is met at the edges only

        return core_schema.str_schema(pattern=f"^{ID_PATTERN}$")


Id = Annotated[str, IdPattern()]
NonNegative = Annotated[float, Ge(0)]
Positive = Annotated[float, Gt(0)]
Count = Annotated[int, Ge(1)]
Index = Annotated[int, Ge(0)]

Freeze = Callable[[str, Any], Any]


class Value:
    """
    Base of all values: a frozen dataclass whose fields are checked, and made immutable, at birth.

    Lists become tuples and mappings become :class:`FrozenMap`, so that a value can be hashed and shared. A subclass adds
    rules that span fields in ``_check``.

    Raises
    ------
    ValueError
        If a field breaks what its annotation declares, or ``_check`` finds a contradiction.
    """

    __slots__ = ()
    __pydantic_config__: ClassVar[dict[str, object]] = {"extra": "forbid", "allow_inf_nan": False}

    def __post_init__(self) -> None:
        rules = _RULES.get(type(self))
        if rules is None:
            rules = _RULES[type(self)] = _field_rules(type(self))
        for name, plain, freeze in rules:
            given = getattr(self, name)
            if type(given) is plain:
                continue
            frozen = freeze(name, given)
            if frozen is not given:
                object.__setattr__(self, name, frozen)
        self._check()

    def _check(self) -> None:
        """Refuse what no single field can see."""


def require_unique(what: str, ids: tuple[str, ...]) -> None:
    """Raise ``ValueError`` naming the first id that stands twice."""
    seen: set[str] = set()
    for identifier in ids:
        if identifier in seen:
            raise ValueError(f"{what} {identifier!r} stands twice.")
        seen.add(identifier)


Rules = tuple[tuple[str, type[Any] | None, Freeze], ...]
"""By field: the type of which every value may stay as it is, and what to do with all others."""
_RULES: dict[type[Any], Rules] = {}


def _field_rules(cls: type[Any]) -> Rules:
    hints = get_type_hints(cls, include_extras=True)
    rules = ((name, *_field_rule(hint)) for name, hint in hints.items() if get_origin(hint) is not ClassVar)
    return tuple((name, plain, rule) for name, plain, rule in rules if rule is not None)


def _field_rule(annotation: Any) -> tuple[type[Any] | None, Freeze | None]:
    only = _only(annotation)
    if only is not None:
        return NoneType, _rule(only)
    return {str: str, int: int}.get(annotation), _rule(annotation)


def _only(annotation: Any) -> Any:
    """The other arm of what may be None, and something of one kind alone; else None."""
    if get_origin(annotation) not in {Union, UnionType}:
        return None
    arms = [arg for arg in get_args(annotation) if arg is not NoneType]
    return arms[0] if len(arms) == 1 else None


def _rule(annotation: Any) -> Freeze | None:
    """What to do with a field so annotated; None if nothing."""
    origin, args = get_origin(annotation), get_args(annotation)
    if origin is Annotated:
        return _constrained(args[0], args[1:])
    if origin in {Union, UnionType}:
        only = _rule(_only(annotation))
        return None if only is None else lambda name, given: given if given is None else only(name, given)
    if origin is tuple:
        return _sequence(_rule(args[0]), args)
    if origin is not None and isinstance(origin, type) and issubclass(origin, Mapping):
        return _mapping(_rule(args[0]), _rule(args[1]))
    return _PLAIN.get(annotation) if isinstance(annotation, type) else None


def _constrained(base: Any, marks: tuple[Any, ...]) -> Freeze | None:
    if any(isinstance(mark, IdPattern) for mark in marks):
        return _identifier
    lows: list[tuple[Any, bool]] = [(mark.ge, True) for mark in marks if isinstance(mark, Ge)]
    lows += [(mark.gt, False) for mark in marks if isinstance(mark, Gt)]
    if not lows:
        return _rule(base)
    low, inclusive = lows[0]

    plain = _whole if base is int else _number
    types = (int,) if base is int else (float, int)

    def bounded(name: str, given: Any) -> Any:
        if type(given) in types and low < given <= sys.float_info.max:  # as nearly all are
            return given
        plain(name, given)
        if given < low or (given == low and not inclusive):
            raise ValueError(f"{name} must be {'at least' if inclusive else 'above'} {low}, got {given}.")
        return given

    return bounded


def _identifier(name: str, given: Any) -> Any:
    if not isinstance(given, str) or not _is_id(given):
        raise ValueError(
            f"{name} must be an id (a letter, then up to 63 letters, digits, '_' or '-'), got {given!r}. "
            "Free text goes into a label."
        )
    return given


def _number(name: str, given: Any) -> Any:
    if isinstance(given, bool) or not isinstance(given, int | float) or not math.isfinite(given):
        raise ValueError(f"{name} must be a finite number, got {given!r}.")
    return given


def _whole(name: str, given: Any) -> Any:
    if isinstance(given, bool) or not isinstance(given, int):
        raise ValueError(f"{name} must be a whole number, got {given!r}.")
    return given


def _text(name: str, given: Any) -> Any:
    if not isinstance(given, str):
        raise ValueError(f"{name} must be text, got {given!r}.")
    return given


_PLAIN: dict[type, Freeze] = {float: _number, int: _whole, str: _text}


def _sequence(inner: Freeze | None, args: tuple[Any, ...]) -> Freeze:
    def freeze(name: str, given: Any) -> Any:
        if not isinstance(given, tuple) and (isinstance(given, str) or not hasattr(given, "__iter__")):
            raise ValueError(f"{name} must be a list, got {given!r}.")
        items = given if isinstance(given, tuple) else tuple(given)
        if inner is None or not items:
            return items
        try:
            frozen = tuple([inner("", item) for item in items])
        except ValueError:  # once more, for the name that stands in its message
            frozen = tuple(inner(f"{name}[{index}]", item) for index, item in enumerate(items))
        return items if frozen == items else frozen

    return freeze


def _as_it_is(name: str, given: Any) -> Any:
    return given


def _mapping(key_rule: Freeze | None, value_rule: Freeze | None) -> Freeze:
    of_key, of_value = key_rule or _as_it_is, value_rule or _as_it_is

    def freeze(name: str, given: Any) -> Any:
        if isinstance(given, FrozenMap) and not given:
            return given
        if not isinstance(given, Mapping):
            raise ValueError(f"{name} must be a mapping, got {given!r}.")
        try:
            items = {of_key("", key): of_value("", value) for key, value in given.items()}
        except ValueError:  # once more, for the name that stands in its message
            items = {of_key(f"key of {name}", key): of_value(f"{name}.{key}", value) for key, value in given.items()}
        return given if isinstance(given, FrozenMap) and given == items else FrozenMap(items)

    return freeze
