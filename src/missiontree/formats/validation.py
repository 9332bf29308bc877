"""
Plain data to a value, or to an error that a person can act on.

Pydantic checks against the annotations, strictly: text is no number, 1.0 is no whole number. Where it finds a fault, the same
annotations say what stands there and what was meant.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, TypeVar, cast

from missiontree.formats.annotation import arms, hints_of, is_list, is_mapping, is_value, item_of
from missiontree.formats.fault import Fault
from missiontree.formats.parsed import Parsed
from missiontree.formats.per_class import per_class
from missiontree.formats.place import Path, child

if TYPE_CHECKING:
    from pydantic import TypeAdapter

T = TypeVar("T")
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
        data = child(data, step)
    return tuple(rank)


def _locate(cls: type[Any], data: Any, loc: tuple[int | str, ...], detail: Any) -> Fault | None:
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
                return Fault(path, annotation, data, owner, "union", {})
            if step != chosen.__name__:
                return None
            annotation = chosen
            continue
        annotation = offered[0]
        if is_mapping(annotation) and steps and steps[0] == "[key]":
            return Fault((*path, step), _args(annotation)[0], step, None, "key", {})
        annotation, owner = _below(annotation, step)
        data, path = child(data, step), (*path, step)
    return Fault(path, annotation, data, owner, detail["type"], detail.get("ctx", {}))


def _below(annotation: Any, step: int | str) -> tuple[Any, type[Any] | None]:
    """Annotation of what stands at a step, and the class whose field it is."""
    if is_value(annotation):
        return hints_of(annotation).get(str(step), Any), annotation
    if is_list(annotation):
        return item_of(annotation, int(step)), None
    return (_args(annotation)[1] if is_mapping(annotation) else Any), None


def _args(annotation: Any) -> tuple[Any, ...]:
    return tuple(annotation.__args__)
