"""Who built a tree and what it took, in a line."""

from __future__ import annotations

from missiontree.mission.spent import Spent


def author_in_words(author: str, model: str, spent: Spent) -> str:
    """``openai gpt-x: 4 turns, 7 calls (1 refused), 5210 + 430 tokens, 12.3 s, cost not known``."""
    about = "about " if spent.estimated else ""
    parts = [
        _count(spent.turns, "turn"),
        _count(spent.calls, "call") + (f" ({spent.refused} refused)" if spent.refused else ""),
        f"{about}{spent.input_tokens} + {spent.output_tokens} tokens",
    ]
    if spent.seconds:
        parts.append(f"{spent.seconds:.1f} s")
    parts.append("cost not known" if spent.cost_usd is None else f"{spent.cost_usd:.4f} US dollars")
    return f"{' '.join(filter(None, (author, model)))}: {', '.join(parts)}"


def _count(number: int, noun: str) -> str:
    return f"{number} {noun}" if number == 1 else f"{number} {noun}s"
