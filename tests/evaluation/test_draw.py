"""A third is set aside, the same third each time."""

from missiontree.evaluation.draw import set_aside

IDS = {"farm": [f"farm-{number:02}" for number in range(36)], "home": [f"home-{number:02}" for number in range(7)]}


def test_a_third_of_each_setting_is_drawn() -> None:
    drawn = set_aside(IDS, 1)
    # 36 / 3 = 12, and 7 / 3 = 2.33, which is 2.
    assert [sum(mission.startswith(name) for mission in drawn) for name in IDS] == [12, 2]


def test_the_draw_depends_on_seed_and_ids_alone() -> None:
    backwards = {name: list(reversed(IDS[name])) for name in reversed(IDS)}
    assert set_aside(IDS, 1) == set_aside(backwards, 1)
    assert set_aside(IDS, 1) != set_aside(IDS, 2)
    # Written down once: it must not change with the Python version.
    assert set_aside({"farm": IDS["farm"][:6]}, 20250127) == DRAWN


def test_a_setting_that_is_added_leaves_the_others_as_they_were() -> None:
    assert set_aside(IDS, 1) > set_aside({"farm": IDS["farm"]}, 1)


DRAWN = frozenset({"farm-01", "farm-04"})
