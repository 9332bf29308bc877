"""
YAML text to plain data with the line of everything, safely.

Built from the parser's events, on a stack of its own: no object is ever constructed from a tag, nothing is expanded, and no
depth of nesting can exhaust Python's.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import yaml
from yaml.events import (
    AliasEvent,
    CollectionEndEvent,
    CollectionStartEvent,
    DocumentStartEvent,
    Event,
    MappingStartEvent,
    NodeEvent,
    ScalarEvent,
    StreamEndEvent,
)

from missiontree.errors import InputError
from missiontree.formats.parsed import Parsed
from missiontree.formats.place import Path, quoted, where
from missiontree.formats.scalar import plain_scalar
from missiontree.formats.source import character_name, forbidden
from missiontree.formats.yaml_problem import in_words

MAX_DEPTH = 64
MAX_NODES = 2_000_000
_TAG = "tag:yaml.org,2002:"
_TAG_TYPES: dict[str, tuple[type, ...]] = {"int": (int,), "float": (int, float), "bool": (bool,), "null": (type(None),)}


def parse_yaml(text: str, source: str) -> Parsed:
    """
    Read one YAML document.

    Raises
    ------
    InputError
        If it is not YAML, or uses what is not accepted: a second document, duplicate keys, anchors, tags beyond the core
        ones, merge keys, NaN, more than 64 levels or 2,000,000 entries.
    """
    builder = _Builder(source)
    try:
        # The C parser gives the same events some ten times faster, where PyYAML was built with it. (A plain scalar's style is
        # '' to the one and None to the other.)
        loader = getattr(yaml, "CSafeLoader", yaml.SafeLoader)(text)
        try:
            while not isinstance(event := loader.get_event(), StreamEndEvent):
                builder.take(event)
        finally:
            loader.dispose()
    except yaml.YAMLError as error:
        raise in_words(error, source, text) from None
    return Parsed(builder.root, source, builder.line_of)


@dataclass(slots=True)
class _Open:
    """A mapping or list whose end has not come yet."""

    path: Path
    into: dict[str, Any] | list[Any]
    key: str | None = None


@dataclass
class _Builder:
    """Takes events, leaves data and lines."""

    source: str
    root: Any = None
    lines: dict[Path, int] = field(default_factory=dict)
    open: list[_Open] = field(default_factory=list)
    documents: int = 0

    def line_of(self, path: Path) -> int:
        while path and path not in self.lines:
            path = path[:-1]
        return self.lines.get(path, 1)

    def take(self, event: Event) -> None:
        line = event.start_mark.line + 1 if event.start_mark is not None else 1
        if isinstance(event, DocumentStartEvent):
            self._begin_document(line)
        elif isinstance(event, CollectionEndEvent):
            self.open.pop()
        elif isinstance(event, NodeEvent):
            self._refuse_references(event, line)
            self._add_node(event, line)

    def _begin_document(self, line: int) -> None:
        self.documents += 1
        if self.documents > 1:
            raise self._refusal(
                "a second document begins here ('---')", line, (), "one document per file", "Split the file."
            )

    def _refuse_references(self, event: NodeEvent, line: int) -> None:
        if event.anchor is not None:
            sign = "*" if isinstance(event, AliasEvent) else "&"
            raise self._refusal(
                f"{sign + event.anchor[:40]!r} is a YAML {'alias' if sign == '*' else 'anchor'}",
                line,
                self._path(),
                "YAML without anchors and aliases",
                f"Write it out; text that starts with {sign!r} needs quotes.",
            )

    def _add_node(self, event: NodeEvent, line: int) -> None:
        top = self.open[-1] if self.open else None
        if top is not None and isinstance(top.into, dict) and top.key is None:
            self._add_key(top, event, line)
            return
        path = self._path()
        if path not in self.lines:  # a member of a mapping already has the line of its key
            self.lines[path] = line
        if len(self.lines) > MAX_NODES:
            raise self._refusal("the file has too many entries", line, (), f"at most {MAX_NODES:,} entries")
        data = self._begin(event, path, line) if isinstance(event, CollectionStartEvent) else self._scalar(event, line)
        if top is None:
            self.root = data
        elif isinstance(top.into, dict):
            top.into[str(top.key)], top.key = data, None
        else:
            top.into.append(data)

    def _add_key(self, top: _Open, event: NodeEvent, line: int) -> None:
        if not isinstance(event, ScalarEvent):
            raise self._refusal("a key is a list or a mapping", line, top.path, "keys that are words")
        key, path = event.value, (*top.path, event.value)
        self._refuse_forbidden(key, line, top.path)
        if key == "<<" and not event.style:
            raise self._refusal("'<<' is a YAML merge key", line, top.path, "YAML without merge keys", "Write it out.")
        if event.tag not in (None, "!", _TAG + "str"):
            raise self._refusal(f"the tag {quoted(event.tag)} is not accepted", line, top.path, "keys that are words")
        if path in self.lines:
            raise self._refusal(
                f"the key {quoted(key)} stands twice, in lines {self.lines[path]} and {line}",
                line,
                top.path,
                "each key once",
            )
        self.lines[path], top.key = line, key

    def _begin(self, event: CollectionStartEvent, path: Path, line: int) -> dict[str, Any] | list[Any]:
        if len(self.open) >= MAX_DEPTH:
            raise self._refusal("the file is nested too deep", line, path[:4], f"at most {MAX_DEPTH} levels")
        into: dict[str, Any] | list[Any] = {} if isinstance(event, MappingStartEvent) else []
        if event.tag not in (None, "!", _TAG + ("map" if isinstance(into, dict) else "seq")):
            raise self._tag_refusal(event.tag, line)
        self.open.append(_Open(path, into))
        return into

    def _scalar(self, event: NodeEvent, line: int) -> Any:
        assert isinstance(event, ScalarEvent)
        self._refuse_forbidden(event.value, line, self._path())
        try:
            meant = plain_scalar(event.value)
        except ValueError as error:
            meant = event.value
            if not event.style and event.tag is None:
                raise self._refusal(str(error), line, self._path(), "a finite number") from None
        if event.tag is None:
            return event.value if event.style else meant
        if event.tag in ("!", _TAG + "str"):
            return event.value
        if not isinstance(meant, _TAG_TYPES.get(event.tag.removeprefix(_TAG), ())):
            raise self._tag_refusal(event.tag, line)
        return meant

    def _path(self) -> Path:
        if not self.open:
            return ()
        top = self.open[-1]
        if isinstance(top.into, list):
            return (*top.path, len(top.into))
        return top.path if top.key is None else (*top.path, top.key)

    def _refuse_forbidden(self, text: str, line: int, path: Path) -> None:
        if wrong := forbidden(text):
            raise self._refusal(
                f"the text holds {character_name(wrong[0])}", line, path, "text without control characters"
            )

    def _tag_refusal(self, tag: str, line: int) -> InputError:
        return self._refusal(
            f"the tag {quoted(tag)} is not accepted here",
            line,
            self._path(),
            "plain YAML without tags",
            "Text that starts with '!' needs quotes.",
        )

    def _refusal(self, message: str, line: int, path: Path, accepted: str, hint: str = "") -> InputError:
        return InputError(message, file=self.source, line=line, where=where(path), accepted=accepted, hint=hint)
