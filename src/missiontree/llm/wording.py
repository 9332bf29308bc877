"""The faults of providers in words: a sentence, what the provider said of it, and what to do. Never with a key."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from missiontree.llm.chat import FaultKind, ProviderError

LONGEST = 300
"""Letters of a provider's own words that are passed on."""

_HIDDEN = "[key]"
_SAYS: Mapping[FaultKind, str] = {
    "unreachable": "{name} cannot be reached",
    "timed_out": "{name} gave no answer in time",
    "rate_limited": "{name} takes no more requests for now",
    "overloaded": "{name} is overloaded or out of order",
    "unauthorised": "{name} does not let this key use {model}",
    "no_such_model": "{name} has no model {model}",
    "bad_request": "{name} rejects the request",
    "context_overflow": "The dialogue is longer than {model} takes",
    "cut_off": "The answer of {name} broke off",
    "empty": "{name} gave an empty answer",
    "failed": "{name} gave an answer that is none",
}
_HINTS: Mapping[FaultKind, str] = {
    "unreachable": "Check the network and the base URL.",
    "timed_out": "Try again, allow more time, or use another model.",
    "rate_limited": "Try again later, or ask for less at once.",
    "overloaded": "Try again later, or use another model.",
    "unauthorised": "Check {where}, and what the key may be used for.",
    "no_such_model": "Check the spelling of the model, and the base URL if one is set.",
    "context_overflow": "Use a model that takes more, or describe less in the scene.",
    "cut_off": "Try again.",
    "empty": "Try again, or use another model.",
    "failed": "Check that an endpoint of {name} answers at the base URL.",
}


@dataclass(frozen=True, slots=True)
class Wording:
    """
    What is said of faults of one model.

    Parameters
    ----------
    name
        The provider.
    model
        The model.
    where
        Where the key comes from.
    secret
        The key, so that it can be taken out of whatever is said.
    """

    name: str
    model: str
    where: str
    secret: str = field(repr=False)

    def fault(
        self, kind: FaultKind, said: object = "", status: int | None = None, retry_after_s: float | None = None
    ) -> ProviderError:
        """
        A fault to be raised.

        Parameters
        ----------
        kind
            What sort of fault it is.
        said
            The provider's own words; anything that is no text counts as silence.
        status
            HTTP status, if it was one.
        retry_after_s
            Seconds after which the provider says it may be asked again.
        """
        names = {"name": self.name, "model": repr(self.seen(self.model)), "where": self.where}
        sentence = _SAYS.get(kind, "{name} failed").format(**names)
        if status is not None:
            sentence += f" (status {status})"
        words = self.seen(said) if isinstance(said, str) else ""
        return ProviderError(
            f"{sentence}: {words}" if words else f"{sentence}.",
            kind,
            _HINTS.get(kind, "").format(**names),
            retry_after_s,
        )

    def seen(self, text: str) -> str:
        """The text fit to be shown: without the key, on one line, without control characters, and not too long."""
        # The key goes first: cut in the middle or with its blanks changed, it would not be found any more.
        clean = text.replace(self.secret, _HIDDEN)
        clean = " ".join("".join(letter if letter.isprintable() else " " for letter in clean).split())
        return clean if len(clean) <= LONGEST else f"{clean[:LONGEST]}..."
