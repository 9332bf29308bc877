"""``python -m scripts.compile_ahead``: compile the inner loops, and keep them beside the package, so that nothing waits for it later."""

from __future__ import annotations

from missiontree.allocation.warming import warm_engine
from missiontree.scheduling.joint.compiled import fast_engine

if __name__ == "__main__":
    warm_engine()
    fast_engine()
