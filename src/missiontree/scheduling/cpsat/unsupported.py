"""What the model cannot say."""

from __future__ import annotations


class UnsupportedError(Exception):
    """A mission has something that the model does not express; the message says what."""


class TimeIsUpError(Exception):
    """Time was up before a model was built."""
