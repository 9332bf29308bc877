"""The schemas accept what the loader accepts, refuse what it refuses for its shape, and explain every field."""

import json
from typing import Any

import pytest
from hypothesis import HealthCheck, given, settings
from jsonschema import Draft202012Validator

from missiontree.errors import InputError
from missiontree.formats.annotation import hints_of
from missiontree.formats.docstring import described
from missiontree.formats.document import KINDS, json_schema, read_text, write_text
from missiontree.formats.reader import parse
from missiontree.formats.schema import values_in
from tests.formats.test_document import PARTS, drawn
from tests.formats.test_fault import REFUSED as MISSHAPEN
from tests.formats.test_not_enforced import PLANNED

VALIDATORS = {kind: Draft202012Validator(json_schema(kind)) for kind in KINDS}
CLASSES = {cls.__name__: cls for kind in KINDS.values() for cls in values_in(kind)}

# What spans fields, or refers to something, no schema can see.
SPANNING = {"no speed", "twice the id", "no types", "both", "dangling place", "dangling road", "unknown kind"}
SPANNING |= {"unknown argument", "no mission"}


@pytest.mark.parametrize("kind", KINDS)
def test_schemas_are_schemas_and_say_what_they_are_of(kind: str) -> None:
    schema = json_schema(kind)
    Draft202012Validator.check_schema(schema)
    assert schema["$schema"] == "https://json-schema.org/draft/2020-12/schema"
    assert schema["title"] == f"missiontree {kind} file, version 1"
    assert schema["properties"]["format"]["const"] == f"{kind}/1"
    references = [text for text in json.dumps(schema).split('"') if text.startswith("#")]
    assert "$id" not in schema
    assert {reference.rpartition("/")[0] for reference in references} <= {"#/$defs"}


@pytest.mark.parametrize("name", sorted(CLASSES))
def test_every_field_is_explained(name: str) -> None:
    """So that editors show the meaning; a docstring that forgets a field, or keeps one that is gone, fails here."""
    assert set(described(CLASSES[name]).fields) == set(hints_of(CLASSES[name]))
    assert described(CLASSES[name]).summary


def test_descriptions_stand_at_the_fields() -> None:
    schema = json_schema("fleet")
    speed = schema["$defs"]["RobotType"]["properties"]["uses_per_m"]
    assert speed["description"] == "What a metre of travel uses of each budget."
    assert schema["$defs"]["RobotType"]["description"] == "Robots that are alike."


@pytest.mark.parametrize(("kind", "value"), PARTS, ids=[kind for kind, _ in PARTS])
def test_every_part_of_a_plan_fits_its_schema(kind: str, value: Any) -> None:
    VALIDATORS[kind].validate(json.loads(write_text(value, kind)))


@settings(max_examples=40, deadline=None, suppress_health_check=[HealthCheck.too_slow, HealthCheck.data_too_large])
@given(drawn)
def test_drawn_values_fit_their_schema(pair: tuple[str, Any]) -> None:
    kind, value = pair
    VALIDATORS[kind].validate(json.loads(write_text(value, kind)))


SHAPES = [(case[0], case[1], case[2]) for case in MISSHAPEN if case[0] not in SPANNING]
SHAPES += [(rule, kind, text) for kind, text, _, _, rule in PLANNED]


@pytest.mark.parametrize(("kind", "text"), [case[1:] for case in SHAPES], ids=[case[0] for case in SHAPES])
def test_what_the_loader_refuses_for_its_shape_the_schema_refuses(kind: str, text: str) -> None:
    with pytest.raises(InputError):
        read_text(text, kind)
    assert not VALIDATORS[kind].is_valid(parse(text).data)


def test_only_what_spans_fields_is_left_to_the_loader() -> None:
    for name, kind, text, *_ in MISSHAPEN:
        assert VALIDATORS[kind].is_valid(parse(text).data) == (name in SPANNING), name
