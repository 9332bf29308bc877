"""Names that somebody might say instead of a real one: slips, look-alikes, plurals, translations, names of other teams."""

from __future__ import annotations

import string
from collections.abc import Mapping, Sequence
from random import Random

from benchmarks.campaign_letters import LOOK_ALIKES, Change

FOREIGN = (
    "Spot", "TurtleBot", "Husky", "Pepper", "Roomba", "ANYmal", "drone", "quadcopter", "Heavy Lifter", "Mobile Scooter 2", "tele_robot_9",
    "PatrolTree", "GraspTree", "FlyTree", "GuardTree", "RescueTree", "SearchAndRescueTree", "Wait", "NoOp", "ChargeTree", "DeliverTree",
    "dragon", "monster", "elevator", "Alice", "Bob", "robot", "everyone", "it", "me", "operator", "server", "room_99", "table",
    "createSubtask", "finish", "done", "approve", "execute", "runPlan", "addRobot", "exec", "__init__", "drop_table", "*", "null",
)  # fmt: skip
TRANSLATED = (
    "Suche", "SucheTree", "SuchBaum", "Folgen", "Erreichen", "ChercherTree", "BuscarTree", "TransporterTree", "Kind", "enfant", "niño",
    "Mutter", "mère", "Koffer", "valise", "Kran", "grue", "Werkzeugkasten", "Labor", "Zimmer 1", "chambre 1", "Taucher", "Kiste",
    "搜索", "поиск", "الطفل", "子供", "ПоискTree", "Teleroboter", "robot télé", "Pflegehilfe", "Besucher", "Ersatzaufgabe",
)  # fmt: skip


def _dropped(rng: Random, name: str) -> str:
    place = rng.randrange(len(name))
    return name[:place] + name[place + 1 :]


def _added(rng: Random, name: str) -> str:
    place = rng.randint(0, len(name))
    return name[:place] + rng.choice(string.ascii_lowercase + name) + name[place:]


def _changed(rng: Random, name: str) -> str:
    place = rng.randrange(len(name))
    return name[:place] + rng.choice(string.ascii_lowercase + string.digits) + name[place + 1 :]


def _turned(rng: Random, name: str) -> str:
    if len(name) < 2:
        return name * 2
    place = rng.randrange(len(name) - 1)
    return name[:place] + name[place + 1] + name[place] + name[place + 2 :]


def _cased(rng: Random, name: str) -> str:
    return rng.choice((name.upper(), name.lower(), name.swapcase(), name.title()))


def _plural(rng: Random, name: str) -> str:
    if name.endswith("s") and rng.random() < 0.6:
        return name[:-1]
    return rng.choice(
        (name + "s", name + "es", name[:-1] + "ies", name + "'s", "all " + name + "s", "two " + name + "s")
    )


def _dressed(rng: Random, name: str) -> str:
    forms = (
        "{}Tree", "{}_", "_{}", "my {}", "{} 2", "{}-1", "{}()", "{}(agent)", "'{}'", '"{}"', "`{}`", "[{}]", "{{{}}}", "{}: person",
        "{}.", "{}\n", "{}\x00", "<{}>", "${}", "../{}", "{}; drop", "{} and {}", "{}/{}", "{}, {}", "id={}", "type:{}", "not {}", "{}?",
    )  # fmt: skip
    return rng.choice(forms).replace("{}", name)


def _rewritten(rng: Random, name: str) -> str:
    words = name.replace("_", " ").replace("-", " ").split()
    joined = (
        "".join(word.title() for word in words),
        "_".join(words),
        "-".join(words),
        "".join(words),
        " ".join(reversed(words)),
    )
    return rng.choice(
        (*joined, " ".join(words[:-1]) or name[:1], name.removesuffix("Tree") + "Subtree", name[: len(name) // 2])
    )


def _renumbered(rng: Random, name: str) -> str:
    digits = [place for place, letter in enumerate(name) if letter.isdigit()]
    if not digits:
        return f"{name}{rng.choice((' 1', '_1', '1', ' I', '-2', ' one'))}"
    place = rng.choice(digits)
    return name[:place] + rng.choice(("", "0", "3", "7", "22", "１", "²", "one", "I")) + name[place + 1 :]


SLIPS: Mapping[str, Change] = {
    "letter left out": _dropped,
    "letter put in": _added,
    "letter changed": _changed,
    "letters turned": _turned,
    "plural": _plural,
    "dressed up": _dressed,
    "written otherwise": _rewritten,
    "other number": _renumbered,
    "letter case": _cased,
    "foreign": lambda rng, name: rng.choice(FOREIGN),
    "translated": lambda rng, name: rng.choice(TRANSLATED),
    "nothing or far too much": lambda rng, name: rng.choice(
        ("", " ", "\t", name * 200, (name + " ") * 30, "\ud800" + name)
    ),
}
WAYS: Mapping[str, Change] = {**SLIPS, **LOOK_ALIKES}
OTHER_NAME = "name of something else"


def near(rng: Random, way: str, name: str, others: Sequence[str]) -> str:
    """A name made from a real one in that way; or a real one of something else."""
    return rng.choice(list(others)) if way == OTHER_NAME else WAYS[way](rng, name)
