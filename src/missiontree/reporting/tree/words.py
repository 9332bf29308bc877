"""A drawn tree in words: what a pointer or a reader's voice says of its boxes and of the whole."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator

from missiontree.mission.tree import LINK_KINDS
from missiontree.reporting.tree.shape import Shape, ShapeKind, ShapeNode

MOST_TOLD = 12
_KINDS: dict[ShapeKind, tuple[str, str]] = {
    "task": ("task", "tasks"),
    "routine": ("routine", "routines"),
    "action": ("action", "actions"),
    "impossible": ("task that nobody can do", "tasks that nobody can do"),
}


def title_of(node: ShapeNode) -> str:
    """Everything that a box says, in full."""
    parts = [node.label, node.note]
    if node.gate is not None:
        parts.append("all of its parts" if node.gate == "and" else "exactly one of its parts")
    if node.team:
        parts.append(f"by {', '.join(badge.text for badge in node.team)}")
    if node.hidden:
        parts.append(f"{_counted(node.hidden, 'node', 'nodes')} folded")
    if node.state != "plain":
        parts.append("chosen" if node.state == "lit" else "not chosen")
    return "; ".join(part for part in parts if part)


def description(shape: Shape, whole: Shape, rank: int | None, ranks: int) -> str:
    """The picture in a few sentences: how large the tree is, what is folded, who does what."""
    return " ".join(_sentences(shape, whole, rank, ranks))


def folding_words(shape: Shape, whole: Shape) -> str:
    """How much is folded; empty if nothing is."""
    if len(shape.nodes) == len(whole.nodes):
        return ""
    hidden = sum(node.hidden for node in shape.nodes)
    links = len(whole.links) - len(shape.links)
    more = f", and {_counted(links, 'link', 'links')} with them" if links else ""
    return f"{hidden:,} of {len(whole.nodes):,} nodes are folded{more}: a pile says how many nodes it stands for"


def _sentences(shape: Shape, whole: Shape, rank: int | None, ranks: int) -> Iterator[str]:
    kinds = Counter(node.kind for node in whole.nodes)
    parts = [_counted(kinds[kind], *words) for kind, words in _KINDS.items() if kinds[kind]]
    links = Counter(kind for _, _, kind in whole.links)
    parts += [f"{_counted(links[kind], 'link', 'links')} of {_KIND_WORDS[kind]}" for kind in LINK_KINDS if links[kind]]
    yield f"A mission tree: {', '.join(parts)}."
    if words := folding_words(shape, whole):
        yield f"{words}."
    if rank is None:
        return
    yield f"Alternative {rank} of {ranks} is lit."
    done = [
        f"{node.label} by {', '.join(badge.text for badge in node.team)}"
        for node in whole.nodes
        if node.state == "lit" and node.team
    ]
    if done:
        more = f", and {len(done) - MOST_TOLD} more" if len(done) > MOST_TOLD else ""
        yield f"Who does what: {'; '.join(done[:MOST_TOLD])}{more}."


_KIND_WORDS = {
    "precedence": "precedence",
    "same_robot": "the same robot",
    "different_robot": "different robots",
    "until": "until",
    "hand_over": "hand-over",
}


def _counted(number: int, one: str, several: str) -> str:
    return f"{number:,} {one if number == 1 else several}"
