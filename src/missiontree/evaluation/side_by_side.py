"""Work done side by side, never more than so much at a time."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from queue import SimpleQueue
from threading import Thread
from typing import Generic, TypeVar

T = TypeVar("T")
R = TypeVar("R")


def side_by_side(tasks: Iterable[T], work: Callable[[T], R], bound: int) -> Iterator[tuple[T, R]]:
    """
    Do tasks in threads, and hand out each with its result once it is done.

    A task is taken from ``tasks`` only when it can be begun, so that whoever hands them out can still leave some out. What is under
    way when the caller stops asking is neither waited for nor handed out: the threads do not keep the program from ending.

    Parameters
    ----------
    tasks
        What is to be done, in this order.
    work
        Does a task; whatever it raises is raised here.
    bound
        Most tasks at a time, at least 1.
    """
    crew = _Crew(work, bound)
    waiting = iter(tasks)
    try:
        under_way = sum(crew.begin(task) for _, task in zip(range(bound), waiting, strict=False))
        while under_way:
            task, outcome = crew.done.get()
            under_way -= 1
            if isinstance(outcome, _Raised):
                raise outcome.error
            yield task, outcome
            under_way += sum(crew.begin(task) for _, task in zip(range(bound - under_way), waiting, strict=False))
    finally:
        crew.go_home()


class _Raised:
    """What a task raised instead of coming to a result."""

    def __init__(self, error: BaseException) -> None:
        self.error = error


class _Crew(Generic[T, R]):
    """Threads that take tasks from one queue and put results into another."""

    def __init__(self, work: Callable[[T], R], size: int) -> None:
        self.done: SimpleQueue[tuple[T, R | _Raised]] = SimpleQueue()
        self._work, self._todo = work, SimpleQueue[tuple[T] | None]()
        self._threads = [Thread(target=self._serve, daemon=True) for _ in range(size)]
        for thread in self._threads:
            thread.start()

    def begin(self, task: T) -> bool:
        self._todo.put((task,))
        return True

    def go_home(self) -> None:
        for _ in self._threads:
            self._todo.put(None)

    def _serve(self) -> None:
        while (given := self._todo.get()) is not None:
            try:
                outcome: R | _Raised = self._work(given[0])
            except BaseException as error:
                outcome = _Raised(error)
            self.done.put((given[0], outcome))
