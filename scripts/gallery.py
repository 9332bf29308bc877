"""
Make the gallery, ``docs/gallery.md``, and its pictures, ``docs/pictures/gallery/*.svg``, by planning every sample.

::

    python -m scripts.gallery [--check | --screenshots]

Same package, same bytes. ``--check`` writes nothing, says which files are not current, and ends with 1 if there are any.
``--screenshots`` also opens a report in a headless Chromium and photographs it into ``docs/pictures/report-*.png``. These are not
compared by ``--check``: a browser draws words with the fonts of the machine, so that they differ from one to another.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Mapping, Sequence
from pathlib import Path

from scripts.gallery_page import FOLDER, gallery_of

DOCS = Path(__file__).parents[1] / "docs"


def main(arguments: Sequence[str] | None = None) -> int:
    """Write the gallery, or say what is not current; the exit code."""
    parser = argparse.ArgumentParser(
        prog="python -m scripts.gallery", description=(__doc__ or "").strip().split("\n")[0]
    )
    either = parser.add_mutually_exclusive_group()
    either.add_argument("--check", action="store_true", help="write nothing; name the files that are not current")
    either.add_argument("--screenshots", action="store_true", help="photograph a report in a headless Chromium, too")
    parser.add_argument("--docs", type=Path, default=DOCS, metavar="FOLDER", help="where the page is, default: docs")
    asked = parser.parse_args(arguments)
    files = gallery_of().files
    if asked.check:
        stale = not_current(files, asked.docs)
        for name in stale:
            print(f"not current: {asked.docs.name}/{name}")
        if stale:
            print("`python -m scripts.gallery` renews them.", file=sys.stderr)
        return 1 if stale else 0
    write(files, asked.docs)
    if asked.screenshots:
        from scripts.gallery_screenshots import photograph  # noqa: PLC0415 - needs a browser, and few calls do

        photograph(asked.docs)
    return 0


def not_current(files: Mapping[str, str], docs: Path) -> list[str]:
    """Files that are missing, that differ by a byte, or that nothing writes any more; by name."""
    wrong = {name for name, text in files.items() if _bytes_of(docs / name) != text.encode("utf-8")}
    return sorted(wrong | (_there(docs) - set(files)))


def write(files: Mapping[str, str], docs: Path) -> None:
    """Write the files; pictures of the gallery that are no longer made go."""
    for name in _there(docs) - set(files):
        (docs / name).unlink()
    for name, text in files.items():
        file = docs / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_bytes(text.encode("utf-8"))


def _bytes_of(file: Path) -> bytes | None:
    return file.read_bytes() if file.is_file() else None


def _there(docs: Path) -> set[str]:
    """Pictures of the gallery that lie in their folder, by their path from the folder of the page."""
    return {file.relative_to(docs).as_posix() for file in (docs / FOLDER).glob("*")}


if __name__ == "__main__":
    sys.exit(main())
