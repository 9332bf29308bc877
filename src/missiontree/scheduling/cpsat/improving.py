"""From a greedy draft to the best that constraint programming finds in the time given, and what is known of it then."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import cached_property

from missiontree.mission.alternative import Alternative
from missiontree.mission.certificate import Certificate
from missiontree.mission.control import Control, Progress
from missiontree.mission.reason import Reason
from missiontree.mission.schedule import Schedule
from missiontree.mission.ticks import seconds
from missiontree.scheduling.cpsat.formulation import Formulation
from missiontree.scheduling.cpsat.hint import hint
from missiontree.scheduling.cpsat.model import Model
from missiontree.scheduling.cpsat.search import Effort, Found, search
from missiontree.scheduling.cpsat.second import SecondForm
from missiontree.scheduling.cpsat.settings import Settings
from missiontree.scheduling.cpsat.unsupported import TimeIsUpError, UnsupportedError
from missiontree.scheduling.cpsat.verify import broken
from missiontree.scheduling.enumeration.proving import proof_of, tried_out
from missiontree.scheduling.horizon import horizon_of
from missiontree.scheduling.neighbourhood.search import Regrouping, regrouped
from missiontree.scheduling.problem import Draft, Problem
from missiontree.scheduling.replay import replay
from missiontree.scheduling.spanning import spanning_bound
from missiontree.scheduling.writing import by_bound, found_schedule, no_schedule, unknown_schedule

WRITING = 0.3  # what it takes to verify, replay and write an answer, in units of what it took to build the model
MANY_ROLES = 25  # from which on solving the model as a whole seldom helps
FEW_ROUNDS, MANY_ROUNDS = 200, 3000  # of regrouping in smaller missions, and where robots refill and time is no matter
FEW_ROLES, ROUNDS_EACH = 6, 100  # of missions in which that is a matter of moments; rounds for each role
REGROUPING = 0.6  # of the time left, at most
SHARE = 0.85  # of the time left, for the makespan; half of the rest for its proof


class Improving:
    """
    One alternative under improvement.

    Parameters
    ----------
    problem, alternative
        What is scheduled.
    control, settings
        Limits.
    best
        The draft so far; None if there is none.
    failures
        Why there is none.
    """

    def __init__(
        self,
        problem: Problem,
        alternative: Alternative,
        control: Control,
        settings: Settings,
        best: Draft | None,
        failures: list[Reason],
    ) -> None:
        self._problem, self._alternative, self._control, self._settings = problem, alternative, control, settings
        self._best, self._failures = best, failures
        self._begun = control.clock()
        self._bound = problem.bounds.makespan  # by whoever's word
        self._answers = 0
        self._limit = ""  # why the model was not asked
        self._unsupported = False  # whether it does not express all there is
        self._impossible = False
        self._kept_s = 0.0  # of the time, for making a schedule of the last answer
        self._shown: int | None = None  # the makespan that was told of last

    def __call__(self) -> Schedule:
        """Improve, prove, and write it down."""
        self._span()
        proof = self._tried(self._settings.first_steps)
        if proof is not None and (self._best is None or not self._settings.tidy):
            return self._written(proof)
        if proof is None:
            self._regroup()
        formulation = None if self._met() else self._formulation()
        if formulation is None:
            if self._unsupported and proof is None and not self._closed():
                proof = self._tried(self._settings.last_steps, anyway=True)  # nobody else would look any further
            return self._written(proof)
        if proof is None and self._least_makespan(formulation):
            proof = self._confirmed() or self._tried(self._settings.last_steps)
        if proof is None and not self._closed():  # what the solver found, if anything, nobody could play through
            proof = self._tried(self._settings.last_steps, anyway=True)
        if self._best is not None and self._settings.tidy and (proof is not None or self._closed()):
            self._tidy(formulation)
        return self._written(proof)

    def _span(self) -> None:
        """The bound by spanning trees, where there was no time for it before."""
        problem, bounds = self._problem, self._problem.bounds
        given = (problem.graph, problem.staffing, bounds.duration, bounds.lag, bounds.tails, problem.places)
        team = (problem.fleet, problem.trips, problem.chargers)
        spanned = spanning_bound(*given, *team, many=self._settings.spanned, over=self._over)
        if spanned > bounds.makespan:
            self._problem = replace(problem, bounds=replace(bounds, makespan=spanned, method="spanning_tree"))
            self._bound = spanned

    def _met(self) -> bool:
        """Whether the best meets a bound of our own, and nothing is to be tidied."""
        makespan = None if self._best is None else self._best.makespan
        return makespan == self._problem.bounds.makespan and not self._settings.tidy

    def _regroup(self) -> None:
        """Search large neighbourhoods of the draft: long where the model of the mission is too large to be solved, else shortly."""
        if self._best is None:
            return
        roles, given = len(self._problem.graph.roles), self._settings.regrouping
        rounds = FEW_ROUNDS if roles < MANY_ROLES else None
        blind = bool(self._problem.chargers) or self._problem.sharing.on_ways  # so that nothing else improves it
        patient = blind and (given is None or roles <= FEW_ROLES)
        if given is not None:
            rounds = min(FEW_ROUNDS, given // max(1, roles))
        if patient:
            rounds = min(MANY_ROUNDS, ROUNDS_EACH * roles)
        turn = self._control.clock() + REGROUPING * self._left_s()

        def over() -> bool:
            return self._control.clock() >= turn or self._over()

        short = given is not None and not patient  # the rounds alone limit it then, for the same answer every time
        search, until = Regrouping(self._control.seed, rounds, patient), self._control.ended if short else over
        self._best = regrouped(self._problem, self._best, search, until, self._shorter)

    def _shorter(self, draft: Draft) -> None:
        self._tell(self._bound, draft.makespan)

    def _say(self, draft: Draft) -> None:
        """Tell of it unless something as short was told of; the solver's last answer comes with its end, or is shorter when replayed."""
        if self._shown is None or draft.makespan < self._shown:
            self._shorter(draft)

    def _tell(self, bound: int, best: int | None) -> None:
        self._answers, self._shown = self._answers + 1, best
        shown = None if best is None else seconds(best)
        self._control.report(Progress("scheduling", self._answers, int(best is not None), seconds(bound), shown))

    def _closed(self) -> bool:
        """Whether nothing is shorter than the best, by whoever's word."""
        return self._best is not None and self._best.makespan == self._bound

    def _formulation(self) -> Formulation | None:
        """The model; None if it cannot say all there is, or is too large, or nobody waits for what it might say."""
        if self._control.ended():
            return None
        try:
            begun = self._control.clock()
            formulation = Formulation(self._problem, self._horizon(), self._over)
            self._kept_s = WRITING * (self._control.clock() - begun)
        except TimeIsUpError:
            return None
        except UnsupportedError as error:
            self._unsupported, self._limit = True, f" Constraint programming was not asked: {error}."
            return None
        if self._settings.largest is not None and formulation.model.size > self._settings.largest:
            self._limit = " The mission is too large for constraint programming in a short time."
            return None
        return formulation

    # --- solving ----------------------------------------------------------------------------------------------------

    def _horizon(self) -> int:
        return self._best.makespan if self._best is not None else self._latest

    @cached_property
    def _latest(self) -> int:
        return horizon_of(self._problem)

    def _left_s(self) -> float:
        control = self._control
        left = self._settings.longest_s - (control.clock() - self._begun)
        if control.time_limit_s is not None:
            left = min(left, control.time_limit_s - (control.clock() - control.started))
        return max(0.0, left)

    def _search(
        self, model: Model, share: float, heard: Callable[[Found], None] | None = None, plain: bool = False
    ) -> Found:
        limit = (self._left_s() - self._kept_s) * share
        if limit <= 0 or self._control.ended():
            return Found()
        effort = Effort(self._control.seed, self._settings.deterministic, plain=plain)
        return search(model, limit, self._control.ended, effort, heard, self._control.clock)

    def _least_makespan(self, formulation: Formulation) -> bool:
        """Whether the solver says that no schedule is shorter than the best."""
        if self._best is not None:
            hint(formulation, self._best)
        found = self._search(formulation.model, SHARE, self._heard)
        if found.bound is not None and found.bound <= self._horizon():
            self._bound = max(self._bound, found.bound)
        if not self._take(formulation, found) and formulation.keep_to_orders():
            self._take(formulation, self._search(formulation.model, SHARE))
        if found.verdict == "infeasible" and self._best is None:
            self._impossible = True
            return True
        return self._closed()

    def _tidy(self, formulation: Formulation) -> None:
        """With the makespan kept, as little travel as possible, and then every end as early as possible."""
        assert self._best is not None
        if self._control.ended():
            return
        if formulation.minimise_travel(self._best.makespan):
            hint(formulation, self._best)
            self._take(formulation, self._search(formulation.model, 0.6))
        formulation.minimise_ends(formulation.travel_mm(self._best))
        hint(formulation, self._best)
        self._take(formulation, self._search(formulation.model, 1.0))

    def _take(self, formulation: Formulation, found: Found) -> bool:
        """Make an answer the best draft, if it is a schedule by our own means and better; False if it is none."""
        if not found.values:
            return True
        if any(broken(formulation.model, found.values)):
            return False
        draft = replay(self._problem, formulation.course(found.values))
        if draft is not None and (self._best is None or draft.value < self._best.value):
            self._best = draft
            self._say(draft)
        return draft is not None

    def _heard(self, found: Found) -> None:
        best = self._best.makespan if self._best is not None else None
        if found.values and found.objective is not None:
            best = found.objective if best is None else min(best, found.objective)
        self._tell(max(self._bound, found.bound or 0), best)

    # --- proving ----------------------------------------------------------------------------------------------------

    def _tried(self, most_steps: int, anyway: bool = False) -> Certificate | None:
        """The certificate of having tried everything that could be better; None if that is too much, or proves nothing."""
        before = self._best
        self._best, proof = tried_out(self._problem, before, self._horizon, most_steps, self._over, anyway)
        if self._best is not None and self._best is not before:
            self._say(self._best)
        return proof

    def _over(self) -> bool:
        return self._left_s() <= 0 or self._control.ended()

    def _confirmed(self) -> Certificate | None:
        """The certificate that a second formulation gives to the solver's word; None if it does not."""
        makespan = None if self._best is None else self._best.makespan
        if makespan == self._problem.bounds.makespan:
            return by_bound(self._problem, self._best) if self._best is not None else None
        try:
            second = SecondForm(self._problem, self._horizon() - (makespan is not None), self._over)
        except TimeIsUpError:
            return None
        if second.too_large or self._search(second.model, 0.5, plain=True).verdict != "infeasible":
            return None
        return proof_of(
            "second_formulation", "A second formulation, of another kind, was found to have no answer", makespan
        )

    def _written(self, proof: Certificate | None = None) -> Schedule:
        if self._best is None:
            return self._none(proof)
        certificate = proof or by_bound(self._problem, self._best)
        if certificate.claim != "proven" and self._bound > self._problem.bounds.makespan:
            certificate = self._by_word(self._best.makespan)
        if self._limit:
            certificate = Certificate(
                claim=certificate.claim,
                method=certificate.method,
                bound=certificate.bound,
                detail=certificate.detail + self._limit,
            )
        return found_schedule(self._problem, self._alternative, self._best, certificate)

    def _by_word(self, makespan: int) -> Certificate:
        own = f"our own bound is {seconds(self._problem.bounds.makespan):g} s."
        detail = (
            f"Optimal by the solver's word, which nothing confirms; {own}"
            if makespan == self._bound
            else f"No schedule is shorter than {seconds(self._bound):g} s by the solver's word; {own}"
        )
        return Certificate(claim="solver_word", method="cp_sat", bound=seconds(self._bound), detail=detail)

    def _none(self, proof: Certificate | None) -> Schedule:
        if proof is not None:
            return no_schedule(self._alternative, proof, self._failures)
        certificate = None
        if self._impossible:
            certificate = Certificate(
                claim="unproven",
                method="cp_sat",
                bound=seconds(self._problem.bounds.makespan),
                detail="There is no schedule by the solver's word, which nothing confirms.",
            )
        return unknown_schedule(self._problem, self._alternative, self._failures, certificate)
