"""Columns of integers: lists, or arrays of NumPy, which is imported for the latter only."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, TypeAlias

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Column: TypeAlias = Sequence[int] | NDArray[np.integer[Any]]
else:
    Column = Any


def is_array(column: Any) -> bool:
    """Whether that is a NumPy array; does not import NumPy."""
    return hasattr(column, "dtype") and hasattr(column, "tolist")


def as_list(column: Any) -> list[int]:
    """The numbers as Python's own."""
    listed: list[int] = column.tolist() if is_array(column) else list(column)
    return listed
