"""What was learnt of endpoints, kept from one run to the next."""

from __future__ import annotations

import contextlib
import json
import os
import threading
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from missiontree.llm.features import Features

FORMAT = "endpoints/1"
_MOST = 500
_LARGEST = 1_000_000
Key = tuple[str, str]


class FeatureMemory:
    """
    What each model at each endpoint can do, as far as it was found out.

    Parameters
    ----------
    path
        JSON file it is kept in. None (default) keeps it in this process only. A file that is damaged or cannot be read counts as empty,
        and one that cannot be written is not written: nothing depends on it but a few requests.
    """

    def __init__(self, path: Path | None = None) -> None:
        self.path = path
        self._lock = threading.Lock()
        self._known: dict[Key, Features] = _read(path)

    def known(self, endpoint: str, model: str) -> Features:
        """
        What may be asked of a model; everything if nothing is known of it.

        Parameters
        ----------
        endpoint
            Address without anything secret.
        model
            Name of the model there.
        """
        return self._known.get((endpoint, model), Features())

    def learn(self, endpoint: str, model: str, features: Features) -> None:
        """Keep what was found out of a model, in the place of what was known before; see :meth:`known`."""
        with self._lock:
            self._known |= _read(self.path)  # others may have written meanwhile
            self._known.pop((endpoint, model), None)
            self._known[endpoint, model] = features
            _write(self.path, self._known)


def usual_path(environment: Mapping[str, str] = os.environ) -> Path:
    """The file in the user's cache folder: ``missiontree/endpoints.json`` below ``XDG_CACHE_HOME``, by default ``~/.cache``."""
    given = environment.get("XDG_CACHE_HOME", "")
    folder = Path(given) if os.path.isabs(given) else Path(os.path.expanduser("~")) / ".cache"
    return folder / "missiontree" / "endpoints.json"


def _read(path: Path | None) -> dict[Key, Features]:
    if path is None:
        return {}
    try:
        if path.stat().st_size > _LARGEST:
            return {}
        entries = json.loads(path.read_text(encoding="utf-8"))["endpoints"]
        return dict(_entry(entry) for entry in entries)
    except (OSError, ValueError, RecursionError, KeyError, TypeError):
        return {}


def _entry(entry: Any) -> tuple[Key, Features]:
    url, model, without = entry["url"], entry["model"], entry["without"]
    if not (isinstance(url, str) and isinstance(model, str) and isinstance(without, list)):
        raise TypeError("an entry is none")
    return (url, model), Features().without(name for name in without if isinstance(name, str))


def _write(path: Path | None, known: Mapping[Key, Features]) -> None:
    """Write the file as a whole or not at all."""
    if path is None:
        return
    latest = list(known.items())[-_MOST:]
    entries = [{"url": url, "model": model, "without": list(features.missing)} for (url, model), features in latest]
    text = json.dumps({"format": FORMAT, "endpoints": entries}, indent=1) + "\n"
    beside = path.with_name(f"{path.name}.{os.getpid()}.{threading.get_ident()}")
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        beside.write_text(text, encoding="utf-8")
        os.replace(beside, path)
    except OSError:
        with contextlib.suppress(OSError):
            beside.unlink()
