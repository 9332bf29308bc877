"""
Make the list of English verbs that the offline author knows to be verbs, whether anybody serves them or not.

usage: python scripts/make_verbs.py [FOLDER]

FOLDER holds the dictionary files of WordNet 3.0 (Debian: ``apt-get install wordnet-base``, then ``/usr/share/wordnet``, the default).
Every verb of one word is kept; what is rather a noun or an adjective stands behind a determiner in a mission, and a verb before one.
Same input, same bytes. The licence of WordNet stands in NOTICE and at the head of the list.
"""

from __future__ import annotations

import sys
import textwrap
from pathlib import Path

TARGET = Path(__file__).parents[1] / "src" / "missiontree" / "authoring" / "language" / "verbs.txt"
NOUNS = TARGET.with_name("nouns.txt")
TITLE = "# English verbs of one word. Made by scripts/make_verbs.py; not to be edited by hand."
LEFT_OUT = frozenset(
    {"be", "have", "do", "can", "will", "may", "must", "like", "need", "want", "let", "please", "hi", "in", "out"}
)


def verbs_of(folder: Path) -> list[str]:
    """All verbs of one word, small letters only."""
    lines = (folder / "index.verb").read_text(encoding="ascii").splitlines()
    words = {line.split(" ", 1)[0] for line in lines if not line.startswith(" ")}
    return sorted(word for word in words if word.isalpha() and word.islower() and word not in LEFT_OUT)


def main() -> None:
    """Write the list."""
    folder = Path(sys.argv[1] if len(sys.argv) > 1 else "/usr/share/wordnet")
    licence = [line for line in NOUNS.read_text(encoding="ascii").splitlines() if line.startswith("#")][1:]
    head = "".join(f"{line}\n" for line in (TITLE, *licence))
    body = textwrap.fill(" ".join(verbs_of(folder)), width=140, break_long_words=False, break_on_hyphens=False)
    TARGET.write_text(f"{head}{body}\n", encoding="ascii")


if __name__ == "__main__":
    main()
