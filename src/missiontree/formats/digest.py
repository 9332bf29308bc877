"""One text, and one short name, for equal values."""

from __future__ import annotations

import hashlib
import json
from typing import Any

from missiontree.formats.plain import to_plain


def canonical(value: Any) -> str:
    """
    Compact JSON of a value, keys sorted, defaults left out: equal values give equal text, byte for byte.

    Numbers are written as RFC 8785 (JSON Canonicalization Scheme) has them where that matters here: 1.0 as 1.
    """
    return json.dumps(to_plain(value), ensure_ascii=False, sort_keys=True, separators=(",", ":"), allow_nan=False)


def digest(value: Any) -> str:
    """SHA-256 of the canonical JSON, in hexadecimal."""
    return hashlib.sha256(canonical(value).encode("utf-8", "surrogatepass")).hexdigest()
