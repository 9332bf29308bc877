"""Numbers as the page writes them."""

from __future__ import annotations


def number(value: float) -> str:
    """Six digits that count, thousands parted: ``10.2597``, ``16,500``, ``1,234,568``."""
    if abs(value) >= 1e6:
        return f"{value:,.0f}" if abs(value) < 1e15 else f"{value:.6g}"
    short = f"{value:.6g}"
    whole, point, rest = short.partition(".")
    return f"{int(whole):,}{point}{rest}" if whole.isdigit() and "e" not in rest else short


def count(how_many: int, noun: str) -> str:
    """``1 robot``, ``4 robots``."""
    return f"{how_many:,} {noun}" if how_many == 1 else f"{how_many:,} {noun}s"


def share(part: float, whole: float) -> str:
    """How much of the whole a part is, in per cent: ``4 %``; ``<1 %`` and ``>99 %`` where rounding would tell of none or all."""
    if whole <= 0:
        return "–"
    percent = 100 * part / whole
    if 0 < percent < 1:
        return "<1 %"
    if 99 < percent < 100:
        return ">99 %"
    return f"{percent:,.0f} %"
