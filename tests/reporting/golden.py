"""
Keep the pictures that are part of the contract: every byte of them is looked at before it changes.

usage: python -m tests.reporting.golden

The files are those in ``tests/reporting/golden``. Look at each that has changed before it is kept.
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from tests.reporting import golden_charts, golden_maps, golden_trees

FOLDER = Path(__file__).parent / "golden"
PICTURES: dict[str, Callable[[], str]] = dict(
    [*golden_trees.pictures(), *golden_charts.pictures(), *golden_maps.pictures()]
)


def main() -> None:
    """Write the files anew; those that are no longer made go."""
    FOLDER.mkdir(exist_ok=True)
    for file in FOLDER.iterdir():
        if file.name not in PICTURES:
            file.unlink()
            print(f"{file.name} is removed")
    for name, make in PICTURES.items():
        file, content = FOLDER / name, make()
        if not file.is_file() or file.read_text(encoding="utf-8") != content:
            file.write_text(content, encoding="utf-8", newline="\n")
            print(f"{name} is written")
    print(f"{len(PICTURES)} pictures")


if __name__ == "__main__":
    main()
