"""What trying everything out makes of a draft, and what it proves."""

from __future__ import annotations

from collections.abc import Callable

from missiontree.mission.certificate import Certificate
from missiontree.mission.ticks import seconds
from missiontree.scheduling.enumeration.trying import Trying, too_many
from missiontree.scheduling.problem import Draft, Problem
from missiontree.scheduling.replay import replay


def tried_out(
    problem: Problem,
    best: Draft | None,
    horizon: Callable[[], int],
    most_steps: int,
    ended: Callable[[], bool],
    anyway: bool = False,
) -> tuple[Draft | None, Certificate | None]:
    """
    The best draft after everything that could be better was tried, and the proof of it.

    What robots can refill is taken to last for ever there. So a draft that came to be longer, by visits to chargers or for whatever reason,
    is put to the proof anew.

    Parameters
    ----------
    problem
        The alternative.
    best
        The draft so far; None if there is none.
    horizon
        Asked, if there is no draft, for the ticks by which every schedule of interest is over; of a draft, only what is shorter is
        of interest.
    most_steps
        Steps after which to give up. The same steps are taken every time.
    ended
        Asked now and then whether to stop.
    anyway
        Whether to try also where nothing can be proven. Default false.

    Returns
    -------
    The draft, and None in place of the proof if that was given up. Without a draft, the proof is that there is no schedule.
    """
    if too_many(problem):
        return best, None
    limit = horizon() if best is None else best.makespan - 1
    tried = Trying(problem, limit, most_steps, ended, anyway)()
    if tried.course is not None:
        draft = replay(problem, tried.course)
        if draft is None:
            return best, None
        longer = draft.makespan > tried.makespan
        best = draft if best is None or draft.value < best.value else best
        if longer:
            tried = Trying(problem, best.makespan - 1, most_steps, ended, anyway)()
            if tried.course is not None:  # nobody has shown that it can be carried out: it proves nothing
                return best, None
    if not tried.complete:
        return best, None
    makespan = None if best is None else best.makespan
    return best, proof_of("enumeration", "Everything that could be was tried", makespan)


def proof_of(method: str, how: str, makespan: int | None) -> Certificate:
    """
    The certificate that no schedule is shorter than so many ticks.

    Parameters
    ----------
    method, how
        How that is known: the name of the method, and in words.
    makespan
        In ticks; None if there is no schedule at all.
    """
    what = "there is no schedule" if makespan is None else f"no schedule is shorter than {seconds(makespan):g} s"
    bound = None if makespan is None else seconds(makespan)
    return Certificate(claim="proven", method=method, bound=bound, detail=f"{how}: {what}.")
