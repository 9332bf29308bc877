"""A file of a suite is read whole, or refused at the line that is wrong."""

from pathlib import Path

import jsonschema
import pytest
import yaml

from missiontree.errors import InputError
from missiontree.evaluation.suite import read_suite_file
from missiontree.evaluation.suite_file import SuiteFile
from missiontree.formats.schema import schema_of

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
        (
            "    declined: unclear\n    because: if\n",
            "",
            15,
            "'home-03' needs one of plan, must and declined; it has none",
        ),
        ("because: if", "because: if\n    order: [1 < 2]", 15, "belong to a plan"),
        ("because: if", "because: if\n    plan: [Search(Cat)]", 15, "it has plan and declined"),
        ("say: If it rains, fetch the cat.", "say: ' '", 15, "has no words"),
    ],
)
def test_a_fault_is_told_with_its_line(old: str, new: str, line: int, says: str) -> None:
    assert TEXT.count(old) >= 1
    with pytest.raises(InputError) as refusal:
        read_suite_file(TEXT.replace(old, new, 1), "missions.yaml")
    assert says in str(refusal.value)
    assert (refusal.value.file, refusal.value.line) == ("missions.yaml", line)


LOOSE = """\
format: suite/1
setting: home
missions:
  - id: home-01
    say: Look after the boy.
    must: [Search(*), Follow(Boy)]
    must_not: [Reach(*)]
    order: [1 < 2]
    entities: [Boy]
    outcome: cannot_be_done
  - id: home-02
    say: Look after the boy.
    fleet: small.yaml
    scene: dark.yaml
    declined: impossible
    because: search | find
    twin: home-01
    removed: all robots that search
"""


def test_loose_expectations_twins_and_own_files_are_read() -> None:
    first, second = read_suite_file(LOOSE, "missions.yaml").missions
    assert (first.expected, str(first.loose)) == (
        (),
        "must Search(*); Follow(Boy) | must not Reach(*) | entities Boy | 1 < 2",
    )
    assert (first.outcome, first.fleet, first.scene) == ("cannot_be_done", None, None)
    assert (second.fleet, second.scene, second.twin) == ("small.yaml", "dark.yaml", "home-01")
    assert first.wanted == (str(first.loose),)
    assert second.wanted == ("declined as impossible, because of 'search | find'",)


@pytest.mark.parametrize(
    ("old", "new", "line", "says"),
    [
        ("[Search(*), Follow(Boy)]", "[Search, Follow(Boy)]", 6, "'Search' is not of the form"),
        ("[1 < 2]", "[1 < 3]", 8, "'1 < 3' names routine 3; must has 2"),
        ("must_not: [Reach(*)]", "must_not: [Follow(Boy)]", 7, "'Follow(Boy)' stands in must and in must_not"),
        ("outcome: cannot_be_done", "outcome: exhausted", 10, "'delivered', 'cannot_be_done'"),
        ("outcome: cannot_be_done", "plan: [Reach(Boy)]", 4, "it has plan and must"),
        ("outcome: cannot_be_done", "accept: [{plan: [Reach(Boy)]}]", 4, "accept belongs to a plan"),
        ("outcome: cannot_be_done", "twin: home-02", 4, "'home-01' is possible"),
        ("because: search | find", "because: search |", 11, "nothing on one side of a '|'"),
        ("because: search | find", "because: search\n    outcome: delivered", 11, "belong to a plan"),
        ("twin: home-01", "twin: home-02", 17, "the id of another mission"),
        ("    removed: all robots that search\n", "", 11, "what was removed"),
        ("    twin: home-01\n", "", 11, "needs the id of another mission as its twin"),
    ],
)
def test_a_fault_in_loose_expectations_is_told_with_its_line(old: str, new: str, line: int, says: str) -> None:
    assert LOOSE.count(old) >= 1
    with pytest.raises(InputError) as refusal:
        read_suite_file(LOOSE.replace(old, new, 1), "missions.yaml")
    assert says in str(refusal.value)
    assert (refusal.value.file, refusal.value.line) == ("missions.yaml", line)


def test_the_schema_takes_what_the_reader_takes() -> None:
    schema = schema_of(SuiteFile, "suite")
    for text in (TEXT, LOOSE):
        jsonschema.validate(yaml.safe_load(text), schema)
    with pytest.raises(jsonschema.ValidationError):
        jsonschema.validate(yaml.safe_load(LOOSE.replace("[Search(*), Follow(Boy)]", "{xor: [Search(*)]}")), schema)


def test_the_example_of_the_reference_is_read() -> None:
    page = Path(__file__).parents[2] / "docs/reference/suites.md"
    example = page.read_text(encoding="utf-8").partition("```yaml\n")[2].partition("```")[0]
    assert len(read_suite_file(example, "suites.md").missions) == 10
