"""What a person reads when a file does not describe what it should: line, place, what was found, what is accepted."""

import re

import pytest

from missiontree.errors import InputError
from missiontree.formats.document import read_text

HEAD = "types:\n- id: cart\n  count: 2\n"  # three lines, a sound fleet

# name, kind, text, line, where, words of the message
REFUSED = [
    (
        "misspelt key",
        "fleet",
        HEAD + "  capabilites: {}\n",
        4,
        "types[0].capabilites",
        ["a robot type has no field", "Did you mean 'capabilities'?"],
    ),
    (
        "key without unit",
        "scene",
        "entities:\n- id: tom\n  mass: 3\n",
        3,
        "entities[0].mass",
        ["an entity has no field 'mass'", "'mass_kg'"],
    ),
    (
        "misspelt required key",
        "fleet",
        "types:\n- idd: cart\n  count: 2\n",
        2,
        "types[0].idd",
        ["no field 'idd'", "Did you mean 'id'?"],
    ),
    (
        "missing key",
        "fleet",
        "types:\n- count: 2\n",
        2,
        "types[0]",
        ["a robot type needs the field 'id', which is missing", "an id"],
    ),
    (
        "id with a space",
        "fleet",
        "types:\n- id: my cart\n  count: 1\n",
        2,
        "types[0].id",
        ["'my cart'", "an id (a letter", "Free text"],
    ),
    ("number as id", "fleet", "types:\n- id: 12\n  count: 1\n", 2, "types[0].id", ["found 12", "an id (a letter"]),
    (
        "text as number",
        "fleet",
        HEAD + "  limits:\n    payload_kg: '3'\n",
        5,
        "types[0].limits.payload_kg",
        ["'3' (text)", "without quotes"],
    ),
    (
        "unit in value",
        "fleet",
        HEAD + "  limits: {payload_kg: 3 kg}\n",
        4,
        "types[0].limits.payload_kg",
        ["'3 kg'", "Write the number alone"],
    ),
    (
        "negative speed",
        "fleet",
        HEAD + "  limits:\n    max_speed_mps: -1\n",
        5,
        "types[0].limits.max_speed_mps",
        ["found -1", "a number, at least 0"],
    ),
    (
        "no speed",
        "fleet",
        HEAD + "  limits:\n    max_speed_mps: 0\n",
        2,
        "types[0].id",
        ["max_speed_mps must be above 0"],
    ),
    (
        "half a robot",
        "fleet",
        "types:\n- id: a\n  count: 1.5\n",
        3,
        "types[0].count",
        ["found 1.5", "a whole number, at least 1"],
    ),
    (
        "no robot",
        "fleet",
        "types:\n- id: a\n  count: 0\n",
        3,
        "types[0].count",
        ["found 0", "a whole number, at least 1"],
    ),
    (
        "null",
        "fleet",
        HEAD + "  label:\n",
        4,
        "types[0].label",
        ["nothing (null)", "Give it a value, or remove the key"],
    ),
    (
        "truth as text",
        "fleet",
        HEAD + "  label: true\n",
        4,
        "types[0].label",
        ["true (a truth value)", "Put it in quotes: 'true'"],
    ),
    ("no as truth", "mission", "mission: Go\ncheck_kinds: no\n", 2, "check_kinds", ["'no' (text)", "true or false"]),
    (
        "capability as word",
        "fleet",
        HEAD + "  capabilities: {carry: good}\n",
        4,
        "types[0].capabilities.carry",
        ["'good'", "a number, at least 0, or a mapping with the fields quality, duration, cost"],
    ),
    (
        "capability below 0",
        "fleet",
        HEAD + "  capabilities: {carry: -1}\n",
        4,
        "types[0].capabilities.carry",
        ["found -1"],
    ),
    (
        "capability misspelt",
        "fleet",
        HEAD + "  capabilities:\n    carry:\n      qualty: 1\n",
        6,
        "types[0].capabilities.carry.qualty",
        ["Did you mean 'quality'?"],
    ),
    (
        "capability, deep",
        "fleet",
        HEAD + "  capabilities:\n    carry: {quality: 1, cost: {per_m: x}}\n",
        5,
        "types[0].capabilities.carry.cost.per_m",
        ["'x'", "at least 0"],
    ),
    (
        "capability name",
        "fleet",
        HEAD + "  capabilities: {heavy lifting: 1}\n",
        4,
        "types[0].capabilities['heavy lifting']",
        ["the key 'heavy lifting'", "an id"],
    ),
    (
        "word for list",
        "fleet",
        HEAD + "  zones: west\n",
        4,
        "types[0].zones",
        ["'west'", "a list, each entry an id", "square brackets"],
    ),
    ("list for mapping", "fleet", "- id: a\n", 1, "", ["a list of 1", "a mapping with the fields types, label"]),
    (
        "word for position",
        "fleet",
        HEAD + "  position: here\n",
        4,
        "types[0].position",
        ["'here'", "x_m, y_m, floor, frame", "{x_m: ..., y_m: ...}"],
    ),
    ("list for position", "fleet", HEAD + "  position: [1, 2]\n", 4, "types[0].position", ["a list of 2", "x_m, y_m"]),
    (
        "half a corner",
        "scene",
        "keep_outs:\n- id: hole\n  area:\n    corners: [[0, 0], [1, 0], [1]]\n",
        4,
        "keep_outs[0].area.corners[2]",
        ["too short"],
    ),
    (
        "bad choice",
        "tree",
        "objective: x\nnodes:\n- {id: a, label: a, gate: nand, children: [b]}\n",
        3,
        "nodes[0].gate",
        ["'nand'", "one of 'and', 'xor'", "Did you mean 'and'?"],
    ),
    ("twice the id", "fleet", HEAD + "- id: cart\n  count: 1\n", 4, "types[1].id", ["robot type 'cart' stands twice"]),
    ("no types", "fleet", "types: []\n", 1, "", ["at least one robot type"]),
    (
        "both",
        "fleet",
        "label: x\n" + HEAD + "  robots: [{id: r}]\n",
        3,
        "types[0].id",
        ["either a count or a list of robots"],
    ),
    (
        "dangling place",
        "scene",
        "entities:\n- id: tom\n  place: kitchn\n",
        3,
        "entities[0].place",
        ["'kitchn', which the scene does not have"],
    ),
    (
        "dangling road",
        "scene",
        "roads:\n  roads:\n  - ends: [a, b]\n",
        3,
        "roads.roads[0].ends[0]",
        ["a road ends at 'a'"],
    ),
    (
        "unknown kind",
        "scene",
        "entities:\n- id: tom\n  kind: cat\n",
        3,
        "entities[0].kind",
        ["kind 'cat' is not known", "declare others under kinds"],
    ),
    (
        "unknown argument",
        "routines",
        "routines:\n- id: Do\n  purpose: Do {it}\n  arguments: [{name: agent, kinds: [person]}]\n  parts: [{routine: Search}]\n",
        3,
        "routines[0].purpose",
        ["speaks of 'it'"],
    ),
    ("no mission", "mission", "k: 2\n", 1, "", ["needs a mission in words"]),
    (
        "JSON",
        "fleet",
        '{"types": [\n{"id": "a",\n"count": "2"}]}',
        3,
        "types[0].count",
        ["'2' (text)", "without quotes"],
    ),
]


@pytest.mark.parametrize(
    ("kind", "text", "line", "where", "words"), [case[1:] for case in REFUSED], ids=[case[0] for case in REFUSED]
)
def test_refused(kind: str, text: str, line: int, where: str, words: list[str]) -> None:
    with pytest.raises(InputError) as caught:
        read_text(text, kind, "f.yaml")
    message = str(caught.value)
    assert (caught.value.line, caught.value.where) == (line, where), message
    assert message.startswith(f"f.yaml:{line}: ")
    for word in words:
        assert word in message
    assert not re.search(r"https?:|pydantic|[Ii]nput should|Value error|dataclass|Capability", message)


def test_long_and_strange_words_are_shown_short_and_harmless() -> None:
    with pytest.raises(InputError) as caught:
        read_text(HEAD + "  label: [" + "x" * 10_000 + "]\n  \u202eevil: 1\n", "fleet")
    assert len(str(caught.value)) < 500
    with pytest.raises(InputError) as caught:
        read_text(HEAD + "  \u202e" + "evil" * 1000 + ": 1\n", "fleet")
    assert "\u202e" not in str(caught.value)
    assert len(str(caught.value)) < 500
