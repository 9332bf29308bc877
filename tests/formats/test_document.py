"""Documents: what is written reads back the same, and what is not such a document is refused with words."""

import json
from pathlib import Path
from typing import Any

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from missiontree.errors import InputError
from missiontree.formats.document import KINDS, read_as, read_file, read_text, write_text
from missiontree.mission.estimate import Weights
from missiontree.mission.fleet import Fleet, RobotType
from tests.formats.strategies import fleets, grounded_trees, mission_trees, routine_files, scenes
from tests.formats.whole_plan import whole_plan

PLAN = whole_plan()
assert PLAN.grounding is not None
assert PLAN.ranking is not None
PARTS: list[tuple[str, Any]] = [
    ("plan", PLAN),
    ("brief", PLAN.brief),
    ("fleet", PLAN.brief.fleet),
    ("scene", PLAN.brief.scene),
    ("tree", PLAN.tree),
    ("grounding", PLAN.grounding),
    ("grounded", PLAN.grounding.tree),
    ("ranking", PLAN.ranking),
    ("alternative", PLAN.ranking.alternatives[0]),
    ("schedule", PLAN.schedules[0]),
]


@pytest.mark.parametrize(("kind", "value"), PARTS, ids=[kind for kind, _ in PARTS])
def test_every_part_of_a_plan_reads_back_equal_and_writes_the_same_bytes(kind: str, value: Any) -> None:
    text = write_text(value, kind)
    again = read_text(text, kind)
    assert again == value
    assert write_text(again, kind) == text
    assert text.startswith(f'{{\n  "format": "{kind}/1",\n')


drawn = st.one_of(
    st.tuples(st.just("fleet"), fleets()),
    st.tuples(st.just("scene"), scenes()),
    st.tuples(st.just("routines"), routine_files()),
    st.tuples(st.just("tree"), mission_trees()),
    st.tuples(st.just("grounded"), grounded_trees()),
)


@settings(max_examples=120, deadline=None, suppress_health_check=[HealthCheck.too_slow, HealthCheck.data_too_large])
@given(drawn)
def test_drawn_values_read_back_equal(pair: tuple[str, Any]) -> None:
    """As JSON and, since JSON is YAML, through the YAML reader too."""
    kind, value = pair
    text = write_text(value, kind)
    assert read_text(text, kind, "drawn.json") == value
    # A leading comment is YAML and not JSON, so this takes the other road.
    assert read_text(f"# a comment\n{text}", kind, "drawn.yaml") == value


def test_defaults_are_left_out_and_short_forms_used() -> None:
    fleet = Fleet((RobotType(id="cart", capabilities={"carry": 1.0}, count=2),))
    # label is the id, the capability only a quality, 1.0 a whole number
    assert json.loads(write_text(fleet, "fleet")) == {
        "format": "fleet/1",
        "types": [{"id": "cart", "capabilities": {"carry": 1}, "count": 2}],
    }


def test_equal_values_give_equal_bytes_whether_built_with_ints_or_floats() -> None:
    whole, real = (
        Fleet((RobotType(id="a", limits={"x": 3}, count=1),)),
        Fleet((RobotType(id="a", limits={"x": 3.0}, count=1),)),
    )
    assert write_text(whole, "fleet") == write_text(real, "fleet")


def test_what_users_wrote_keeps_its_order() -> None:
    text = "types: [{id: a, count: 1, limits: {z: 1, a: 2, m: 3}}]"
    assert list(read_text(text, "fleet").types[0].limits) == ["z", "a", "m"]
    assert '"limits": {"z": 1, "a": 2, "m": 3}' in write_text(read_text(text, "fleet"), "fleet")


def test_a_value_is_not_written_as_another_kind() -> None:
    with pytest.raises(TypeError, match="Weights is not a fleet"):
        write_text(Weights(), "fleet")


def test_documents_of_other_kinds_are_read_by_the_same_door() -> None:
    assert read_as("format: weights/1\nbeta: 0.5", "weights", Weights) == Weights(beta=0.5)


FLEET = "types: [{id: a, count: 1}]"
FORMATS = [
    ("format: scene/1\nentities: []", 1, "format", ["this is a scene file, a fleet file was expected"]),
    (f"{FLEET}\nformat: fleet/2", 2, "format", ["version 2 of fleet files is not known", "accepted: fleet/1"]),
    (f"format: fleeet/1\n{FLEET}", 1, "format", ["'fleeet' is not a kind", "Did you mean 'fleet'?"]),
    (f"format: 1\n{FLEET}", 1, "format", ["'1' is not the format", "fleet/1"]),
    (f"format: [1]\n{FLEET}", 1, "format", ["is not the format", "fleet/1"]),
    ("entities:\n- id: tom", 1, "entities", ["this looks like a scene file, a fleet file was expected"]),
    ("mission: Find Tom", 1, "mission", ["this looks like a mission file"]),
]


@pytest.mark.parametrize(("text", "line", "where", "words"), FORMATS)
def test_the_wrong_document_is_named(text: str, line: int, where: str, words: list[str]) -> None:
    with pytest.raises(InputError) as caught:
        read_text(text, "fleet", "f.yaml")
    assert (caught.value.file, caught.value.line, caught.value.where) == ("f.yaml", line, where)
    for word in words:
        assert word in str(caught.value)


def test_the_format_line_and_the_schema_line_are_optional() -> None:
    assert read_text(f"$schema: ./fleet.schema.json\nformat: fleet/1\n{FLEET}", "fleet") == read_text(FLEET, "fleet")


def test_files_are_read_and_missing_ones_named(tmp_path: Path) -> None:
    (tmp_path / "fleet.yaml").write_bytes(b"\xef\xbb\xbf" + FLEET.encode())  # a byte order mark is no fault
    assert read_file(tmp_path / "fleet.yaml", "fleet").types[0].id == "a"
    with pytest.raises(InputError, match="there is no such file") as caught:
        read_file(tmp_path / "flet.yaml", "fleet")
    assert caught.value.file.endswith("flet.yaml")
    with pytest.raises(InputError, match="this is a folder"):
        read_file(tmp_path, "fleet")


@settings(max_examples=300, deadline=None)
@given(st.text() | st.text("{}[]:,-\"'&*!|>#%@`?~ \n\tabe01.\\ux"), st.sampled_from(sorted(KINDS)))
def test_any_text_is_a_value_or_a_refusal(text: str, kind: str) -> None:
    _value_or_refusal(text, kind)


plain = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats() | st.text(max_size=5),
    lambda inner: (
        st.lists(inner, max_size=3) | st.dictionaries(st.text(max_size=5) | st.sampled_from(["id", "types"]), inner)
    ),
    max_leaves=8,
)


@settings(max_examples=200, deadline=None)
@given(plain, st.sampled_from(sorted(KINDS)))
def test_any_json_is_a_value_or_a_refusal(data: Any, kind: str) -> None:
    _value_or_refusal(json.dumps(data), kind)


@settings(max_examples=300, deadline=None)
@given(st.data())
def test_a_damaged_plan_is_a_value_or_a_refusal(data: st.DataObject) -> None:
    """Any one thing in a good document replaced by anything."""
    plan = json.loads(write_text(PLAN, "plan"))
    node, parent, key = plan, plan, "format"
    while isinstance(node, dict | list) and node and (node is plan or data.draw(st.booleans())):
        key = data.draw(st.sampled_from(sorted(node) if isinstance(node, dict) else range(len(node))))
        parent, node = node, node[key]
    parent[key] = data.draw(plain)
    _value_or_refusal(json.dumps(plan), "plan")


def _value_or_refusal(text: str, kind: str) -> None:
    outcome = _outcome(text, kind)
    if isinstance(outcome, InputError):
        assert outcome.file == "f"
        assert "pydantic" not in str(outcome).lower()
        assert str(outcome).replace("\n", "").isprintable(), "a message must not carry control characters"
    else:
        assert isinstance(outcome, KINDS[kind])


def _outcome(text: str, kind: str) -> Any:
    try:
        return read_text(text, kind, "f")
    except InputError as error:
        return error


@settings(max_examples=100, deadline=None)
@given(raw=st.binary())
def test_any_bytes_are_a_value_or_a_refusal(raw: bytes, tmp_path_factory: pytest.TempPathFactory) -> None:
    path = tmp_path_factory.getbasetemp() / "bytes.yaml"
    path.write_bytes(raw)
    with pytest.raises(InputError):  # no fleet is as short as what hypothesis finds by chance
        read_file(path, "fleet")
