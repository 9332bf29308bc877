"""The meaning of each field, read out of the NumPy docstrings, so that it is written once."""

from __future__ import annotations

import inspect
import re
from dataclasses import dataclass
from typing import Any

from missiontree.formats.per_class import per_class

_ROLE = re.compile(r":[a-z]+:`~?(?:[\w.]+\.)?(\w+)`")


@dataclass(frozen=True)
class Described:
    """
    What a docstring says.

    Parameters
    ----------
    summary
        Everything above the first section, as one paragraph per paragraph.
    fields
        Field name to its meaning.
    """

    summary: str
    fields: dict[str, str]


@per_class
def described(cls: type[Any]) -> Described:
    """Summary and fields of a class."""
    lines = inspect.cleandoc(cls.__doc__ or "").splitlines()
    heads = [index for index, line in enumerate(lines[1:]) if set(line) == {"-"} and lines[index].strip()]
    summary = _flow(lines[: heads[0]] if heads else lines)
    meanings: dict[str, str] = {}
    for head, end in zip(heads, [*heads, len(lines)][1:], strict=True):
        if lines[head].strip() == "Parameters":
            meanings = _parameters(lines[head + 2 : end])
    return Described(summary, meanings)


def _parameters(lines: list[str]) -> dict[str, str]:
    """Names stand at the margin, several of one meaning with commas between; meanings are indented."""
    meanings: dict[str, str] = {}
    names: list[str] = []
    body: list[str] = []
    for line in [*lines, "end"]:
        if line and not line.startswith(" "):
            meanings.update((name, _flow(body)) for name in names)
            names, body = [name.strip() for name in line.split(",")], []
        else:
            body.append(line.strip())
    return meanings


def _flow(lines: list[str]) -> str:
    """Lines as flowing text, paragraphs apart, the marks of reStructuredText made those of Markdown."""
    paragraphs = "\n".join(line.strip() for line in lines).strip().split("\n\n")
    text = "\n\n".join(" ".join(paragraph.split()) for paragraph in paragraphs)
    return _ROLE.sub(r"\1", text).replace("``", "`")
