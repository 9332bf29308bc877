"""A file of a suite is read whole, or refused at the line that is wrong."""

from pathlib import Path

import pytest

from missiontree.errors import InputError
from missiontree.evaluation.suite import read_suite_file

TEXT = """\
format: suite/1
setting: home
missions:
  - id: home-01
    say: Find the missing boy, then keep an eye on him.
    plan: [Search(Boy), Follow(Boy)]
    order: [1 < 2]
    note: Said to be missing.
  - id: home-02
    say: Bring the cup to ward 3 or ward 4.
    plan:
      - xor: ["Transport(Cup, Ward 3)", "Transport(Cup, Ward 4)"]
    accept:
      - plan: ["Transport(Cup, Ward 3)"]
  - id: home-03
    say: If it rains, fetch the cat.
    declined: unclear
    because: if
"""


def test_a_file_is_read() -> None:
    file = read_suite_file(TEXT, "missions.yaml")
    first, second, third = file.missions
    assert (file.setting, file.scene, file.fleet, file.routines) == ("home", None, None, ())
    assert str(first.expected[0]) == "Search(Boy); Follow(Boy) | 1 < 2"
    assert [str(expected) for expected in second.expected] == [
        "xor(Transport(Cup, Ward 3); Transport(Cup, Ward 4))",
        "Transport(Cup, Ward 3)",
    ]
    assert (third.expected, third.declined, third.because) == ((), "unclear", "if")


@pytest.mark.parametrize(
    ("old", "new", "line", "says"),
    [
        ("suite/1", "suite/2", 1, "version 2"),
        ("suite/1", "fleet/1", 1, "this is a fleet file"),
        ("[Search(Boy), Follow(Boy)]", "[Search(Boy), Follow Boy]", 6, "'Follow Boy' is not of the form"),
        ("plan: [Search(Boy), Follow(Boy)]", "plan: Search(Boy)", 6, "accepted: a list"),
        ("[1 < 2]", "[1 < 3]", 7, "the plan has 2"),
        ("[1 < 2]", "[1 > 2]", 7, "'1 > 2'"),
        ("note:", "remark:", 8, "has no field 'remark'"),
        ("id: home-02", "id: home-01", 9, "'home-01' stands twice"),
        ("xor:", "or:", 12, "'or' does not make a group"),
        ('["Transport(Cup, Ward 3)", "', '[Transport(Cup, Ward 3), "', 12, "square brackets"),
        ('- plan: ["Transport(Cup, Ward 3)"]', "- plan: [Transport]", 14, "'Transport' is not of the form"),
        ("declined: unclear", "declined: maybe", 17, "'impossible', 'unclear'"),
        ("    because: if\n", "", 15, "'home-03' needs because"),
        ("    declined: unclear\n    because: if\n", "", 15, "'home-03' has either a plan or declined; it has neither"),
        ("because: if", "because: if\n    order: [1 < 2]", 15, "belong to a plan"),
        ("because: if", "because: if\n    plan: [Search(Cat)]", 15, "it has both"),
        ("say: If it rains, fetch the cat.", "say: ' '", 15, "has no words"),
    ],
)
def test_a_fault_is_told_with_its_line(old: str, new: str, line: int, says: str) -> None:
    assert TEXT.count(old) >= 1
    with pytest.raises(InputError) as refusal:
        read_suite_file(TEXT.replace(old, new, 1), "missions.yaml")
    assert says in str(refusal.value)
    assert (refusal.value.file, refusal.value.line) == ("missions.yaml", line)


def test_the_example_of_the_reference_is_read() -> None:
    page = Path(__file__).parents[2] / "docs/reference/suites.md"
    example = page.read_text(encoding="utf-8").partition("```yaml\n")[2].partition("```")[0]
    assert len(read_suite_file(example, "suites.md").missions) == 6
