"""The strict parsers take what is clean, and refuse each thing that they are there to find."""

from __future__ import annotations

import struct
import zlib

import pytest

from tests.reporting.hostile import MARKED
from tests.reporting.strict import check_png, check_terminal, parse_page, parse_svg

CLEAN_SVG = '<svg xmlns="http://www.w3.org/2000/svg" width="1"><g fill="url(#mt-a)"><text x="1">Zq0001 &lt;b&gt;</text></g></svg>'
CLEAN_PAGE = (
    '<!doctype html><html lang="en"><head><meta charset="utf-8"><style>a{color:red}</style></head>'
    '<body><p title="Zq0001">x &amp; Zq0001</p>'
    '<script type="application/json">{"a":"\\u003cb"}</script><script>let a = "<b>";</script></body></html>'
)


def test_clean_ones_are_taken() -> None:
    svg, page = parse_svg(CLEAN_SVG), parse_page(CLEAN_PAGE)
    svg.check_values(MARKED)
    page.check_values(MARKED)
    assert svg.signatures == {("svg", ("width",)), ("g", ("fill",)), ("text", ("x",))}
    assert "Zq0001 <b>" in svg.words
    assert (page.scripts, page.styles, page.data) == (['let a = "<b>";'], ["a{color:red}"], ['{"a":"\\u003cb"}'])
    check_terminal("Zq0001 – ä 中 👨\u200d👩\n")
    check_terminal("\x1b[1;31mred\x1b[0m\n", colour=True)


@pytest.mark.parametrize(
    "inside",
    [
        "<script>x</script>",
        "<a>x</a>",
        "<foreignObject/>",
        "<text>",
        "<text x=1/>",
        "<!-- Zq0001 -->",
        "<?x y?>",
        "<![CDATA[x]]>",
        "&nosuch;",
        "&#1;",
        "\u202e",
        "\x1b",
        '<g fill="url(//evil.test)"/>',
        '<g clip-path="javascript:x"/>',
        '<h:b xmlns:h="http://www.w3.org/1999/xhtml"/>',
        '<g xmlns:l="http://www.w3.org/1999/xlink" l:href="x"/>',
    ],
)
def test_a_picture_with_more_than_shapes_and_words_is_refused(inside: str) -> None:
    with pytest.raises((AssertionError, SyntaxError)):  # a ParseError of XML is a SyntaxError
        parse_svg(CLEAN_SVG.replace("<text", f"{inside}<text"))


@pytest.mark.parametrize("attribute", ["id", "class", "href", "style", "onload", "fill", "data-x"])
def test_a_name_in_an_attribute_that_does_something_is_refused(attribute: str) -> None:
    parsed = parse_svg(CLEAN_SVG.replace("<text", f'<text {attribute}="a Zq0001"'))
    with pytest.raises(AssertionError, match=attribute):
        parsed.check_values(MARKED)
    with pytest.raises(AssertionError, match=attribute):
        parse_page(CLEAN_PAGE.replace("<p ", f'<p {attribute}="a Zq0001" ')).check_values(MARKED)


@pytest.mark.parametrize(
    "inside",
    [
        "<b>",
        "</b>",
        "<b title=x></b>",
        "<b title='x'></b>",
        '<b title="a" title="b"></b>',
        '<b title="<"></b>',
        "<!-- x -->",
        "<?x?>",
        "<![CDATA[x]]>",
        "<!doctype html>",
        "a < b",
        "&nosuch;",
        "&#60;",
        "\x00",
        "\u2066",
        '<script type="application/json">{"a": "<"}</script>',
        '<script type="application/json">{a}</script>',
    ],
)
def test_a_page_that_a_browser_would_have_to_mend_is_refused(inside: str) -> None:
    with pytest.raises((AssertionError, KeyError, ValueError)):
        parse_page(CLEAN_PAGE.replace("<p ", f"{inside}<p "))


@pytest.mark.parametrize(
    "text", ["\x1b[31m", "\x9b31m", "\x07", "\r", "\t", "\u202e", "\u200b", "\u2028", "\U000e0041", "\uffff"]
)
def test_a_text_that_does_something_is_refused(text: str) -> None:
    with pytest.raises(AssertionError):
        check_terminal(f"a{text}b")


@pytest.mark.parametrize("text", ["\x1b[2J", "\x1b]8;;https://evil.test\x1b\\x", "\x1b[31", "\x1b[?25l"])
def test_a_coloured_text_that_does_more_than_colour_is_refused(text: str) -> None:
    with pytest.raises(AssertionError):
        check_terminal(text, colour=True)


def test_half_a_pair_of_surrogates_is_refused() -> None:
    with pytest.raises(UnicodeEncodeError):
        check_terminal("\ud800")


def png(*chunks: tuple[bytes, bytes]) -> bytes:
    parts = [
        struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body)) for kind, body in chunks
    ]
    return b"\x89PNG\r\n\x1a\n" + b"".join(parts)


HEAD, END = (b"IHDR", struct.pack(">IIBBBBB", 3, 2, 8, 6, 0, 0, 0)), (b"IEND", b"")


def test_a_png_with_words_in_it_is_refused() -> None:
    assert check_png(png(HEAD, (b"IDAT", b"x"), END)) == (3, 2)
    for wrong in (
        png(HEAD, (b"tEXt", b"Comment\0Zq0001"), END),
        png(HEAD, (b"iTXt", b"x"), END),
        png(HEAD, END) + b"x",
        png(HEAD),
        png(HEAD, END).replace(b"\0\0\0\x03", b"\0\0\0\x04"),
        b"GIF89a",
    ):
        with pytest.raises((AssertionError, struct.error)):
            check_png(wrong)
