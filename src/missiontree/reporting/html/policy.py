"""What the page may load and run: its own style and its own script, told by their content, and nothing else in the world."""

from __future__ import annotations

import hashlib
from base64 import b64encode


def policy(style: str, script: str) -> str:
    """
    The page's Content-Security-Policy.

    Parameters
    ----------
    style, script
        Content of the one ``style`` and the one ``script`` element, to the byte. A change of either takes its right away.
    """
    return "; ".join(
        (
            "default-src 'none'",
            f"style-src {_source(style)}",
            f"script-src {_source(script)}",
            "base-uri 'none'",
            "form-action 'none'",
        )
    )


def _source(content: str) -> str:
    return f"'sha256-{b64encode(hashlib.sha256(content.encode()).digest()).decode()}'"
