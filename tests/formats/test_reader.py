"""The door for text: what it refuses, in which line, with which words; and that nothing gets past it or through it."""

import sys
import time

import pytest

from missiontree.errors import InputError
from missiontree.formats import source as source_module
from missiontree.formats.place import Path
from missiontree.formats.reader import parse
from missiontree.formats.yaml_reader import MAX_DEPTH
from tests.formats.test_scalar import VALUES, WORDS

# name, text, line, where, words of the message
REFUSED = [
    (
        "duplicate key",
        "a: 1\nb:\n  c: 1\n  d: 2\n  c: 3\n",
        5,
        "b",
        ["'c' stands twice", "lines 3 and 5", "each key once"],
    ),
    ("duplicate key, once quoted", "a: 1\n'a': 2\n", 2, "", ["'a' stands twice, in lines 1 and 2"]),
    ("duplicate number", "{1: a, 1: b}", 1, "", ["'1' stands twice"]),
    ("duplicate in JSON", '{"a": [{"x": 1,\n"y": 2,\n"x": 3}]}', 3, "a[0]", ["'x' stands twice, in lines 1 and 3"]),
    ("duplicate in JSON by escape", '{"a": 1,\n"\\u0061": 2}', 2, "", ["'a' stands twice, in lines 1 and 2"]),
    ("tab", "a:\n\t- b\n", 2, "", ["a tab stands", "Indent with spaces"]),
    ("unclosed bracket", "a: [1, 2\nb: 3\n", 2, "", ["accepted: YAML or JSON"]),
    ("unclosed quote", "a: 'b\n", 2, "", ["the file ends within quotes"]),
    ("colon in text", "a: b: c\n", 1, "", ["a ':' stands where none can be", "Quote text"]),
    ("bad indentation", "a:\n  b: 1\n c: 2\n", 3, "", ["the indentation does not fit"]),
    (
        "python tag",
        "a: !!python/object/apply:os.system [ls]\n",
        1,
        "a",
        ["python/object/apply:os.system", "not accepted"],
    ),
    ("own tag", "a: 1\nb: !secret x\n", 2, "b", ["the tag '!secret' is not accepted"]),
    ("tag that lies", "a: !!int many\n", 1, "a", ["tag:yaml.org,2002:int"]),
    ("anchor", "a: &x 1\n", 1, "a", ["'&x' is a YAML anchor", "needs quotes"]),
    ("alias", "a: 1\nb: *x\n", 2, "b", ["'*x' is a YAML alias", "needs quotes"]),
    ("merge key", "a:\n  <<: {b: 1}\n", 2, "a", ["'<<' is a YAML merge key"]),
    ("two documents", "a: 1\n---\nb: 2\n", 2, "", ["a second document", "one document per file"]),
    ("list as key", "? [a]\n: b\n", 1, "", ["a key is a list or a mapping"]),
    ("NaN", "a:\n  - .nan\n", 2, "a[0]", [".nan", "a finite number"]),
    ("infinity", "a: -.inf\n", 1, "a", ["-.inf", "a finite number"]),
    ("too large a number", "a: 1e999\n", 1, "a", ["a number is too large"]),
    ("NaN in JSON", '{"a": "NaN",\n"b": NaN}', 2, "", ["NaN is not a number"]),
    ("number of many digits in JSON", '{"a": ' + "9" * 5000 + "}", 0, "", ["too many digits"]),
    ("NUL", "a: b\nc: \0\n", 2, "", ["a NUL character (U+0000)"]),
    ("escape character", "a: \x1b[31m\n", 1, "", ["U+001B", "without control characters"]),
    ("escape character, escaped", 'a: 1\nb: "\\e[31m"\n', 2, "b", ["U+001B"]),
    ("escape character as key", '"\\e": 1\n', 1, "", ["U+001B"]),
    ("escape character in JSON", '{"a": 1,\n"b": ["\\u001b"]}', 2, "b[0]", ["U+001B"]),
    ("half a character in JSON", '{"a": "\\ud800"}', 1, "a", ["U+D800"]),
    ("empty", "", 0, "", ["the file is empty", "a YAML or JSON document"]),
    ("white space", " \n\n", 0, "", ["the file is empty"]),
]


@pytest.mark.parametrize(
    ("text", "line", "where", "words"), [case[1:] for case in REFUSED], ids=[case[0] for case in REFUSED]
)
def test_refused(text: str, line: int, where: str, words: list[str]) -> None:
    with pytest.raises(InputError) as caught:
        parse(text, "f.yaml")
    assert (caught.value.file, caught.value.line, caught.value.where) == ("f.yaml", line, where)
    for word in words:
        assert word in str(caught.value)


def test_json_files_must_be_json() -> None:
    with pytest.raises(InputError, match="not JSON here") as caught:
        parse('{"a": 1,\n"b": 2,}', "f.json")
    assert caught.value.line == 2
    assert parse('{"a": 1,\n"b": 2,}', "f.yaml").data == {"a": 1, "b": 2}  # a last comma is fine in YAML


def test_lines_are_known_of_everything() -> None:
    yaml = "a:\n  - b\n  - c:\n      d\n# no\ne: 1\n"
    json = '{"a":\n  ["b",\n  {"c":\n "d"}],\n\n"e": 1}'
    places: list[tuple[Path, int]] = [
        ((), 1),
        (("a",), 1),
        (("a", 0), 2),
        (("a", 1), 3),
        (("a", 1, "c"), 3),
        (("e",), 6),
        (("a", 1, "zz"), 3),
    ]
    for text in (yaml, json):
        parsed = parse(text)
        assert parsed.data == {"a": ["b", {"c": "d"}], "e": 1}
        assert [(path, parsed.line_of(path)) for path, _ in places] == places


def test_alias_bomb_is_refused_before_it_grows() -> None:
    lines = ["a0: &a0 [x, x]"] + [f"a{n}: &a{n} [{', '.join([f'*a{n - 1}'] * 9)}]" for n in range(1, 30)]
    with pytest.raises(InputError, match="anchor"):
        parse("\n".join(lines))


DEEP = 100_000


@pytest.mark.parametrize("suffix", ["json", "yaml"])
@pytest.mark.parametrize(
    "text",
    ["[" * DEEP + "]" * DEEP, "[" * DEEP, '{"a":' * DEEP + "1" + "}" * DEEP, "- " * DEEP, "{a: " * DEEP, "? " * DEEP],
    ids=["lists", "open lists", "mappings", "dashes", "open mappings", "keys"],
)
def test_depth_is_refused_and_never_exhausts_the_stack(text: str, suffix: str) -> None:
    with pytest.raises(InputError):
        parse(text, f"f.{suffix}")


def test_the_depth_accepted_is_the_depth_said() -> None:
    for text in ("[" * MAX_DEPTH + "]" * MAX_DEPTH, "- " * (MAX_DEPTH - 1) + "[]"):
        parse(text)
    for text in ("[" * (MAX_DEPTH + 1) + "]" * (MAX_DEPTH + 1), "- " * MAX_DEPTH + "[]"):
        with pytest.raises(InputError, match="nested too deep"):
            parse(text)


@pytest.mark.parametrize(
    "letter", ["a", "{", "[", "*", "&", "!", "'", '"', "%", "-", ":", "? ", "a: ", "\n", "\t", "😀"]
)
def test_a_million_characters_of_garbage_end_soon(letter: str) -> None:
    started = time.process_time()
    outcome = _outcome(letter * (1_000_000 // len(letter)))
    assert time.process_time() - started < 20  # quadratic work would take hours
    assert not isinstance(outcome, InputError) or len(str(outcome)) < 1000, "messages stay short, whatever was found"


def test_size_is_capped(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("missiontree.formats.reader.MAX_YAML_BYTES", 10)
    with pytest.raises(InputError, match="too large") as caught:
        parse("abc: [1, 2]")
    assert caught.value.accepted == "at most 10 bytes"
    assert source_module.max_bytes("plan.json") > source_module.max_bytes("plan.yaml")


def test_both_parsers_of_pyyaml_give_the_same(monkeypatch: pytest.MonkeyPatch) -> None:
    """Where PyYAML came without its C parser the pure one is used; refusals may be worded otherwise, at the same line."""
    texts = [case[1] for case in REFUSED] + [
        f"a: {word}\nb: [{word or 'x'}, 'q']" for word in (*WORDS, *(v for v, _ in VALUES))
    ]
    fast = [_gist(text) for text in texts]
    monkeypatch.delattr(sys.modules["yaml"], "CSafeLoader", raising=False)
    assert [_gist(text) for text in texts] == fast


def _gist(text: str) -> object:
    outcome = _outcome(text)
    return (outcome.line, outcome.where) if isinstance(outcome, InputError) else outcome


def _outcome(text: str) -> object:
    try:
        return parse(text, "f.yaml").data
    except InputError as error:
        return error
