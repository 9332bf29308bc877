"""Where the machine has its Chromium."""

from __future__ import annotations

import shutil

_NAMES = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable")


def chromium() -> str | None:
    """Path of a browser that tests can drive, or None."""
    return next((path for name in _NAMES if (path := shutil.which(name)) is not None), None)
