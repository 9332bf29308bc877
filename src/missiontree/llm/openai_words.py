"""Words of a server made fit to be shown: short, on one line, without control characters, and without any key."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterable
from urllib.parse import quote, unquote, urlsplit

HIDDEN = "[a key was here]"
_LONGEST = 300
_SHORTEST_SECRET = 4
_LOOKS_SECRET = re.compile(r"\bsk-[\w*-]{6,}|\b(?:Bearer|Basic)\s+[\w.~+/=*-]{6,}")


class Words:
    """
    Makes a server's words fit to be shown.

    Parameters
    ----------
    secrets
        What must not be shown. Texts of fewer than 4 letters are no secrets.
    """

    def __init__(self, secrets: Iterable[str]) -> None:
        known = {secret for secret in secrets if len(secret) >= _SHORTEST_SECRET}
        written = known | {quote(secret, safe="") for secret in known} | {unquote(secret) for secret in known}
        self._secrets = sorted(written, key=lambda secret: (-len(secret), secret))

    def clean(self, text: str, longest: int = _LONGEST) -> str:
        """The text without secrets, on one line, with at most that many letters."""
        for secret in self._secrets:
            text = text.replace(secret, HIDDEN)
        text = _LOOKS_SECRET.sub(HIDDEN, text)
        plain = "".join(letter if _harmless(letter) else " " for letter in text[: 4 * longest])
        line = " ".join(plain.split())
        return line if len(line) <= longest else f"{line[: longest - 3]}..."


def is_address(url: str) -> bool:
    """Whether it is an absolute address of a web server."""
    try:
        parts = urlsplit(url)
        return parts.scheme in {"http", "https"} and bool(parts.hostname) and parts.port != 0
    except ValueError:
        return False


def secrets_in(url: str) -> tuple[str, ...]:
    """What in an address is nobody's business: user, password, and the values of the query."""
    place, query = _place_of(url), url.partition("?")[2].partition("#")[0]
    user, _, password = place.rpartition("@")[0].partition(":")
    values = [pair.partition("=")[2] for pair in query.split("&")]
    return tuple(secret for secret in (user, password, *values) if secret)


def without_secrets(url: str) -> str:
    """An address without user, password, query and fragment, and without a slash at its end."""
    place = _place_of(url)
    rest = url.partition("?")[0].partition("#")[0]
    return rest.replace(place, place.rpartition("@")[2], 1).rstrip("/")


def _place_of(url: str) -> str:
    """What stands between the scheme and the path, read without complaint even if it is no address."""
    return re.split(r"[/?#]", url.partition("://")[2], maxsplit=1)[0]


def _harmless(letter: str) -> bool:
    """No control characters, none that turn the direction of writing, no halves of characters."""
    return unicodedata.category(letter) not in {"Cc", "Cf", "Cs", "Co", "Zl", "Zp"}
