"""Workers of a campaign that is killed do not stay."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).parents[2]
PARENT = """
import os
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context
from benchmarks.campaign import leave_with_parent

if __name__ == "__main__":
    pool = ProcessPoolExecutor(1, get_context("spawn"), leave_with_parent)
    pool.submit(os.getpid).result()
    os.abort()
"""


def test_a_worker_ends_with_its_killed_parent(tmp_path: Path) -> None:
    script = tmp_path / "parent.py"
    script.write_text(PARENT)
    # The worker holds the pipe open: its end is read only once both processes are gone.
    done = subprocess.run(
        [sys.executable, script],
        capture_output=True,
        timeout=60,
        check=False,
        env=os.environ | {"PYTHONPATH": str(ROOT)},
    )
    assert done.returncode < 0, done.stderr
