"""The SDK of a provider: how it is loaded, and where the key for it is found."""

from __future__ import annotations

import os
from collections.abc import Iterator
from dataclasses import dataclass
from importlib import import_module
from typing import Any
from urllib.parse import urlsplit

from missiontree.llm.chat import ProviderError

LONGEST_S = 3600.0
"""Longest time-out that is handed to an SDK, in seconds; sockets cannot wait for ever by number."""


@dataclass(frozen=True, slots=True)
class Sdk:
    """
    A provider's own SDK.

    Parameters
    ----------
    provider
        What people call its provider.
    module
        Its module; loaded when a model is made and not before, since that takes a second and it may not be installed.
    extra
        The extra of missiontree that installs it.
    variables
        Environment variables that may hold the key; the first that is set counts.
    """

    provider: str
    module: str
    extra: str
    variables: tuple[str, ...]

    def key(self, given: str | None = None) -> str:
        """
        The key to use.

        Parameters
        ----------
        given
            The key, if it does not come from the environment.

        Raises
        ------
        ProviderError
            ``unauthorised``, if there is none, or what is there cannot be one. Says where it was looked for and never what was found.
        """
        for source, key in self._candidates(given):
            if not (key.isascii() and key.isprintable() and " " not in key):
                raise ProviderError(
                    f"The key for {self.provider} in {source} holds blanks or characters that no key has.",
                    "unauthorised",
                    "Copy the key again, and nothing around it.",
                )
            return key
        raise ProviderError(f"There is no key for {self.provider}.", "unauthorised", f"Set {self.where}.")

    @property
    def where(self) -> str:
        """Where the key is looked for, in words."""
        return "the environment variable " + " or ".join(self.variables)

    def load(self, submodule: str = "") -> Any:
        """
        Its module, or one below it.

        Raises
        ------
        ProviderError
            ``not_installed``.
        """
        name = f"{self.module}.{submodule}" if submodule else self.module
        try:
            return import_module(name)
        except ImportError as error:
            raise ProviderError(
                f"The package that talks to {self.provider} cannot be loaded: {error.name or name} is missing.",
                "not_installed",
                f"pip install 'missiontree[{self.extra}]'",
            ) from error

    def address(self, base_url: str | None) -> str | None:
        """
        The base URL if it is one; None, for the provider's own, if it is None or empty.

        Raises
        ------
        ProviderError
            ``unreachable``, if it is none. Does not repeat it, since it may hold a password.
        """
        if not base_url:
            return None
        try:
            parts = urlsplit(base_url)
            sound = parts.scheme in {"http", "https"} and bool(parts.hostname) and parts.port != 0
        except ValueError:
            sound = False
        if not sound:
            raise ProviderError(
                f"The base URL for {self.provider} is no address.",
                "unreachable",
                "Write http://HOST:PORT or https://HOST.",
            )
        return base_url

    def _candidates(self, given: str | None) -> Iterator[tuple[str, str]]:
        found = [("the argument", given), *((variable, os.environ.get(variable)) for variable in self.variables)]
        return ((source, key.strip()) for source, key in found if key and key.strip())
