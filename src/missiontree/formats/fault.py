"""One fault of a document, said so that a person can mend it: what was found, what is accepted, what was probably meant."""

from __future__ import annotations

from dataclasses import dataclass
from difflib import get_close_matches
from typing import Any

from missiontree.errors import InputError, NotEnforcedError
from missiontree.formats.annotation import a_noun, arms, hints_of, in_words, is_value, noun, required_of
from missiontree.formats.blame import culprit
from missiontree.formats.not_enforced import planned_field, planned_word
from missiontree.formats.parsed import Parsed
from missiontree.formats.place import NOWHERE, Path, found, quoted, where
from missiontree.formats.scalar import plain_scalar

_LONGEST = 400
_COMMA = "Between { and } a comma ends a value: put text that holds one in quotes."


@dataclass(frozen=True)
class Fault:
    """
    A fault.

    Parameters
    ----------
    path
        Where it is.
    annotation
        What the field's annotation there says.
    data
        What stands there; ``NOWHERE`` if nothing does.
    owner
        Class whose field it is; None within a list or a mapping.
    kind
        Pydantic's name of the fault; ``key`` for a key, ``union`` for what fits no way of writing.
    context
        What pydantic adds, such as the error that a value raised.
    """

    path: Path
    annotation: Any
    data: Any
    owner: type[Any] | None
    kind: str
    context: dict[str, Any]

    def refusal(self, parsed: Parsed) -> InputError:
        """The error that tells it."""
        if self.kind == "value_error":
            message = str(self.context["error"])
            short = message if len(message) <= _LONGEST else f"{message[:_LONGEST]}..."
            return parsed.refusal(short.rstrip("."), culprit(message, self.data, self.path))
        if self.kind == "unexpected_keyword_argument" and self.owner is not None:
            return self._unknown_field(parsed, self.owner)
        if self.kind == "missing" and self.data is NOWHERE:
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
            nearest(name, tuple(hints_of(owner))) or (_COMMA if self.data is None else ""),
        )

    def _missing(self, parsed: Parsed) -> InputError:
        accepted = in_words(self.annotation)
        if self.owner is None or isinstance(self.path[-1], int):
            return parsed.refusal("the list is too short", self.path[:-1], f"as its next entry {accepted}")
        message = f"{a_noun(self.owner)} needs the field {quoted(str(self.path[-1]))}, which is missing"
        return parsed.refusal(message, self.path[:-1], accepted)

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
