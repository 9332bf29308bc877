"""Fields whose rule is planned are refused, and say so."""

import pytest

from missiontree.errors import NotEnforcedError
from missiontree.formats.annotation import hints_of
from missiontree.formats.document import KINDS, read_text
from missiontree.formats.not_enforced import FIELDS
from missiontree.formats.schema import values_in

PLANNED = [
    (
        "scene",
        "roads:\n  lifts:\n  - {id: l, stops: [a, b], ride_s: 1, capacity: 2}\n",
        3,
        "roads.lifts[0].capacity",
        "capacities of roads",
    ),
    ("tree", "objective: x\nnodes:\n- {id: a, label: a, windows: 5}\n", 3, "nodes[0].windows", "windows"),
    (
        "tree",
        "objective: x\nnodes:\n- {id: a, label: a, gate: k_of_n, children: [b]}\n",
        3,
        "nodes[0].gate",
        "gates other than",
    ),
    ("mission", "mission: Go\nwindow: 60\n", 2, "window", "windows"),
]


@pytest.mark.parametrize(("kind", "text", "line", "where", "rule"), PLANNED)
def test_fields_that_nobody_enforces_yet_are_refused(kind: str, text: str, line: int, where: str, rule: str) -> None:
    with pytest.raises(NotEnforcedError) as caught:
        read_text(text, kind, "f.yaml")
    assert (caught.value.line, caught.value.where) == (line, where)
    assert rule in str(caught.value)
    assert "no stage enforces it yet" in str(caught.value)
    assert "Remove it" in caught.value.hint


def test_no_field_is_both_planned_and_there() -> None:
    classes = {cls.__name__: cls for kind in KINDS.values() for cls in values_in(kind)}
    for name, planned in FIELDS.items():
        assert not set(planned) & set(hints_of(classes[name])), name
