"""
Which files the figures of a campaign belong to: its own, and all of the package and of these commands that it may come to import.

What a page looks like or how a file is read is no matter to a campaign of schedulers that imports neither: its state stays good.
"""

from __future__ import annotations

import ast
import hashlib
from collections.abc import Iterator
from pathlib import Path

import missiontree

_HERE = Path(__file__).resolve().parent
ROOTS = {
    "missiontree": Path(missiontree.__file__).resolve().parent,
    "benchmarks": _HERE,
    "tests": _HERE.with_name("tests"),  # some campaigns take their missions from there
}
DATA = {".yaml", ".txt"}
"""Endings of what a module may read beside itself."""


def source_digest(start: Path) -> str:
    """A digest of the files that a module may come to use, the first 12 letters."""
    found = hashlib.sha256()
    for name, path in sorted((_shown(path), path) for path in source_files(start)):
        found.update(name.encode() + b"\0" + path.read_bytes())
    return found.hexdigest()[:12]


def source_files(start: Path) -> set[Path]:
    """
    The files that a module may come to use: those it imports, anywhere in it, those that they import, and data beside them.

    What is imported for types alone is left out, and so is what is imported by a name that is made up while it runs.
    """
    seen, left = set[Path](), [start.resolve()]
    while left:
        path = left.pop()
        if path in seen:
            continue
        seen.add(path)
        if path.suffix == ".py":
            for name in _imported(ast.parse(path.read_bytes())):
                left += _files_of(name)
            left += (one for one in path.parent.iterdir() if one.suffix in DATA and _shown(path) != path.name)
    return seen


def _imported(tree: ast.AST) -> Iterator[str]:
    """Dotted names that are imported; of a name from a module, both, as either may be a file."""
    left: list[ast.AST] = [tree]
    while left:
        node = left.pop()
        if isinstance(node, ast.If) and isinstance(node.test, ast.Name) and node.test.id == "TYPE_CHECKING":
            left += node.orelse
        elif isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom) and node.module is not None:
            yield node.module
            yield from (f"{node.module}.{alias.name}" for alias in node.names)
        else:
            left += ast.iter_child_nodes(node)


def _files_of(name: str) -> Iterator[Path]:
    """The file of a module of ours, and of the packages above it."""
    first, *rest = name.split(".")
    here = ROOTS.get(first)
    if here is None:
        return
    for part in ("", *rest):
        here = here / part
        yield from (path for path in (here / "__init__.py", here.with_suffix(".py")) if path.is_file())


def _shown(path: Path) -> str:
    """A path as it is on every machine."""
    for name, root in ROOTS.items():
        if path.is_relative_to(root):
            return f"{name}/{path.relative_to(root).as_posix()}"
    return path.name
