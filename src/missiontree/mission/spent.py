"""What having a tree built has taken."""

from __future__ import annotations

from dataclasses import dataclass

from missiontree.mission.value import Index, Value


@dataclass(frozen=True, slots=True, kw_only=True)
class Spent(Value):
    """
    What a dialogue with a language model took.

    Parameters
    ----------
    turns
        Messages of the model.
    calls, refused
        Calls made, and how many of them were refused.
    input_tokens, output_tokens
        Tokens sent and received, all turns together.
    estimated
        Whether some turn's tokens are an estimate (a token for three bytes), because its provider did not count them.
    seconds
        How long the dialogue took by the clock, waits for the provider included; at least 0.
    cost_usd
        Money in US dollars; None if it is not known for every turn.
    """

    turns: Index = 0
    calls: Index = 0
    refused: Index = 0
    input_tokens: Index = 0
    output_tokens: Index = 0
    estimated: bool = False
    seconds: float = 0.0
    cost_usd: float | None = None

    def _check(self) -> None:
        if not self.seconds >= 0:
            raise ValueError(f"seconds must be at least 0, got {self.seconds}.")
        if self.cost_usd is not None and not self.cost_usd >= 0:
            raise ValueError(f"cost_usd must be at least 0, got {self.cost_usd}.")
