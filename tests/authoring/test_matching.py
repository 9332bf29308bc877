import pytest

from missiontree.authoring.matching import (
    did_you_mean,
    is_misspelt,
    is_near,
    listed,
    same_name,
    suggestions,
    without_articles,
    words_of,
)


def test_names_are_the_same_up_to_letter_case_and_blanks() -> None:
    assert same_name("  Safe   AREA ") == same_name("safe area")


def test_a_letter_and_its_composed_form_are_the_same() -> None:
    """ "ü" may be one code point or "u" with a diaeresis put after it."""
    assert same_name("J\u00fcngster") == same_name("Ju\u0308ngster")


def test_words_leave_punctuation_and_case_aside() -> None:
    assert words_of("Reach, then: transport!") == ("reach", "then", "transport")


def test_articles_are_left_aside() -> None:
    assert without_articles("Locate the Lost Child") == ("locate", "lost", "child")


def test_a_letter_that_tells_things_apart_is_no_article() -> None:
    """ "Gate A" is one gate of several; who says "gate" may mean any of them."""
    assert without_articles("Go to a gate") == ("go", "to", "gate")
    assert without_articles("A gate") == ("gate",)
    assert without_articles("Gate A") == without_articles("gate a") == ("gate", "a")
    assert without_articles("From Gate A to the Dock") == ("from", "gate", "a", "to", "dock")
    assert not is_near("Fetch specimenB", "Fetch specimen A")


@pytest.mark.parametrize(
    ("name", "other"),
    [
        ("Reunite the Child with Mom", "Reunite the child and mom"),  # the paper's own slip
        ("Locate the chlid", "Locate the child"),
        ("Locate the childd", "Locate the child"),
        ("Locate the chold", "Locate the child"),
    ],
)
def test_near_names(name: str, other: str) -> None:
    """Linking words differ, or one letter of a word of five letters or more."""
    assert is_near(name, other)
    assert is_near(other, name)


@pytest.mark.parametrize(
    ("name", "other"),
    [
        ("Locate the chil", "Locate the child"),
        ("Find cat", "Find bat"),  # short words are words of their own
        ("Inspect room 1", "Inspect room 2"),
        ("Inspect room12345", "Inspect room12346"),
        ("Find mom", "Find mom quickly"),
        ("Bring child mother", "Bring mother child"),
        ("the", "a"),
        ("the", "a gate"),
        ("", ""),
    ],
)
def test_names_that_are_not_near(name: str, other: str) -> None:
    assert not is_near(name, other)


def test_look_alike_letters_never_match() -> None:
    """The second "Locate" has a Cyrillic "о", U+043E; one changed letter otherwise makes a near name."""
    assert is_near("Lacate child", "Locate child")
    assert not is_near("L\u043ecate child", "Locate child")
    assert same_name("L\u043ecate") != same_name("Locate")
    assert same_name("\uff2cocate") != same_name("Locate"), "full-width letters are other letters"


@pytest.mark.parametrize(
    ("disguised", "plain"),
    [
        ("tran\u017fporter", "transporter"),  # long s
        ("\u212aid", "Kid"),  # Kelvin sign
        ("\ufb01refighter", "firefighter"),  # ligature of f and i
        ("\ufb06ation", "station"),  # ligature of s and t
    ],
)
def test_letters_that_fold_to_plain_ones_do_not_pass_for_them(disguised: str, plain: str) -> None:
    """Unicode folds them together with letter case; each is another name here, and its own."""
    assert disguised.casefold() == plain.casefold() or disguised.startswith("\u212a")
    assert same_name(disguised) != same_name(plain)
    assert words_of(f"the {disguised}") != words_of(f"the {plain}")
    assert same_name(f" {disguised}  A") == same_name(f"{disguised} a")


def test_letter_case_beyond_plain_letters_stays_aside() -> None:
    """Capitals of "ß" are "SS", and a sigma at the end of a word is a sigma."""
    assert same_name("STRASSE") == same_name("Straße")
    assert same_name("JÜNGSTER ΟΔΟΣ") == same_name("jüngster οδος")


def test_a_parent_is_not_near_by_a_look_alike_of_its_own_script() -> None:
    """ "ɑ" is a Latin alpha, "ı" a Latin i without a dot; an accent is a slip of the pen and may be one."""
    assert not is_near("Sp\u0251re task", "Spare task")
    assert not is_near("v\u0131sit patient", "visit patient")
    assert is_near("Spáre task", "Spare task")


def test_suggestions_come_nearest_first() -> None:
    assert suggestions("SerchTree", ["ReachTree", "SearchTree", "Unlike"])[0] == "SearchTree"
    assert did_you_mean("zzz", ["SearchTree"]) == ""


def test_long_lists_say_how_much_is_left_out() -> None:
    # 25 names, 20 shown, hence 5 more.
    assert listed([f"n{number}" for number in range(25)]).endswith("n19 and 5 more")
    assert listed([]) == "none"


def test_misspelt_is_an_accent_or_one_letter_of_a_word_of_four() -> None:
    assert all(
        is_misspelt(*pair) for pair in (("Ötto", "otto"), ("Li", "Lí"), ("toolbix", "Toolbox"), ("Wardd 3", "ward_3"))
    )
    # A word of three letters, a number and a second slip make another name.
    assert not any(is_misspelt(*pair) for pair in (("cat", "cart"), ("Ward 3", "Ward 4"), ("Otta", "Utto"), ("", "")))
