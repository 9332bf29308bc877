from pathlib import Path

import pytest
import yaml

from missiontree.authoring.language import kinds
from missiontree.authoring.language.kinds import is_abstract, kind_of
from missiontree.mission.scene import BASE_KINDS

# Nouns of twelve domains, each under the kind that whoever works there would give it.
DOMAINS = {
    "mine": {
        "person": "miner geologist foreman surveyor",
        "object": "drill conveyor wagon dynamite helmet ore",
        "place": "shaft tunnel adit",
    },
    "farm": {
        "person": "farmer shepherd beekeeper",
        "animal": "goat sheepdog heifer rooster",
        "object": "tractor hay fertilizer seed",
        "place": "barn paddock silo greenhouse orchard",
    },
    "hospital": {
        "person": "nurse surgeon midwife patient",
        "object": "oxygen bandage syringe stretcher medicine",
        "place": "ward pharmacy clinic",
    },
    "museum": {
        "person": "curator usher visitor docent",
        "object": "statue painting vase tapestry coin fossil",
        "place": "gallery vault foyer",
    },
    "ship": {
        "person": "captain deckhand stowaway",
        "object": "anchor lifeboat buoy compass",
        "place": "cabin deck pier dock galley",
    },
    "laboratory": {
        "person": "chemist biologist researcher",
        "animal": "mouse rat",
        "object": "pipette microscope centrifuge sample reagent",
        "place": "lab cleanroom",
    },
    "festival": {
        "person": "singer drummer vendor steward",
        "object": "tent amplifier guitar banner",
        "place": "stage booth campsite fairground",
    },
    "forest": {
        "person": "ranger hiker lumberjack",
        "animal": "wolf deer owl squirrel",
        "object": "tree chainsaw log mushroom",
        "place": "clearing ravine creek swamp",
    },
    "data centre": {
        "person": "administrator technician",
        "object": "server router printer rack modem",
        "place": "office corridor boardroom",
    },
    "airport": {
        "person": "pilot stewardess passenger",
        "object": "suitcase passport helicopter",
        "place": "hangar runway terminal",
    },
    "building site": {
        "person": "bricklayer welder architect",
        "object": "crane forklift ladder cement bulldozer ramp",
        "place": "basement bridge",
    },
    "household": {
        "person": "caretaker toddler butler",
        "animal": "parrot hamster poodle",
        "object": "kettle mattress letter coffee toaster",
        "place": "kitchen pantry balcony well",
    },
}
ABSTRACT = """
    noise temperature happiness solution truth problem answer peace progress order schedule time price speed weather law idea meaning
    love advice freedom justice wisdom knowledge courage anger sadness fear success failure democracy budget profit salary deadline reason
    opinion theory quality distance beauty friendship honesty patience gravity mathematics philosophy culture century homework
"""
# Adjectives, participles, small words and verbs: a phrase that ends in one of them has its noun elsewhere, or none.
NO_NOUNS = """
    lost trapped walking red heavy old missing broken empty full blue wooden next back left right front top round light lead green
    black running sleeping stolen hidden burning drowning bleeding stranded dangerous tired hungry young open closed damaged leaking
    standing lying crying quickly nearest best of to and with who very down away has was does this one ten every several
    find bring carry follow go unconscious suspicious cold hot dirty electric medical portable
"""


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


@pytest.mark.parametrize("domain", DOMAINS)
def test_the_nouns_of_a_domain_are_known(domain: str) -> None:
    nouns = {noun: kind for kind, listed in DOMAINS[domain].items() for noun in listed.split()}
    assert {noun: kind_of(noun) for noun in nouns} == nouns
    assert [noun for noun in nouns if is_abstract(noun)] == []


def test_what_cannot_be_found_or_carried_is_abstract_and_has_no_kind() -> None:
    assert [noun for noun in ABSTRACT.split() if not is_abstract(noun) or kind_of(noun) is not None] == []


def test_what_is_rather_no_noun_is_of_no_kind() -> None:
    assert [word for word in NO_NOUNS.split() if kind_of(word) is not None or is_abstract(word)] == []


@pytest.mark.parametrize(
    ("plural", "kind"),
    [
        ("knives", "object"),
        ("shelves", "object"),
        ("foremen", "person"),
        ("stewardesses", "person"),
        ("midwives", "person"),
        ("wolves", "animal"),
        ("sheep", "animal"),
        ("mice", "animal"),
        ("ponies", "animal"),
        ("geese", "animal"),
        ("batteries", "object"),
        ("torches", "object"),
        ("galleries", "place"),
        ("woods", "place"),
        ("children", "person"),
        ("cacti", "object"),
        ("glasses", "object"),
    ],
)
def test_a_plural_is_of_the_kind_of_its_noun(plural: str, kind: str) -> None:
    assert kind_of(plural) == kind


def test_the_plural_of_what_is_abstract_is_abstract() -> None:
    assert is_abstract("theories")
    assert is_abstract("prices")


@pytest.mark.parametrize(
    ("compound", "kind"),
    [
        # the last noun decides ...
        ("oxygen bottle", "object"),
        ("control room", "place"),
        ("fire extinguisher", "object"),
        ("night nurse", "person"),
        ("sea lion", "animal"),
        ("guide dog", "animal"),
        ("loading dock", "place"),
        ("temperature sensor", "object"),
        # ... unless the compound is known by itself
        ("parking lot", "place"),
        ("first aid kit", "object"),
        ("traffic light", "object"),
        ("hot dog", "object"),
        ("fire stations", "place"),
    ],
)
def test_the_last_noun_of_a_compound_decides_unless_the_compound_is_known(compound: str, kind: str) -> None:
    assert kind_of(compound) == kind


def test_what_is_abstract_is_told_by_the_last_noun_before_a_preposition() -> None:
    assert is_abstract("the price of the crate")
    assert is_abstract("kitchen temperature")
    assert not is_abstract("the crate of knowledge")
    assert not is_abstract("gizmo")
    assert not is_abstract("")


def test_a_given_name_is_no_noun_if_it_stands_by_itself_with_a_capital() -> None:
    assert kind_of("Jack") is None
    assert kind_of("jack") == "object"
    assert kind_of("JACK") == "object"
    assert kind_of("the jack") == "object"
    assert not is_abstract("Hope")
    assert is_abstract("hope")


def test_a_name_that_is_hardly_ever_a_noun_is_none() -> None:
    names = ["Anna", "Bob", "Carl", "Leo", "Otto", "Thomas", "Emma", "Rex", "Tim", "Maria", "James"]
    assert [name for name in names if kind_of(name) is not None or is_abstract(name)] == []


def test_every_noun_stands_under_one_base_kind() -> None:
    lists = yaml.safe_load(Path(kinds.__file__).with_name("kinds.yaml").read_text(encoding="utf-8"))
    assert tuple(lists) == BASE_KINDS
    nouns = [noun for listed in lists.values() for noun in listed]
    assert [noun for noun in nouns if not isinstance(noun, str) or noun != noun.lower()] == []
    assert sorted(noun for noun in set(nouns) if nouns.count(noun) > 1) == []


def test_the_list_made_by_hand_has_the_last_word() -> None:
    lists = yaml.safe_load(Path(kinds.__file__).with_name("kinds.yaml").read_text(encoding="utf-8"))
    for kind, nouns in lists.items():
        assert [noun for noun in nouns if kind_of(noun) != kind or is_abstract(noun)] == []


def test_the_table_has_the_form_that_its_generator_writes() -> None:
    path = Path(kinds.__file__).with_name("nouns.txt")
    text = path.read_text(encoding="ascii")
    assert len(text) < 350_000
    assert text.endswith("\n")
    assert "WordNet 3.0 Copyright 2006 by Princeton University" in text, "the licence goes with every copy"
    lists = {}
    for line in text.splitlines():
        if not line.startswith("#"):
            kind, _, listed = line.partition(": ")
            lists[kind] = listed.split(", ")
    assert tuple(lists) == (*BASE_KINDS, "abstract", "names")
    assert all(words == sorted(set(words)) for words in lists.values()), "sorted, nothing twice"
    nouns = [noun for kind, words in lists.items() if kind != "names" for noun in words]
    assert 12_000 < len(nouns) == len(set(nouns)), "no noun is of two kinds"
    assert [noun for noun in nouns if not noun.replace(" ", "").isalpha() or noun != noun.lower()] == []
