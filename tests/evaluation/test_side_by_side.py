"""Work side by side: the bound is kept, tasks are drawn late, and what is raised is raised."""

from collections.abc import Iterator
from threading import Barrier, Event, Lock

import pytest

from missiontree.evaluation.side_by_side import side_by_side


def test_one_at_a_time_is_in_order() -> None:
    assert list(side_by_side(range(5), lambda n: n * n, 1)) == [(0, 0), (1, 1), (2, 4), (3, 9), (4, 16)]


def test_as_many_as_the_bound_are_done_at_once() -> None:
    """Three tasks wait for each other; were only two begun, none would end."""
    together = Barrier(3)
    assert sorted(side_by_side(range(6), lambda n: together.wait(60) >= 0, 3)) == [(n, True) for n in range(6)]


def test_never_more_than_the_bound_are_done_at_once() -> None:
    lock, under_way, most = Lock(), set[int](), list[int]()

    def work(number: int) -> None:
        with lock:
            under_way.add(number)
            most.append(len(under_way))
        with lock:
            under_way.discard(number)

    assert len(list(side_by_side(range(200), work, 4))) == 200
    assert max(most) <= 4


def test_each_is_handed_out_as_it_is_done() -> None:
    """The first waits until the second has been handed out."""
    go_on = Event()

    def work(number: int) -> bool:
        return go_on.wait(60) if number == 0 else True

    order = []
    for number, done in side_by_side(range(2), work, 2):
        assert done
        order.append(number)
        go_on.set()
    assert order == [1, 0]


def test_a_task_is_drawn_only_when_it_can_be_begun() -> None:
    drawn: list[int] = []

    def tasks() -> Iterator[int]:
        for number in range(9):
            drawn.append(number)
            yield number

    for _ in side_by_side(tasks(), lambda n: n, 2):
        break
    assert len(drawn) <= 3


def test_whatever_a_task_raises_is_raised_where_results_are_read() -> None:
    def work(number: int) -> float:
        return 1 / number

    with pytest.raises(ZeroDivisionError):
        list(side_by_side([1, 0, 1], work, 1))


def test_no_tasks_are_no_results() -> None:
    assert list(side_by_side([], lambda n: n, 3)) == []
