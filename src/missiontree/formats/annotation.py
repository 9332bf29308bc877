"""What a field's annotation means, in words a person reads: what is accepted there."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from dataclasses import MISSING, Field, fields, is_dataclass
from types import NoneType, UnionType
from typing import Annotated, Any, Literal, Union, get_args, get_origin, get_type_hints

from annotated_types import Ge, Gt

from missiontree.formats.per_class import per_class
from missiontree.mission.value import IdPattern

ID_IN_WORDS = "an id (a letter, then up to 63 letters, digits, '_' or '-')"
_BASE = {float: "a number", int: "a whole number", str: "text", bool: "true or false", NoneType: "null"}


@per_class
def hints_of(cls: type[Any]) -> dict[str, Any]:
    """Annotation of each field, in order, what ``Annotated`` says included."""
    hints = get_type_hints(cls, include_extras=True)
    return {field.name: hints[field.name] for field in fields(cls)}


@per_class
def required_of(cls: type[Any]) -> tuple[str, ...]:
    """Fields that must be given."""
    return tuple(field.name for field in fields(cls) if not _has_default(field))


def _has_default(field: Field[Any]) -> bool:
    return field.default is not MISSING or field.default_factory is not MISSING


def arms(annotation: Any) -> tuple[Any, ...]:
    """What a union offers apart from None; the annotation alone if it is no union."""
    if get_origin(annotation) in {Union, UnionType}:
        return tuple(arg for arg in get_args(annotation) if arg is not NoneType)
    return (annotation,)


def is_value(annotation: Any) -> bool:
    """Whether it is a class of ours, written as a mapping of its fields."""
    return isinstance(annotation, type) and is_dataclass(annotation)


def item_of(annotation: Any, index: int) -> Any:
    """Annotation of a list's entry."""
    args = get_args(annotation)
    if len(args) == 2 and args[1] is Ellipsis:
        return args[0]
    return args[index] if index < len(args) else Any


def is_list(annotation: Any) -> bool:
    """Whether it is written as a list."""
    return get_origin(annotation) is tuple


def is_mapping(annotation: Any) -> bool:
    """Whether it is written as a mapping with keys of the writer's choice."""
    origin = get_origin(annotation)
    return isinstance(origin, type) and issubclass(origin, Mapping)


def noun(cls: type[Any]) -> str:
    """A class as people say it: ``robot type``."""
    return re.sub(r"(?<=[a-z])(?=[A-Z])", " ", cls.__name__).lower()


def a_noun(cls: type[Any]) -> str:
    """The same with its article."""
    name = noun(cls)
    return f"{'an' if name[0] in 'aeiou' else 'a'} {name}"


def as_mapping(cls: type[Any]) -> str:
    """A class as what is written for it."""
    return f"a mapping with the fields {', '.join(hints_of(cls))}"


def in_words(annotation: Any, of_class: Callable[[type[Any]], str] = as_mapping) -> str:
    """What is accepted where a field has this annotation; ``of_class`` words the classes in it."""
    offered = arms(annotation)
    if len(offered) > 1:
        return ", or ".join(in_words(arm, of_class) for arm in sorted(offered, key=is_value))
    only = offered[0]
    if get_origin(only) is Annotated:
        return _constrained(*get_args(only))
    if get_origin(only) is Literal:
        return "one of " + ", ".join(repr(word) for word in get_args(only))
    if is_list(only):
        args = get_args(only)
        if args[-1] is Ellipsis:
            return f"a list, each entry {in_words(args[0], of_class)}"
        return f"a list of {len(args)}: {', '.join(in_words(arg, of_class) for arg in args)}"
    if is_mapping(only):
        key, value = get_args(only)
        return f"a mapping, each key {in_words(key, of_class)}, each value {in_words(value, of_class)}"
    return of_class(only) if is_value(only) else _BASE.get(only, "a value")


def _constrained(base: Any, *marks: Any) -> str:
    if any(isinstance(mark, IdPattern) for mark in marks):
        return ID_IN_WORDS
    words = in_words(base)
    for mark in marks:
        if isinstance(mark, Ge):
            words += f", at least {mark.ge}"
        elif isinstance(mark, Gt):
            words += f" above {mark.gt}"
    return words
