"""
Keep the outputs in the documentation real.

usage: python -m tests.docs.outputs

A block that follows ``<!-- output: ARGUMENTS -->`` holds what the command prints.
"""

from __future__ import annotations

import re
import shlex
import subprocess
import sys
import tempfile
from pathlib import Path

TIMES = re.compile(r" +(?:\d+\.\d ms|time)$", re.MULTILINE)  # the only thing that differs from run to run
ROOT = Path(__file__).parents[2]
BLOCK = re.compile(r"(<!-- output: (?P<arguments>[^\n]*) -->\n```text\n)(?P<text>.*?)(```)", re.DOTALL)


def printed(arguments: str, folder: Path) -> str:
    """What the command prints on standard output, in a folder that ``missiontree init`` wrote; of several, parted by ``&&``, the last."""
    for one in arguments.split(" && "):
        command = [sys.executable, "-m", "missiontree", *shlex.split(one)]
        done = subprocess.run(command, capture_output=True, text=True, cwd=folder, encoding="utf-8", check=False)
    return TIMES.sub("", done.stdout or done.stderr)


def refreshed(page: str) -> str:
    """The page with every output as it is now."""
    with tempfile.TemporaryDirectory() as folder:
        site, empty = Path(folder) / "site", Path(folder) / "empty"
        empty.mkdir()
        printed(f"init {site}", empty)

        def renew(match: re.Match[str]) -> str:
            arguments = match["arguments"]
            where, arguments = (site, arguments[5:]) if arguments.startswith("site ") else (empty, arguments)
            return f"{match[1]}{printed(arguments, where)}{match[4]}"

        return BLOCK.sub(renew, page)


def pages() -> list[Path]:
    """Pages that show outputs."""
    found = [*ROOT.glob("*.md"), *(ROOT / "docs").rglob("*.md")]
    return sorted(page for page in found if BLOCK.search(page.read_text(encoding="utf-8")))


if __name__ == "__main__":
    for page in pages():
        page.write_text(refreshed(page.read_text(encoding="utf-8")), encoding="utf-8")
