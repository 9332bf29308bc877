"""
Plain data to a value, or to an error that a person can act on.

Pydantic checks against the annotations, strictly: text is no number, 1.0 is no whole number. What it finds is said again in our
words, guided by the same annotations.
"""

from __future__ import annotations

from dataclasses import dataclass
from difflib import get_close_matches
from typing import TYPE_CHECKING, Any, TypeVar, cast

from missiontree.errors import InputError, NotEnforcedError
from missiontree.formats.annotation import (
    a_noun,
    arms,
    hints_of,
    in_words,
    is_list,
    is_mapping,
    is_value,
    item_of,
    noun,
    required_of,
)
from missiontree.formats.blame import culprit
from missiontree.formats.not_enforced import planned_field, planned_word
from missiontree.formats.parsed import Parsed
from missiontree.formats.per_class import per_class
from missiontree.formats.place import Path, found, quoted, where
from missiontree.formats.scalar import plain_scalar

if TYPE_CHECKING:
    from pydantic import TypeAdapter

T = TypeVar("T")
_NOWHERE = object()
_MAX_FAULTS = 1000


@per_class
def adapter(cls: type[Any]) -> TypeAdapter[Any]:
    """Pydantic's view of a value."""
    from pydantic import TypeAdapter  # noqa: PLC0415 - pydantic takes its time to load

    return TypeAdapter(cls)


def to_value(parsed: Parsed, cls: type[T]) -> T:
    """
    The value that the data describes.

    Raises
    ------
    NotEnforcedError
        If it has a field whose rule is planned but not enforced yet.
    InputError
        If it does not describe such a value: the fault that stands first in the file, and how many follow.
    """
    from pydantic import ValidationError  # noqa: PLC0415 - as above
    from pydantic_core import to_json  # noqa: PLC0415

    try:
        return cast(T, adapter(cls).validate_json(to_json(parsed.data), strict=True))
    except ValidationError as error:
        details = error.errors(include_url=False, include_input=False)
        faults = [_locate(cls, parsed.data, detail["loc"], detail) for detail in details[:_MAX_FAULTS]]
    placed = {fault.path: fault for fault in reversed(faults) if fault is not None}
    first = min(placed.values(), key=lambda fault: _rank(parsed.data, fault.path))
    refusal = first.refusal(parsed)
    if len(placed) > 1:
        count = f"{'at least ' if len(details) > _MAX_FAULTS else ''}{len(placed) - 1}"
        more = f"{count} more fault{'s' if len(placed) > 2 else ''} further down."
        refusal.hint = f"{refusal.hint} {more}".strip()
    raise refusal


def _rank(data: Any, path: Path) -> tuple[int, ...]:
    """Sorts paths in the order of the document; what is missing comes after what is there, of which it may be a misspelling."""
    rank = []
    for step in path:
        keys = list(data) if isinstance(data, dict) else []
        rank.append(step if isinstance(step, int) else keys.index(step) if step in keys else len(keys))
        data = _child(data, step)
    return tuple(rank)


@dataclass(frozen=True)
class _Fault:
    """A fault, where it is, and what the annotation there and the class around it are."""

    path: Path
    annotation: Any
    data: Any
    owner: type[Any] | None
    kind: str
    context: dict[str, Any]

    def refusal(self, parsed: Parsed) -> InputError:
        if self.kind == "value_error":
            message = str(self.context["error"])
            return parsed.refusal(message.rstrip("."), culprit(message, self.data, self.path))
        if self.kind == "unexpected_keyword_argument" and self.owner is not None:
            return self._unknown_field(parsed, self.owner)
        if self.kind == "missing" and self.data is _NOWHERE:
            return self._missing(parsed)
        if self.kind == "key":
            message = f"the key {quoted(str(self.path[-1]))} is not accepted"
            return parsed.refusal(message, self.path, in_words(self.annotation))
        return self._wrong(parsed)

    def _unknown_field(self, parsed: Parsed, owner: type[Any]) -> InputError:
        name = str(self.path[-1])
        if rule := planned_field(owner.__name__, name):
            return self._not_enforced(parsed, rule)
        return parsed.refusal(
            f"{a_noun(owner)} has no field {quoted(name)}",
            self.path,
            f"the fields {', '.join(hints_of(owner))}",
            nearest(name, tuple(hints_of(owner))),
        )

    def _missing(self, parsed: Parsed) -> InputError:
        accepted = in_words(self.annotation)
        if self.owner is None or isinstance(self.path[-1], int):
            return parsed.refusal("the list is too short", self.path[:-1], f"as its next entry {accepted}")
        given = parsed_at(parsed.data, self.path[:-1])
        unknown = [key for key in given if key not in hints_of(self.owner)] if isinstance(given, dict) else []
        meant = get_close_matches(str(self.path[-1]), unknown, 1)
        hint = f"Is {quoted(meant[0])} meant to be it?" if meant else ""
        message = f"{a_noun(self.owner)} needs the field {quoted(str(self.path[-1]))}, which is missing"
        return parsed.refusal(message, self.path[:-1], accepted, hint)

    def _wrong(self, parsed: Parsed) -> InputError:
        owner, name = self.owner, str(self.path[-1]) if self.path else ""
        if owner is not None and isinstance(self.data, str) and (rule := planned_word(owner.__name__, name, self.data)):
            return self._not_enforced(parsed, rule)
        return parsed.refusal(
            f"found {found(self.data)}", self.path, in_words(self.annotation), _advice(self.annotation, self.data)
        )

    def _not_enforced(self, parsed: Parsed, rule: str) -> NotEnforcedError:
        return NotEnforcedError(
            f"this belongs to {rule}: planned, but no stage enforces it yet",
            file=parsed.source,
            line=parsed.line_of(self.path),
            where=where(self.path),
            accepted="the file without it",
            hint="Remove it; accepted and ignored, it would make the plan look better than it is.",
        )


def _locate(cls: type[Any], data: Any, loc: tuple[int | str, ...], detail: Any) -> _Fault | None:
    """
    The fault at pydantic's location; None if it is about a way of writing that the writer did not choose.

    Pydantic's location names, beside keys and indices, the arm of a union that it tried. A mapping is meant as the class
    of the union, anything else as one of its plain arms, about which one message is enough.
    """
    path: Path = ()
    annotation: Any = cls
    owner: type[Any] | None = None
    steps = list(loc)
    while steps:
        step = steps.pop(0)
        offered = arms(annotation)
        if len(offered) > 1:
            chosen = next((arm for arm in offered if is_value(arm)), None)
            if not isinstance(data, dict) or chosen is None:
                return _Fault(path, annotation, data, owner, "union", {})
            if step != chosen.__name__:
                return None
            annotation = chosen
            continue
        annotation = offered[0]
        if is_mapping(annotation) and steps and steps[0] == "[key]":
            return _Fault((*path, step), _args(annotation)[0], step, None, "key", {})
        annotation, owner = _below(annotation, step)
        data, path = _child(data, step), (*path, step)
    return _Fault(path, annotation, data, owner, detail["type"], detail.get("ctx", {}))


def _below(annotation: Any, step: int | str) -> tuple[Any, type[Any] | None]:
    """Annotation of what stands at a step, and the class whose field it is."""
    if is_value(annotation):
        return hints_of(annotation).get(str(step), Any), annotation
    if is_list(annotation):
        return item_of(annotation, int(step)), None
    return (_args(annotation)[1] if is_mapping(annotation) else Any), None


def _args(annotation: Any) -> tuple[Any, ...]:
    return tuple(annotation.__args__)


def _child(data: Any, step: int | str) -> Any:
    try:
        return data[step]
    except (KeyError, IndexError, TypeError):
        return _NOWHERE


def parsed_at(data: Any, path: Path) -> Any:
    """What stands at a path; None if nothing does."""
    for step in path:
        data = _child(data, step)
    return None if data is _NOWHERE else data


def nearest(word: str, known: tuple[str, ...]) -> str:
    """The hint that names the known word most like this one; empty if none is like it."""
    close = get_close_matches(word, known, 1) or [name for name in known if name.startswith(f"{word}_")]
    return f"Did you mean {quoted(close[0])}?" if close else ""


def _advice(annotation: Any, data: Any) -> str:
    """What the writer probably overlooked."""
    wants = in_words(annotation)
    if data is None:
        return "Give it a value, or remove the key."
    if isinstance(data, str) and "number" in wants and _is_number(data):
        return "Write the number without quotes."
    if isinstance(data, str) and "number" in wants and data[:1].isdigit():
        return "Write the number alone; the name of the field says its unit."
    if isinstance(data, bool | int | float) and wants == "text":
        return f"Put it in quotes: {str(data).lower()!r}."
    if isinstance(data, str) and wants == "true or false":
        return "Write true or false, without quotes."
    if isinstance(data, str) and wants.startswith("one of "):
        return nearest(data, tuple(wants.removeprefix("one of ").replace("'", "").split(", ")))
    if not isinstance(data, list) and wants.startswith("a list"):
        return "Put it in square brackets, or write each entry behind a '- '."
    if isinstance(data, str) and wants.startswith("an id"):
        return "Free text goes into a label."
    if isinstance(data, str) and is_value(arms(annotation)[0]):
        value = arms(annotation)[0]
        needed = ", ".join(f"{name}: ..." for name in required_of(value))
        return f"Write {a_noun(value)} as {{{needed}}}." if needed else f"Write {noun(value)} as a mapping."
    return ""


def _is_number(text: str) -> bool:
    try:
        return isinstance(plain_scalar(text), int | float) and text not in {"true", "false"}
    except ValueError:
        return False
