"""Data for the page's script, in a form that cannot end the element it stands in."""

from __future__ import annotations

import json
from typing import Any

from markupsafe import Markup

_ESCAPED = str.maketrans({"<": "\\u003c", ">": "\\u003e", "&": "\\u0026"})


def island(data: Any) -> Markup:
    """Compact JSON in ASCII without angle brackets and ampersands: ``</script>`` and ``<!--`` cannot occur in it."""
    return Markup(json.dumps(data, separators=(",", ":"), allow_nan=False).translate(_ESCAPED))  # noqa: S704 - that is the point
