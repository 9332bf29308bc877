"""Sets of teams, and the parts into which they fall around one."""

from __future__ import annotations

from itertools import combinations

from hypothesis import given
from hypothesis import strategies as st

from missiontree.allocation.teams import Team, Teams

TYPES = ("a", "b", "c", "d")
ALL = [frozenset(team) for size in range(5) for team in combinations(TYPES, size)]


def held(teams: Teams) -> set[Team]:
    return {team for team in ALL if teams.within <= team and not teams.without & team}


def test_the_parts_around_a_team_by_hand() -> None:
    """Without a; with a, without b; with both, and c."""
    parts = list(Teams().around(frozenset("ab"), ("a", "b", "c")))
    assert parts == [
        Teams(without=frozenset("a")),
        Teams(without=frozenset("b"), within=frozenset("a")),
        Teams(within=frozenset("abc")),
    ]


@given(st.sets(st.sampled_from(TYPES)), st.sets(st.sampled_from(TYPES)), st.data())
def test_the_parts_do_not_overlap_and_hold_all_other_teams(
    within: set[str], without: set[str], data: st.DataObject
) -> None:
    teams = Teams(frozenset(without - within), frozenset(within))
    team = data.draw(st.sampled_from(sorted(held(teams), key=sorted)))
    parts = [held(part) for part in teams.around(team, data.draw(st.permutations(TYPES)))]
    assert sum(map(len, parts)) == len(set().union(*parts))
    assert set().union(*parts) == held(teams) - {team}
