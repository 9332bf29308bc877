"""Values are frozen, checked at birth, and say what is wrong in words."""

from __future__ import annotations

import pickle
from dataclasses import FrozenInstanceError, dataclass, field
from types import MappingProxyType
from typing import Annotated

import pytest
from annotated_types import Ge
from hypothesis import given
from hypothesis import strategies as st

from missiontree.mission.frozen_map import FrozenMap
from missiontree.mission.value import ID_PATTERN, Id, Index, NonNegative, Positive, Value, require_unique


@dataclass(frozen=True, slots=True)
class Sample(Value):
    """One field of every kind of constraint."""

    name: Id
    weight: NonNegative = 0.0
    speed: Positive | None = None
    places: tuple[Id, ...] = ()
    loads: dict[Id, NonNegative] = field(default_factory=dict)
    index: Index = 0
    level: Annotated[int, Ge(-3)] = 0
    note: str = ""


def test_lists_and_dicts_become_immutable() -> None:
    value = Sample("a", places=["b", "c"], loads={"x": 1.0})  # type: ignore[arg-type]
    assert value.places == ("b", "c")
    assert isinstance(value.loads, FrozenMap)
    assert hash(value) == hash(Sample("a", places=("b", "c"), loads={"x": 1.0}))
    with pytest.raises(FrozenInstanceError):
        value.name = "z"


@pytest.mark.parametrize(
    ("fields", "words"),
    [
        ({"name": "two words"}, ["name must be an id", "'two words'", "label"]),
        ({"name": ""}, ["name must be an id"]),
        ({"name": "a" * 65}, ["up to 63"]),
        ({"name": "größe"}, ["name must be an id"]),
        ({"name": "a\n"}, ["name must be an id"]),
        ({"name": 7}, ["name must be an id", "7"]),
        ({"weight": -1}, ["weight must be at least 0", "-1"]),
        ({"weight": float("nan")}, ["weight must be a finite number"]),
        ({"weight": float("inf")}, ["weight must be a finite number"]),
        ({"weight": "3"}, ["weight must be a finite number", "'3'"]),
        ({"weight": True}, ["weight must be a finite number"]),
        ({"speed": 0}, ["speed must be above 0"]),
        ({"places": "abc"}, ["places must be a list"]),
        ({"places": ["ok", "not ok"]}, ["places[1] must be an id"]),
        ({"loads": {"bad key": 1}}, ["key of loads must be an id"]),
        ({"loads": {"x": -2}}, ["loads.x must be at least 0"]),
        ({"loads": [1]}, ["loads must be a mapping"]),
        ({"loads": {"x": float("inf")}}, ["loads.x must be a finite number"]),
        ({"loads": {"y": True}}, ["loads.y must be a finite number"]),
        ({"speed": True}, ["speed must be a finite number"]),
        ({"index": 2.0}, ["index must be a whole number"]),
        ({"places": ["ok", 3]}, ["places[1] must be an id"]),
        ({"level": -4}, ["level must be at least -3"]),
        ({"level": 1.5}, ["level must be a whole number", "1.5"]),
        ({"note": 3}, ["note must be text", "3"]),
    ],
)
def test_a_broken_constraint_names_field_and_value(fields: dict[str, object], words: list[str]) -> None:
    with pytest.raises(ValueError, match=r".") as caught:
        Sample(**{"name": "a", **fields})  # type: ignore[arg-type]
    for word in words:
        assert word in str(caught.value)


@given(st.from_regex(ID_PATTERN, fullmatch=True))
def test_every_string_of_the_pattern_is_an_id(name: str) -> None:
    assert Sample(name).name == name


@given(st.dictionaries(st.text(), st.integers()))
def test_a_frozen_map_equals_its_mapping_and_survives_copies(items: dict[str, int]) -> None:
    frozen = FrozenMap(items)
    assert frozen == items
    assert list(frozen) == list(items)
    assert hash(frozen) == hash(FrozenMap(dict(reversed(items.items()))))
    assert pickle.loads(pickle.dumps(frozen)) == frozen  # noqa: S301 - our own bytes
    with pytest.raises(AttributeError):
        frozen.anything = 1


@given(st.dictionaries(st.text(), st.integers()), st.dictionaries(st.text(), st.integers()))
def test_a_frozen_map_answers_as_a_dict_does(items: dict[str, int], others: dict[str, int]) -> None:
    frozen, other = FrozenMap(items), MappingProxyType(others)
    assert (list(frozen.keys()), list(frozen.values())) == (list(items.keys()), list(items.values()))
    assert list(frozen.items()) == list(items.items())
    assert [name in frozen for name in others] == [name in items for name in others]
    assert (frozen == other, frozen == FrozenMap(others)) == (items == others, items == others)
    assert frozen != list(items)


def test_a_repeated_id_is_named() -> None:
    with pytest.raises(ValueError, match="robot 'b' stands twice"):
        require_unique("robot", ("a", "b", "b"))
