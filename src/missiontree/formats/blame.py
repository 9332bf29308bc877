"""Which line a value's own complaint is about: a value knows what is wrong in it, not where that was written."""

from __future__ import annotations

import re
from typing import Any

from missiontree.formats.place import Path

_QUOTED = re.compile(r"'([^']+)'")


def culprit(message: str, data: Any, path: Path) -> Path:
    """
    The place below ``path`` that a message speaks of.

    That is where the last name that its first clause quotes was written last: the second of two equal ids, the name that
    nothing answers to. If no name is found it is ``path`` itself.
    """
    names = _QUOTED.findall(message.partition(";")[0])
    if not names:
        return path
    written = _last_places(data, path, set(names))
    return next((written[name] for name in reversed(names) if name in written), path)


def _last_places(data: Any, path: Path, names: set[str]) -> dict[str, Path]:
    """Where each name was written last, as text or as a key, in the order of the document."""
    last: dict[str, Path] = {}
    stack = [(path, data)]
    while stack:
        here, node = stack.pop()
        if isinstance(node, dict):
            last.update((key, (*here, key)) for key in node if key in names)
            stack.extend(((*here, key), child) for key, child in reversed(node.items()))
        elif isinstance(node, list):
            stack.extend(((*here, index), child) for index, child in reversed(list(enumerate(node))))
        elif isinstance(node, str):
            last.update((name, here) for name in names if node == name or f"{{{name}}}" in node)
    return last
