"""Letters that look like others, by script, width or by not being seen: for names that must not pass for what they look like."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from random import Random

CYRILLIC = dict(zip("aceopxyijshkAEOPCTHMKBX", "асеорхуіјѕһкАЕОРСТНМКВХ", strict=True))
GREEK = dict(zip("oviuanpktABEHIKMNOPTXZ", "ονιυαηρκτΑΒΕΗΙΚΜΝΟΡΤΧΖ", strict=True))
LATIN = dict(zip("aiglodtubceInmzr", "ɑıɡⅼ᧐ԁƫυЬϲеІпⅿᴢг", strict=True))
COMPATIBLE = dict(zip("sSKkikcvxmAaBhrz", "ſſKKⅰкⅽⅴⅹⅿÅªℬℎ𝐫𝐳", strict=True))
INVISIBLE = ("\u200b", "\u200c", "\u200d", "\u2060", "\ufeff", "\u00ad", "\u180e", "\u034f", "\u2063", "\ufe0f")
MARKS = ("\u0300", "\u0301", "\u0307", "\u0308", "\u0323", "\u0327", "\u0332", "\u0338", "\u20dd")
TURNING = ("\u202e", "\u202d", "\u2066", "\u2067", "\u2069", "\u200f", "\u061c")

Change = Callable[[Random, str], str]


def swapped(table: Mapping[str, str]) -> Change:
    """One to three letters replaced by look-alikes; the name itself if it has none of them."""

    def change(rng: Random, name: str) -> str:
        places = [place for place, letter in enumerate(name) if letter in table]
        chosen = set(rng.sample(places, min(len(places), rng.randint(1, 3))))
        return "".join(table[letter] if place in chosen else letter for place, letter in enumerate(name))

    return change


def inserted(letters: tuple[str, ...]) -> Change:
    """A letter that is not seen, or joins another, put in somewhere behind the first letter."""

    def change(rng: Random, name: str) -> str:
        place = rng.randint(1, len(name)) if name else 0
        return name[:place] + rng.choice(letters) + name[place:]

    return change


def full_width(rng: Random, name: str) -> str:
    """Some letters, or all, in the width of ideographs."""
    every = rng.random() < 0.5
    wide = "".join(
        chr(ord(letter) + 0xFEE0) if "!" <= letter <= "~" and (every or rng.random() < 0.3) else letter
        for letter in name
    )
    return (
        wide if wide != name else "".join(chr(ord(letter) + 0xFEE0) if letter.isalnum() else letter for letter in name)
    )


def ligature(rng: Random, name: str) -> str:
    """Two letters written as one."""
    for pair, one in rng.sample((("fi", "ﬁ"), ("fl", "ﬂ"), ("ff", "ﬀ"), ("st", "ﬆ"), ("ij", "ĳ"), ("nj", "ǌ")), 6):
        if pair in name:
            return name.replace(pair, one, 1)
    return name


LOOK_ALIKES: Mapping[str, Change] = {
    "Cyrillic letters": swapped(CYRILLIC),
    "Greek letters": swapped(GREEK),
    "Latin look-alikes": swapped(LATIN),
    "compatibility letters": swapped(COMPATIBLE),
    "full width": full_width,
    "ligature": ligature,
    "invisible letter": inserted(INVISIBLE),
    "combining mark": inserted(MARKS),
    "turned direction": inserted(TURNING),
}
