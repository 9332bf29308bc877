"""Methods as data: what a file may hold, what is refused and where, and how users' methods go before ours."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from missiontree.authoring.methods.method import (
    Method,
    MethodLibrary,
    Step,
    built_in_methods,
    load_methods,
    read_methods,
)
from missiontree.authoring.offline import author_offline
from missiontree.authoring.outcome import Authored
from missiontree.authoring.views import outline
from missiontree.errors import InputError
from missiontree.formats.document import read_file
from missiontree.mission.brief import MissionBrief
from missiontree.routines.library import built_in
from missiontree.samples.catalogue import FOLDER

GUIDE = Path(__file__).parents[3] / "docs" / "how-to" / "write-a-method.md"
FETCH = """format: methods/1
methods:
  - id: fetch_for
    purpose: Something is found and brought.
    says: ["<bring> {thing} for {person}"]
    steps:
      - {do: Search(thing), name: find}
      - {do: "ReachAndTransport(thing, person)", after: [find]}
"""


def authored(text: str, methods: MethodLibrary) -> Authored:
    brief = MissionBrief(text=text, fleet=read_file(FOLDER / "fleet.yaml", "fleet"), routines=built_in())
    return author_offline(brief, methods)


def test_worked_example_of_the_guide_loads_and_gives_the_tree_it_shows(tmp_path: Path) -> None:
    guide = GUIDE.read_text(encoding="utf-8")
    file = tmp_path / "fetching.yaml"
    file.write_text(re.findall(r"```yaml\n(format: .*?)```", guide, re.DOTALL)[0], encoding="utf-8")
    command = re.search(r'missiontree plan "(.*?)"', guide)
    assert command is not None
    made = authored(command[1], load_methods([file]))
    assert made.status == "complete", made.reasons
    assert made.tree is not None
    assert "method fetch_for" in made.reading[0]
    shown = re.findall(r"```text\n(.*?)Precedence", guide, re.DOTALL)[0]
    without_ids = re.sub(r" \([a-z0-9-]+\)", "", outline(made.tree).split("\nPrecedence")[0]).replace(
        " [AND]\n  - Search", "\n  - Search", 0
    )
    assert without_ids.strip() == shown.strip()
    # Search before the task: one link
    assert [(link.first, link.second) for link in made.tree.links] == [
        ("search-umbrella", "unite-anna-and-the-umbrella")
    ]
    other = authored("Make sure that Anna gets an umbrella", load_methods([file]))
    assert other.status == "complete", other.reasons


def test_guide_names_every_field_of_a_step_and_of_a_method() -> None:
    guide = GUIDE.read_text(encoding="utf-8")
    for field in (*Step.__dataclass_fields__, *Method.__dataclass_fields__):
        assert field in guide


def test_without_the_users_method_the_built_in_one_only_brings() -> None:
    made = authored("Fetch the umbrella for Anna", built_in_methods())
    assert "method bring_for" in made.reading[0]
    assert made.tree is not None
    assert [node.routine for node in made.tree.nodes[1:]] == ["ReachAndTransport"]
    assert "fetch_for" not in authored("Make sure that Anna gets an umbrella", built_in_methods()).reading[0]


def test_users_method_goes_before_the_built_in_one_and_may_replace_it(tmp_path: Path) -> None:
    file = tmp_path / "own.yaml"
    file.write_text(FETCH.replace("<bring> {thing} for {person}", "<rescue> {thing} from {person}"), encoding="utf-8")
    made = authored("Rescue the cat from the dog", load_methods([file]))
    assert "method fetch_for" in made.reading[0]
    file.write_text(FETCH.replace("fetch_for", "rescue"), encoding="utf-8")
    library = load_methods([file])
    assert [method.id for method in library.methods].count("rescue") == 1
    assert len(library.methods) == len(built_in_methods().methods)


BROKEN = {
    "is no file of methods": ("format: fleet/1\ntypes: []\n", 1, "methods/1"),
    "has an unknown field": (FETCH.replace("purpose", "porpoise"), 4, "purpose"),
    "names a slot that no pattern has": (FETCH.replace("Search(thing)", "Search(ring)"), 3, "ring"),
    "refers to a step that is not there": (FETCH.replace("after: [find]", "after: [fynd]"), 3, "fynd"),
    "has a pattern without a verb": (FETCH.replace("<bring> {thing} for", "{thing} for"), 3, "verb"),
    "has slots side by side": (FETCH.replace("{thing} for {person}", "{thing} {person}"), 3, "between"),
    "has a slot twice": (FETCH.replace("{thing} for {person}", "{thing} for {thing}"), 3, "twice"),
    "leaves a bracket open": (FETCH.replace("{thing} for {person}", "{thing} [for {person}"), 3, "["),
    "has too many forms": (FETCH.replace(" for ", " for " + "[a] " * 8), 3, "64"),
    "has a call that is none": (FETCH.replace("Search(thing)", "Search thing"), 7, "Routine(slot)"),
    "has a condition that is none": (FETCH.replace("    steps", "    where: {thing: [blue]}\n    steps"), 3, "blue"),
}


@pytest.mark.parametrize(("text", "line", "said"), BROKEN.values(), ids=list(BROKEN))
def test_file_that(text: str, line: int, said: str) -> None:
    """The message names the file, a line at or above the fault, and what is wrong."""
    with pytest.raises(InputError) as refused:
        read_methods(text, "own.yaml")
    assert refused.value.file == "own.yaml"
    assert refused.value.line >= line
    assert said in str(refused.value)


def test_missing_file_and_a_method_in_two_files_are_refused(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="no such file"):
        load_methods([tmp_path / "none.yaml"])
    for name in ("one.yaml", "two.yaml"):
        (tmp_path / name).write_text(FETCH, encoding="utf-8")
    with pytest.raises(InputError, match="stands twice"):
        load_methods([tmp_path / "one.yaml", tmp_path / "two.yaml"])


def test_method_that_uses_an_unknown_routine_is_incomplete(tmp_path: Path) -> None:
    file = tmp_path / "own.yaml"
    file.write_text(FETCH.replace("Search(thing)", "Sniff(thing)"), encoding="utf-8")
    made = authored("Bring the ball for Anna", load_methods([file]))
    assert made.status == "incomplete"
    assert "Sniff" in made.reasons[0].message


def test_step_about_several_is_built_for_each_and_linked_one_by_one(tmp_path: Path) -> None:
    file = tmp_path / "own.yaml"
    file.write_text(FETCH, encoding="utf-8")
    made = authored("Bring the ball and the doll for Anna", load_methods([file]))
    assert made.tree is not None
    assert [node.label for node in made.tree.nodes[1:]] == [
        "Search(Ball)",
        "Search(Doll)",
        "ReachAndTransport(Ball, Anna)",
        "ReachAndTransport(Doll, Anna)",
    ]
    # Each thing is found before that thing is brought, and waits for no other: 2 links, not 4.
    assert [(a.first, a.second) for a in made.tree.links] == [
        ("search-ball", "reach-and-transport-ball-anna"),
        ("search-doll", "reach-and-transport-doll-anna"),
    ]
