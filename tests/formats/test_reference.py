"""The reference page is current, complete, and its examples are files that load."""

import re
from pathlib import Path

import pytest

from missiontree.formats.annotation import noun
from missiontree.formats.document import KINDS, read_text, write_text
from missiontree.formats.reference import field_table, main, refreshed
from missiontree.formats.schema import values_in
from missiontree.mission.fleet import DurationModel

PAGE = Path(__file__).parents[2] / "docs" / "reference" / "formats.md"
TEXT = PAGE.read_text(encoding="utf-8")
EXAMPLES = re.findall(r"<!-- example: (\w+) -->\n```\w+\n(.*?)```", TEXT, re.DOTALL)


def test_the_page_is_current(tmp_path: Path) -> None:
    """If this fails: python -m missiontree.formats.reference docs/reference/formats.md."""
    assert refreshed(TEXT) == TEXT
    copy = tmp_path / "formats.md"
    copy.write_text(re.sub(r"\n\| .*", "", TEXT), encoding="utf-8")
    main(copy)
    assert copy.read_text(encoding="utf-8") == TEXT


def test_every_value_of_every_document_has_its_table_under_its_heading() -> None:
    for cls in {cls for kind in KINDS.values() for cls in values_in(kind)}:
        heading = f"### {noun(cls).capitalize()}\n"
        assert heading in TEXT, cls
        assert f"<!-- fields: {cls.__name__} -->" in TEXT.partition(heading)[2].partition("###")[0], cls


def test_links_lead_to_headings() -> None:
    anchors = {heading.lower().replace(" ", "-") for heading in re.findall(r"^##+ (.+)$", TEXT, re.MULTILINE)}
    assert set(re.findall(r"\]\(#([\w-]+)\)", TEXT)) <= anchors


def test_a_table_says_what_is_accepted_what_holds_without_it_and_what_it_means() -> None:
    rows = field_table(DurationModel).splitlines()
    assert rows[2] == "| `scale` | a number above 0 | `1` | Factor on the nominal duration, above 0, default 1. |"
    assert len(rows) == 4


@pytest.mark.parametrize(("kind", "text"), EXAMPLES, ids=[kind for kind, _ in EXAMPLES])
def test_examples_load_and_survive(kind: str, text: str) -> None:
    value = read_text(text, kind)
    assert read_text(write_text(value, kind), kind) == value


def test_there_is_an_example_of_each_file_that_people_meet() -> None:
    assert {kind for kind, _ in EXAMPLES} == {"fleet", "scene", "routines", "mission", "plan", "why_not", "explanation"}
