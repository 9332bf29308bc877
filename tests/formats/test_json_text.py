"""The layout of written documents: an entry to a line where it fits."""

import json

import pytest
from hypothesis import given
from hypothesis import strategies as st

from missiontree.formats.json_text import json_text

anything = st.recursive(
    st.none() | st.booleans() | st.integers() | st.text(),
    lambda inner: st.lists(inner) | st.dictionaries(st.text(), inner),
)


@given(anything)
def test_the_text_is_json_of_the_data(data: object) -> None:
    assert json.loads(json_text(data)) == data


def laid_out(data: object, level: int) -> str:
    """The layout as it is described: tried for every value whether it fits."""
    text = json.dumps(data)
    if not isinstance(data, dict | list) or not data or (level > 1 and len(text) + 2 * level <= 120):
        return text
    inner = "  " * (level + 1)
    if isinstance(data, dict):
        lines = [f"{inner}{json.dumps(name)}: {laid_out(member, level + 1)}" for name, member in data.items()]
    else:
        lines = [inner + laid_out(member, level + 1) for member in data]
    start, end = "{}" if isinstance(data, dict) else "[]"
    return start + "\n" + ",\n".join(lines) + "\n" + "  " * level + end


numbers = st.lists(st.integers(0, 9), min_size=30, max_size=45)
members = st.dictionaries(st.text("ab", max_size=3), st.integers(0, 9), min_size=10, max_size=18)


@given(st.lists(st.lists(numbers | members | st.lists(members, max_size=3), max_size=4), max_size=3))
def test_values_about_as_long_as_a_line_are_broken_where_they_must(data: object) -> None:
    assert json_text(data) == laid_out(data, 0) + "\n"


def test_what_fits_stands_in_one_line_and_what_does_not_is_broken() -> None:
    data = {"a": [{"b": [1, 2]}, {"c": "x" * 130, "d": {}}], "e": []}
    # 130 letters do not fit into 120 columns, so the second entry is broken
    expected = [
        "{",
        '  "a": [',
        '    {"b": [1, 2]},',
        "    {",
        f'      "c": "{"x" * 130}",',
        '      "d": {}',
        "    }",
        "  ],",
        '  "e": []',
        "}",
        "",
    ]
    assert json_text(data).split("\n") == expected


@pytest.mark.parametrize("acting", ["\x7f", "\x85", "\u202e", "\ud800", "\ufeff"])
def test_a_character_that_acts_is_written_by_its_number(acting: str) -> None:
    assert json_text({"a": f"x{acting}y"}) == f'{{\n  "a": "x\\u{ord(acting):04x}y"\n}}\n'
