"""A report taken apart by a strict parser: every tag is closed, in order, and known."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import lru_cache
from html.parser import HTMLParser

from missiontree import plan
from missiontree.mission.plan import Plan
from missiontree.reporting.html.report import report_html
from missiontree.samples.catalogue import sample_file

VOID = frozenset({"meta", "input", "br", "hr", "img", "link"})


@dataclass
class Element:
    """A tag with its attributes, and what stands inside it: elements and text, in order."""

    tag: str
    attributes: dict[str, str]
    inside: list[Element | str] = field(default_factory=list)

    @property
    def children(self) -> list[Element]:
        """Elements right inside it."""
        return [part for part in self.inside if isinstance(part, Element)]

    @property
    def raw(self) -> str:
        """All characters inside it, as they are."""
        return "".join(part if isinstance(part, str) else part.raw for part in self.inside)

    def all(self) -> list[Element]:
        """The element and everything inside it, in order."""
        return [self, *(inner for child in self.children for inner in child.all())]

    def find(self, *tags: str) -> list[Element]:
        """Elements of those tags inside it, in order."""
        return [element for element in self.all() if element.tag in tags]

    def by_id(self, name: str) -> Element:
        """The one element of that id."""
        (found,) = [element for element in self.all() if element.attributes.get("id") == name]
        return found

    def by_class(self, name: str) -> list[Element]:
        """Elements of a class."""
        return [element for element in self.all() if name in element.attributes.get("class", "").split()]

    @property
    def text(self) -> str:
        """All words inside it, blanks folded."""
        return " ".join(self.raw.split())


class _Reader(HTMLParser):
    def __init__(self) -> None:
        super().__init__(convert_charrefs=True)
        self.root = Element("", {})
        self._open = [self.root]

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        names = [name for name, _ in attrs]
        assert len(set(names)) == len(names), f"<{tag}> has an attribute twice: {names}"
        element = Element(tag, {name: value or "" for name, value in attrs})
        self._open[-1].inside.append(element)
        if tag not in VOID:
            self._open.append(element)

    def handle_startendtag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.handle_starttag(tag, attrs)
        if tag not in VOID:
            self._open.pop()

    def handle_endtag(self, tag: str) -> None:
        assert self._open[-1].tag == tag, f"</{tag}> closes <{self._open[-1].tag}>"
        self._open.pop()

    def handle_data(self, data: str) -> None:
        self._open[-1].inside.append(data)

    def finished(self) -> Element:
        self.close()
        assert [element.tag for element in self._open] == [""], "something is left open"
        return self.root


def parsed(html: str) -> Element:
    """The page as a tree."""
    reader = _Reader()
    reader.feed(html)
    return reader.finished()


@lru_cache(maxsize=16)
def planned(sample: str) -> Plan:
    """The plan of a sample mission."""
    return plan(sample_file(sample))


@lru_cache(maxsize=16)
def report_of(sample: str) -> str:
    """The report of a sample mission, not checked."""
    return report_html(planned(sample))
