"""
The tables of docs/reference/formats.md, out of the same docstrings and annotations that check the files.

``python -m missiontree.formats.reference docs/reference/formats.md`` puts them up to date; what stands between them is
written by hand.
"""

from __future__ import annotations

import json
import re
import sys
from pathlib import Path
from typing import Any

from missiontree.formats.annotation import ID_IN_WORDS, a_noun, hints_of, in_words, noun, required_of
from missiontree.formats.docstring import described
from missiontree.formats.document import KINDS
from missiontree.formats.not_enforced import FIELDS, GATE_WORDS, GATES
from missiontree.formats.plain import defaults_of, to_plain
from missiontree.formats.schema import values_in

_BLOCK = re.compile(r"(<!-- (fields: (\w+)|refused) -->\n).*?(<!-- end -->)", re.DOTALL)


def refreshed(page: str) -> str:
    """The page with every table as it should be."""
    classes = {cls.__name__: cls for kind in KINDS.values() for cls in values_in(kind)}

    def table(match: re.Match[str]) -> str:
        body = field_table(classes[match[3]]) if match[3] else refused_table(classes)
        return f"{match[1]}\n{body}\n{match[4]}"

    return _BLOCK.sub(table, page)


def field_table(cls: type[Any]) -> str:
    """A row for each field of a value: what is accepted, what holds without it, what it means."""
    rows = ["| Field | Accepted | Default | Meaning |", "|---|---|---|---|"]
    for name, default in defaults_of(cls):
        accepted = in_words(hints_of(cls)[name], _link).replace(ID_IN_WORDS, "an id")
        shown = "**required**" if name in required_of(cls) else _shown(default)
        rows.append(f"| `{name}` | {accepted} | {shown} | {_cell(described(cls).fields[name])} |")
    return "\n".join(rows) + "\n"


def refused_table(classes: dict[str, type[Any]]) -> str:
    """A row for each rule that is planned: which fields will belong to it, and are refused until then."""
    rules: dict[str, dict[str, list[str]]] = {}
    for owner, names in FIELDS.items():
        for name, rule in names.items():
            rules.setdefault(rule, {}).setdefault(f"`{name}`", []).append(noun(classes[owner]))
    rules[GATES]["gates " + ", ".join(f"`{word}`" for word in GATE_WORDS)] = ["mission node"]
    rows = ["| Rule | Refused |", "|---|---|"]
    for rule, fields in rules.items():
        by_owners: dict[str, list[str]] = {}
        for name, owners in fields.items():
            by_owners.setdefault(", ".join(owners), []).append(name)
        refused = (f"{', '.join(names)} ({owners})" for owners, names in by_owners.items())
        rows.append(f"| {rule} | {'; '.join(refused)} |")
    return "\n".join(rows) + "\n"


def _link(cls: type[Any]) -> str:
    return f"{a_noun(cls).split()[0]} [{noun(cls)}](#{noun(cls).replace(' ', '-')})"


def _shown(default: Any) -> str:
    plain = to_plain(default)
    if plain is None or plain in ("", [], {}):
        return "none"
    return f"`{json.dumps(plain)}`"


def _cell(text: str) -> str:
    return text.replace("\n\n", "<br>").replace("|", "\\|")


def main(path: Path) -> None:
    """Bring a page up to date."""
    path.write_text(refreshed(path.read_text(encoding="utf-8")), encoding="utf-8")


if __name__ == "__main__":
    main(Path(sys.argv[1]))
