"""What is worked out of a class once and then remembered."""

from __future__ import annotations

from collections.abc import Callable
from functools import wraps
from typing import Any, TypeVar

T = TypeVar("T")


def per_class(work_out: Callable[[type[Any]], T]) -> Callable[[type[Any]], T]:
    """Call the function once for each class."""
    known: dict[type[Any], T] = {}

    @wraps(work_out)
    def remembered(cls: type[Any]) -> T:
        if cls not in known:
            known[cls] = work_out(cls)
        return known[cls]

    return remembered
