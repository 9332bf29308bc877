"""Parsers that forgive nothing, for what must hold whatever somebody is called."""

from __future__ import annotations

import json
import re
import struct
import unicodedata
import zlib
from dataclasses import dataclass, field
from html.parser import HTMLParser
from xml.etree import ElementTree

Signature = tuple[str, tuple[str, ...]]
SVG = "{http://www.w3.org/2000/svg}"
JOINERS = {"\u200c", "\u200d"}  # Persian, Hindi and emoji are written with them
VOID = {"meta", "br", "hr", "img", "input", "link", "wbr", "col"}
PNG_CHUNKS = {b"IHDR", b"IDAT", b"IEND", b"PLTE", b"pHYs", b"sRGB", b"gAMA", b"tRNS", b"sBIT"}
COLOURS = re.compile(r"\x1b\[[0-9;]*m")
# Attributes in which a name may stand as words. None of them is fetched, run or obeyed.
WORDS = {"title", "aria-label", "aria-description", "alt", "value", "label", "placeholder", "data-name", "data-search"}


def unseen(text: str) -> set[str]:
    """Characters that act instead of being seen: controls, directions, halves of pairs, no characters. Line feeds aside."""
    return {letter for letter in set(text) if letter not in JOINERS | {"\n"} and _acts(letter)}


def _acts(letter: str) -> bool:
    return unicodedata.category(letter) in {"Cc", "Cf", "Cs", "Zl", "Zp"} or ord(letter) & 0xFFFE == 0xFFFE


def check_terminal(text: str, colour: bool = False) -> None:
    """Nothing in it moves a cursor, rings a bell or turns a direction; with colour, nothing but colours."""
    text.encode("utf-8")
    assert not unseen(COLOURS.sub("", text) if colour else text)


@dataclass
class Parsed:
    """What a document consists of."""

    signatures: set[Signature] = field(default_factory=set)
    texts: list[str] = field(default_factory=list)
    attributes: list[tuple[str, str]] = field(default_factory=list)  # all of them: name, value
    scripts: list[str] = field(default_factory=list)  # what runs
    styles: list[str] = field(default_factory=list)
    data: list[str] = field(default_factory=list)  # scripts that are data

    @property
    def words(self) -> str:
        return "\n".join(self.texts)

    def check_values(self, mark: re.Pattern[str]) -> None:
        """No name in an attribute that is more than words."""
        for name, value in self.attributes:
            assert not unseen(value), (name, value)
            assert not mark.search(value) or name in WORDS, (name, value)
            assert not name.startswith("on"), (name, value)
            assert name not in {"srcdoc", "formaction", "ping", "background"}, (name, value)


def parse_svg(text: str) -> Parsed:
    """A picture, by a parser that refuses everything that is not well-formed XML."""
    for forbidden in ("<!", "<?"):
        assert forbidden not in text, forbidden
    assert set(re.findall(r"&[^;]*;", text)) <= {"&amp;", "&lt;", "&gt;", "&quot;", "&#39;"}
    text.encode("utf-8")
    assert not unseen(text)
    parsed = Parsed()
    for element in ElementTree.fromstring(text).iter():  # noqa: S314 - no declarations, see above
        assert element.tag.startswith(SVG), element.tag
        tag = element.tag.removeprefix(SVG)
        assert tag not in {"script", "style", "foreignObject", "a", "animate", "set", "handler", "iframe", "image"}, tag
        parsed.signatures.add((tag, tuple(sorted(element.attrib))))
        parsed.attributes += element.attrib.items()
        parsed.texts += [element.text or "", element.tail or ""]
    for name, value in parsed.attributes:
        assert ":" not in name, name  # no other vocabulary, so nothing that is fetched or run
        assert not re.search(r"\w+:", value), (name, value)
        assert "url(" not in value or re.fullmatch(r"url\(#[A-Za-z0-9_-]+\)", value), (name, value)
    return parsed


_ATTRIBUTE = r"""\s+[A-Za-z_:][A-Za-z0-9_:.-]*(?:="[^"<>]*")?"""
_START = re.compile(rf"<[A-Za-z][A-Za-z0-9]*(?:{_ATTRIBUTE})*\s*/?>")


class _Page(HTMLParser):
    """Takes a page apart; whatever a browser would have to mend is refused."""

    def __init__(self) -> None:
        super().__init__(convert_charrefs=False)
        self.parsed, self.open = Parsed(), list[str]()
        self.raw: list[str] = []
        self.kind = ""

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        written = self.get_starttag_text() or ""
        assert _START.fullmatch(written), written
        names = [name for name, _ in attrs]
        assert len(names) == len(set(names)), written
        self.parsed.signatures.add((tag, tuple(sorted(names))))
        self.parsed.attributes += [(name, value or "") for name, value in attrs]
        if tag not in VOID and not written.endswith("/>"):
            self.open.append(tag)
        if tag in {"script", "style"}:
            self.kind, self.raw = dict(attrs).get("type") or tag, []

    def handle_startendtag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.handle_starttag(tag, attrs)

    def handle_endtag(self, tag: str) -> None:
        assert self.open, tag
        assert self.open.pop() == tag, tag
        if tag in {"script", "style"}:
            content = "".join(self.raw)
            if tag == "style":
                self.parsed.styles.append(content)
            elif self.kind == "application/json":
                self.parsed.data.append(content)
            else:
                self.parsed.scripts.append(content)

    def handle_data(self, data: str) -> None:
        if self.open and self.open[-1] in {"script", "style"}:
            self.raw.append(data)
            return
        assert "<" not in data, data
        self.parsed.texts.append(data)

    def handle_entityref(self, name: str) -> None:
        self.parsed.texts.append({"amp": "&", "lt": "<", "gt": ">", "quot": '"', "nbsp": "\u00a0"}[name])

    def handle_charref(self, name: str) -> None:
        self.parsed.texts.append({"39": "'", "34": '"'}[name])

    def handle_comment(self, data: str) -> None:
        raise AssertionError(f"a comment: {data}")

    def handle_decl(self, decl: str) -> None:
        assert decl.lower() == "doctype html", decl
        assert not self.parsed.signatures, "a declaration inside the page"

    def handle_pi(self, data: str) -> None:
        raise AssertionError(f"an instruction: {data}")

    def unknown_decl(self, data: str) -> None:
        raise AssertionError(f"a section: {data}")


def parse_page(text: str) -> Parsed:
    """A page of HTML, by a parser that takes only what needs no mending."""
    text.encode("utf-8")
    assert not unseen(text)
    page = _Page()
    page.feed(text)
    page.close()
    assert page.open == []
    for data in page.parsed.data:
        assert not set("<>&") & set(data)
        json.loads(data)
    return page.parsed


def check_png(data: bytes) -> tuple[int, int]:
    """Every chunk whole and none of them text; returns width and height."""
    assert data[:8] == b"\x89PNG\r\n\x1a\n"
    place, kinds, size = 8, [], (0, 0)
    while place < len(data):
        (length,) = struct.unpack(">I", data[place : place + 4])
        kind, body = data[place + 4 : place + 8], data[place + 8 : place + 8 + length]
        (checksum,) = struct.unpack(">I", data[place + 8 + length : place + 12 + length])
        assert checksum == zlib.crc32(kind + body)
        size = struct.unpack(">II", body[:8]) if kind == b"IHDR" else size
        kinds.append(kind)
        place += 12 + length
    assert place == len(data)
    assert (kinds[0], kinds[-1]) == (b"IHDR", b"IEND")
    assert set(kinds) <= PNG_CHUNKS
    return size
