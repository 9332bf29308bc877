"""What is wrong with text that is not YAML, said to somebody who does not know the words of a YAML parser."""

from __future__ import annotations

import yaml

from missiontree.errors import InputError
from missiontree.formats.place import quoted

_TAB = "a tab"

# What the parser says (both of PyYAML's), what is meant, what to do.
_KNOWN = (
    (_TAB, "a tab stands where spaces are expected", "Indent with spaces."),
    ("mapping values are not allowed", "a ':' stands where none can be", "Quote text that holds ': '."),
    ("expected ':'", "a key without ':'", "Write 'key: value', with a space behind the colon."),
    ("expected <block end>", "the indentation does not fit the lines above", "Align the keys of one mapping."),
    ("expected key", "the indentation does not fit the lines above", "Align the keys of one mapping."),
    ("expected '-' indicator", "the indentation does not fit the lines above", "Align the entries of one list."),
    ("block sequence entries", "a '-' stands where no list can begin", "Begin the list in a line of its own."),
    ("undefined alias", "text begins with '*', which is YAML for an alias", "Quote text that starts with '*'."),
    ("alias", "text begins with '*', which is YAML for an alias", "Quote text that starts with '*'."),
    ("anchor", "text begins with '&', which is YAML for an anchor", "Quote text that starts with '&'."),
    ("undefined tag handle", "text begins with '!', which is YAML for a tag", "Quote text that starts with '!'."),
    ("tag", "text begins with '!', which is YAML for a tag", "Quote text that starts with '!'."),
    ("',' or '}'", "a '{' is not closed", "Close it with '}', or quote the text."),
    ("',' or ']'", "a '[' is not closed", "Close it with ']', or quote the text."),
    ("end of stream", "the file ends within quotes or brackets", "Close them."),
    ("cannot start any token", "a character stands where none of its kind can", "Quote the text."),
    ("escape", "a backslash sequence in double quotes is unknown", "Use single quotes, or double the backslash."),
    ("document start", "a second document begins, or a bracket is closed twice", "Keep one document per file."),
)
_UNKNOWN = ["the text is not YAML here", "Check quotes, brackets and indentation of this line."]


def in_words(error: yaml.YAMLError, source: str, text: str) -> InputError:
    """The refusal of text that is not YAML, at the line where it ceases to be."""
    mark = getattr(error, "problem_mark", None) or getattr(error, "context_mark", None)
    line = min(mark.line + 1, text.count("\n") + 1) if mark is not None else 1
    said = str(getattr(error, "problem", None) or getattr(error, "reason", None) or "")
    lines = text.split("\n")
    there = lines[line - 1]
    if "\t" in there[: len(there) - len(there.lstrip())]:
        said = _TAB
    meaning, hint = next((words for part, *words in _KNOWN if part in said), _UNKNOWN)
    message = f"{meaning}, in {quoted(there.strip())}" if there.strip() else meaning
    return InputError(message, file=source, line=line, accepted="YAML or JSON", hint=hint)
