from pathlib import Path

import pytest
import yaml

from missiontree.authoring.language import kinds
from missiontree.authoring.language.kinds import kind_of
from missiontree.mission.scene import BASE_KINDS


@pytest.mark.parametrize(
    ("phrase", "kind"),
    [
        ("Child", "person"),
        ("Mom", "person"),
        ("cat", "animal"),
        ("the old woman with the heavy bag", "person"),
        ("building on fire", "place"),
        ("fire", "object"),
        ("fire station", "place"),
        ("firefighters", "person"),
        ("puppies", "animal"),
        ("boxes", "object"),
        ("safe area", "place"),
        ("gizmo", None),
        ("", None),
        ("...", None),
    ],
)
def test_the_noun_gives_the_kind(phrase: str, kind: str | None) -> None:
    assert kind_of(phrase) == kind


def test_every_noun_stands_under_one_base_kind() -> None:
    lists = yaml.safe_load(Path(kinds.__file__).with_name("kinds.yaml").read_text(encoding="utf-8"))
    assert tuple(lists) == BASE_KINDS
    nouns = [noun for listed in lists.values() for noun in listed]
    assert [noun for noun in nouns if not isinstance(noun, str) or noun != noun.lower()] == []
    assert sorted(noun for noun in set(nouns) if nouns.count(noun) > 1) == []
