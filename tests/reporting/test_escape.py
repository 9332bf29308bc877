"""Names made harmless."""

import unicodedata
from xml.etree import ElementTree

import pytest
from hypothesis import given
from hypothesis import strategies as st

from missiontree.reporting.escape import one_line, terminal_safe, xml_safe


@pytest.mark.parametrize(
    ("given_text", "shown"),
    [
        ("Locate the Lost Child", "Locate the Lost Child"),
        ("\x1b[31mred\x1b[0m", "red"),
        ("\x9b2Jwiped", "wiped"),
        ("\x1b]0;new title\x07text", "text"),
        ("\x1b]8;;http://evil\x1b\\link\x1b]8;;\x1b\\", "link"),
        ("\x1b\x1b[31m[31mtwice", "[31mtwice"),
        ("bell\x07 and null\x00", "bell and null"),
        ("abc\u202egnp.exe", "abcgnp.exe"),
        ("\u2066isolated\u2069", "isolated"),
        ("zero\u200bwidth\ufeff", "zerowidth"),
        ("tag\U000e0041ged", "tagged"),
        ("two\r\nlines\nkept", "two\nlines\nkept"),
        ("over\rwritten\tby\u2028this", "over written by this"),
        ("half \ud800 a pair", "half \ufffd a pair"),
        ("not\ufffea\U0001ffffcharacter", "notacharacter"),
    ],
)
def test_terminals_show_and_do_not_obey(given_text: str, shown: str) -> None:
    assert terminal_safe(given_text) == shown


@pytest.mark.parametrize("name", ["Müller", "母を探す", "می‌خواهم", "👩‍🚒", "क्‍ष", "e\u0301", "[bold]x[/bold]"])
def test_names_in_any_script_stay(name: str) -> None:
    assert terminal_safe(name) == name


def test_one_line_is_one_line() -> None:
    assert one_line(" a\n\n b\u2029c\td ") == "a b c d"


def test_markup_becomes_words() -> None:
    assert xml_safe("<script a='b'>\"&</script>\x08") == "&lt;script a=&#39;b&#39;&gt;&quot;&amp;&lt;/script&gt;"


@given(st.text(st.characters(exclude_categories=())))
def test_nothing_harmful_is_left(text: str) -> None:
    shown = terminal_safe(text)
    shown.encode("utf-8")
    for character in shown:
        assert character in "\n\u200c\u200d" or unicodedata.category(character) not in {"Cc", "Cf", "Cs"}
    assert terminal_safe(shown) == shown
    assert "\n" not in one_line(text)


@given(st.text(st.characters(exclude_categories=())))
def test_xml_parses_and_reads_back(text: str) -> None:
    root = ElementTree.fromstring(f'<a b="{xml_safe(text)}">{xml_safe(text)}</a>')  # noqa: S314 - it is our own
    assert (root.text or "") == terminal_safe(text)
    assert root.get("b") == terminal_safe(text).replace("\n", " ")  # attributes are normalised by every parser
