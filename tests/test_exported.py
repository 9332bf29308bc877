"""Inside is private, outside is listed."""

from __future__ import annotations

import subprocess
import sys

import missiontree


def test_every_public_name_is_there_and_sorted() -> None:
    assert sorted(missiontree.__all__) == missiontree.__all__
    for name in missiontree.__all__:
        assert getattr(missiontree, name).__name__ == name
    assert set(missiontree.__all__) <= set(dir(missiontree))


def test_help_loads_nothing_heavy() -> None:
    """The command line starts quickly because it loads the road only when it plans."""
    code = "import sys, missiontree.cli.main; print([m for m in ('yaml', 'missiontree.planner', 'rich.table') if m in sys.modules])"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "[]"
