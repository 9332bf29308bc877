"""
How values are shown where pictures can be seen, such as notebooks.

A value knows nothing of pictures, and nothing on its floor may. It asks here; the package says beforehand who draws it.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

_drawers: dict[str, Callable[[Any], str]] = {}


def draw_with(kind: str, drawer: Callable[[Any], str]) -> None:
    """
    Say who draws values of a class.

    Parameters
    ----------
    kind
        Name of the class.
    drawer
        From a value to HTML that may stand inside any page. Whoever comes last has it.
    """
    _drawers[kind] = drawer


def html_of(value: object) -> str | None:
    """The value as HTML; None, so that the plain form is shown, if nobody draws its class."""
    drawer = _drawers.get(type(value).__name__)
    return None if drawer is None else drawer(value)
