"""The dialogue from the model's side: what it is told, what is done of what it says, and when it ends."""

from __future__ import annotations

import itertools
import json
from collections.abc import Mapping, Sequence
from dataclasses import replace

import pytest

from missiontree.authoring.author import author_tree
from missiontree.authoring.budgets import Budgets
from missiontree.authoring.dialogue import Company
from missiontree.authoring.offline import author_offline
from missiontree.authoring.outcome import Authored
from missiontree.authoring.transcript import replay
from missiontree.llm.chat import Finish, Message, ProviderError, Tool, ToolCall, Usage
from missiontree.llm.history import sendable
from missiontree.mission.brief import MissionBrief
from missiontree.mission.control import Control, Progress
from missiontree.mission.fleet import Fleet, RobotType
from tests.authoring.conftest import REUNITE

INIT = ("HierarchicalTree_init", {"objective": REUNITE})
SEARCH = (
    "attachMultiSubTrees",
    {"parentString": REUNITE, "treeNames": ["SearchTree"], "treeArguments": [["Child"]], "LogicalConstraint": "AND"},
)
BRING = (
    "attachMultiSubTrees",
    {
        "parentString": REUNITE,
        "treeNames": ["ReachAndTransportTree"],
        "treeArguments": [["Child", "Mom"]],
        "LogicalConstraint": "AND",
        "constraintPairs": [["SearchTree(Child)", 0]],
    },
)
DONE = Message("assistant", "All is right.")


def said(*calls: tuple[str, Mapping[str, object]], finish: Finish = "stop", text: str = "") -> Message:
    made = tuple(ToolCall("x", name, json.dumps(arguments)) for name, arguments in calls)
    return Message("assistant", text, made, finish=finish, usage=Usage(10, 5))


class Player:
    """A model of fixed messages that keeps what it was sent."""

    def __init__(self, *messages: Message | Exception | KeyboardInterrupt) -> None:
        self.left, self.heard = list(messages), list[tuple[Message, ...]]()
        self.tools = list[tuple[str, ...]]()

    def __call__(self, messages: Sequence[Message], tools: Sequence[Tool]) -> Message:
        self.heard.append(tuple(messages))
        self.tools.append(tuple(tool.name for tool in tools))
        message = self.left.pop(0)
        if isinstance(message, BaseException):
            raise message
        return message


def declare(missing: str) -> Message:
    return said(("declareImpossible", {"missing": missing, "reason": "Nobody can."}))


def rules(made: Authored) -> list[str]:
    return [reason.rule for reason in made.reasons]


def test_a_finished_tree_is_reviewed_with_the_answer_that_completes_it(brief: MissionBrief) -> None:
    model = Player(said(INIT, SEARCH), DONE)
    made = author_tree(brief, model)
    assert made.status == "complete"
    first, last = (json.loads(message.text) for message in model.heard[1][-2:])
    assert "review" not in first
    assert "Now review the tree" in last["review"]
    assert "Search(Child)" in last["tree"]


def test_a_tree_that_is_not_finished_is_not_reviewed(brief: MissionBrief) -> None:
    tasks = {"parentString": REUNITE, "taskName": "Find", "isPrimitive": False, "LogicalConstraint": "AND"}
    model = Player(said(INIT, ("CreateAndAddSubtask", tasks)), *[DONE] * 3)
    assert author_tree(brief, model).status == "incomplete"
    assert all("review" not in message.text for heard in model.heard for message in heard[2:])


def test_a_call_that_is_refused_brings_no_review(brief: MissionBrief) -> None:
    """The tree is finished, but the model has just been told that something went wrong; the review comes when it stops."""
    model = Player(said(INIT, SEARCH, ("setLink", {"first": "a", "second": "b"})), DONE, DONE)
    assert author_tree(brief, model).status == "complete"
    assert "review" not in model.heard[1][-1].text
    assert model.heard[2][-1].speaker == "user"
    assert "Now review the tree" in model.heard[2][-1].text


def test_a_tree_that_has_grown_since_is_reviewed_once_more(brief: MissionBrief) -> None:
    model = Player(said(INIT, SEARCH), said(BRING), DONE, said(), DONE)
    made = author_tree(brief, model)
    assert made.status == "complete"
    assert made.tree is not None
    assert [node.routine for node in made.tree.nodes if node.routine] == ["Search", "ReachAndTransport"]
    assert len(model.heard) == 4
    assert "Now review the tree" in model.heard[3][-1].text


def test_a_mended_tree_that_has_not_grown_is_not_reviewed_again(brief: MissionBrief) -> None:
    wrong = dict(BRING[1]) | {"treeNames": ["SearchTree", "ReachTree"], "treeArguments": [["Child"], ["Mom"]]}
    wrong |= {"constraintPairs": [[0, 1]]}
    turned = [
        ("dropLink", {"first": "search-child", "second": "reach-mom"}),
        ("setLink", {"first": "reach-mom", "second": "search-child"}),
    ]
    model = Player(said(INIT, ("attachMultiSubTrees", wrong)), said(*turned), DONE)
    made = author_tree(brief, model)
    assert made.status == "complete"
    assert made.tree is not None
    assert [(link.first, link.second) for link in made.tree.links] == [("reach-mom", "search-child")]


def test_a_review_that_breaks_the_tree_does_not_pass(brief: MissionBrief) -> None:
    broken = said(("removeSubtask", {"subtask": "search-child"}))
    made = author_tree(brief, Player(said(INIT, SEARCH), broken, DONE, DONE, DONE))
    assert (made.status, rules(made)) == ("incomplete", ["open_leaf"])


def test_reviews_can_be_left_out(brief: MissionBrief) -> None:
    model = Player(said(INIT, SEARCH), DONE)
    assert author_tree(brief, model, Budgets(reviews=0)).status == "complete"
    assert "review" not in model.heard[1][-1].text


def test_nothing_of_an_answer_that_was_cut_is_done(brief: MissionBrief) -> None:
    model = Player(said(INIT, SEARCH, finish="length", text="I think"), said(INIT, SEARCH), DONE)
    made = author_tree(brief, model)
    assert made.status == "complete"
    assert made.spent is not None
    assert (made.spent.calls, made.spent.refused) == (2, 0)
    told = model.heard[1]
    assert [message.speaker for message in told] == ["system", "user", "assistant", "user"]
    assert told[2].calls == (), "history holds no call without an answer"
    assert told[3].must_call
    assert "cut off" in told[3].text


def test_answers_that_are_always_cut_end_the_dialogue(brief: MissionBrief) -> None:
    cut = said(INIT, finish="length")
    made = author_tree(brief, Player(*[cut] * 3), Budgets(refusals=3))
    assert (made.status, made.reasons[0].needed, made.tree) == ("exhausted", "refusals one after the other", None)


@pytest.mark.parametrize("finish", ["filtered", "refused"])
def test_an_unwilling_model_fails_and_nothing_of_it_is_done(brief: MissionBrief, finish: Finish) -> None:
    made = author_tree(brief, Player(said(INIT), said(SEARCH, finish=finish, text="I will not.")))
    assert (made.status, rules(made)) == ("provider_failed", [f"provider_{finish}"])
    assert made.reasons[0].hint == "It said: I will not."
    assert made.tree is not None
    assert len(made.tree.nodes) == 1


def test_a_provider_that_fails_keeps_the_tree_so_far(brief: MissionBrief) -> None:
    fault = ProviderError("no answer within 60 s", "timed_out", hint="Try later.")
    made = author_tree(brief, Player(said(INIT), fault))
    assert (made.status, rules(made), made.reasons[0].hint) == ("provider_failed", ["provider_timed_out"], "Try later.")
    assert made.tree is not None


def test_an_interruption_keeps_the_tree_so_far(brief: MissionBrief) -> None:
    made = author_tree(brief, Player(said(INIT, SEARCH), KeyboardInterrupt()))
    assert (made.status, rules(made)) == ("exhausted", ["interrupted"])
    assert made.tree is not None
    assert len(made.tree.nodes) == 2
    assert replay(made.transcript, brief).tree == made.tree


def test_a_stop_token_is_heeded_between_turns(brief: MissionBrief) -> None:
    asked: list[bool] = []

    def stop() -> bool:
        asked.append(True)
        return len(asked) > 1

    made = author_tree(brief, Player(said(INIT)), company=Company(control=Control(stop=stop)))
    assert (made.status, rules(made)) == ("exhausted", ["interrupted"])


def test_seconds_run_out_by_the_clock_handed_in(brief: MissionBrief) -> None:
    now = [0.0]

    def model(messages: Sequence[Message], tools: Sequence[Tool]) -> Message:
        now[0] += 40.0
        return said(INIT)

    control = Control(clock=lambda: now[0])
    made = author_tree(brief, model, Budgets(seconds=100, refusals=99, repeats=99), company=Company(control=control))
    assert (made.status, made.reasons[0].needed) == ("exhausted", "seconds")
    assert made.spent is not None
    assert made.spent.turns == 3, "at 0, 40 and 80 seconds; at 120 no further turn begins"


def test_tokens_run_out(brief: MissionBrief) -> None:
    made = author_tree(brief, Player(said(INIT), said(SEARCH)), Budgets(tokens=30))
    assert (made.status, made.reasons[0].needed) == ("exhausted", "tokens")


def test_repeated_calls_run_out(brief: MissionBrief) -> None:
    show = ("printTree", dict[str, object]())
    made = author_tree(brief, Player(said(INIT, *[show] * 9)), Budgets(repeats=3))
    assert (made.status, made.reasons[0].needed, made.reasons[1].rule) == (
        "exhausted",
        "repeated calls",
        "repeated_call",
    )


def test_calls_get_ids_that_every_provider_takes_back(brief: MissionBrief) -> None:
    """The player gives all calls the same id; ours are nine letters and digits, each once."""
    model = Player(said(INIT, SEARCH), DONE)
    author_tree(brief, model)
    history = model.heard[-1]
    ids = [call.id for message in history for call in message.calls]
    assert ids == ["t0001c001", "t0001c002"]
    assert [message.call_id for message in history if message.speaker == "tool"] == ids


def test_progress_is_told_after_each_turn(brief: MissionBrief) -> None:
    told: list[Progress] = []
    company = Company(control=Control(report=told.append))
    author_tree(brief, Player(said(INIT), said(SEARCH), DONE), company=company)
    assert [(news.stage, news.done, news.found) for news in told][:2] == [("authoring", 1, 1), ("authoring", 2, 2)]


def test_what_it_took_is_told(brief: MissionBrief) -> None:
    made = author_tree(brief, Player(said(INIT, SEARCH), said()))
    assert made.spent is not None
    assert (made.spent.turns, made.spent.input_tokens, made.spent.output_tokens) == (2, 20, 10)
    assert (made.spent.estimated, made.spent.seconds) == (False, 0.0), "nobody was waited for"
    assert replay(made.transcript, brief).spent == made.spent


class TestDeclarations:
    """A model that gives up is held to the fleet."""

    def test_what_nobody_knows_is_missing_ends_the_dialogue(self, brief: MissionBrief) -> None:
        assert author_tree(brief, Player(declare("recommend"))).status == "cannot_be_done"

    @pytest.mark.parametrize(
        "missing", ["search", "Search", "the capability to search", "SearchTree", "ReachAndTransport", "routine Search"]
    )
    def test_what_the_fleet_has_is_not_missing(self, brief: MissionBrief, missing: str) -> None:
        model = Player(declare(missing), said(INIT, SEARCH), DONE)
        made = author_tree(brief, model)
        assert made.status == "complete"
        answer = json.loads(model.heard[1][-1].text)
        assert answer["ok"] is False
        assert answer["refused"][0]["rule"] == "declaration_contradicted"
        assert "of this fleet" in answer["refused"][0]["message"]

    def test_who_insists_against_the_fleet_is_not_believed(self, brief: MissionBrief) -> None:
        made = author_tree(brief, Player(declare("search"), declare("search robots")))
        assert made.status == "cannot_be_done", "'search robots' is another thing, and nothing speaks against it"
        made = author_tree(brief, Player(declare("search"), declare("Search")))
        assert (made.status, rules(made)) == ("incomplete", ["declaration_contradicted"] * len(made.reasons))

    def test_a_thing_of_the_scene_is_not_missing(self, scenic: MissionBrief) -> None:
        model = Player(declare("North Gate"), declare("recommend"))
        assert author_tree(scenic, model).status == "cannot_be_done"
        assert "the scene has it" in model.heard[1][-1].text

    def test_what_another_reader_can_plan_is_asked_about_once(self, brief: MissionBrief) -> None:
        company = Company(opinion=lambda: author_offline(brief))
        model = Player(declare("love"), declare("love"))
        made = author_tree(brief, model, company=company)
        assert made.status == "cannot_be_done"
        refused = json.loads(model.heard[1][-1].text)["refused"]
        assert "ReachAndTransport" in refused[0]["message"]

    def test_a_fleet_that_has_it_and_still_cannot_is_believed(self, brief: MissionBrief) -> None:
        """Another reader finds the mission impossible, so that there is a capability of that name decides nothing."""
        repair = replace(brief, text="Repair the lift")
        company = Company(opinion=lambda: author_offline(repair))
        assert author_tree(repair, Player(declare("search")), company=company).status == "cannot_be_done"

    def test_a_declaration_that_cannot_be_read_is_refused_as_any_call(self, brief: MissionBrief) -> None:
        broken = Message("assistant", calls=(ToolCall("1", "declareImpossible", '{"missing": '),))
        model = Player(broken, declare("recommend"))
        assert author_tree(brief, model).status == "cannot_be_done"
        assert "malformed_arguments" in model.heard[1][-1].text

    def test_what_was_sent_back_replays(self, brief: MissionBrief) -> None:
        made = author_tree(brief, Player(declare("search"), said(INIT, SEARCH), DONE))
        again = replay(made.transcript, brief)
        assert (again.status, again.tree) == ("complete", made.tree)
        insisted = author_tree(brief, Player(declare("search"), declare("Search")))
        assert replay(insisted.transcript, brief).status == "incomplete"


class TestUnclear:
    """A model that says what cannot be planned as it stands."""

    def unclear(self, words: str) -> Message:
        return said(("declareUnclear", {"words": words, "question": "Which child?"}))

    def test_it_ends_as_incomplete_with_the_words(self, brief: MissionBrief) -> None:
        made = author_tree(brief, Player(self.unclear("her lost child")))
        assert (made.status, rules(made)) == ("incomplete", ["declared_unclear"])
        assert made.reasons[0].found == "her lost child"
        assert made.reasons[0].message.endswith("because of 'her lost child': Which child?")
        again = replay(made.transcript, brief)
        assert (again.status, again.reasons) == ("incomplete", made.reasons)

    @pytest.mark.parametrize("words", ["her cat", "mom lost", ", "])
    def test_words_that_the_mission_does_not_have_are_refused(self, brief: MissionBrief, words: str) -> None:
        model = Player(self.unclear(words), said(INIT, SEARCH), DONE)
        assert author_tree(brief, model).status == "complete"
        assert json.loads(model.heard[1][-1].text)["refused"][0]["rule"] == "not_said"

    def test_what_another_reader_can_plan_is_asked_about_once(self, brief: MissionBrief) -> None:
        company = Company(opinion=lambda: author_offline(brief))
        model = Player(self.unclear("child"), self.unclear("child"))
        assert author_tree(brief, model, company=company).status == "incomplete"
        assert "declaration_contradicted" in model.heard[1][-1].text

    def test_nothing_is_built_after_it(self, brief: MissionBrief) -> None:
        made = author_tree(brief, Player(said(("declareUnclear", {"words": "child", "question": "Who?"}), INIT)))
        assert (made.status, made.tree) == ("incomplete", None)


class TestBesideThePoint:
    """A tree that passes the gate for a mission that the fleet cannot do."""

    @pytest.fixture
    def unable(self, brief: MissionBrief) -> MissionBrief:
        return replace(brief, fleet=Fleet((RobotType(id="scout", count=1, capabilities={"search": 1.0}),)))

    def test_the_review_says_what_speaks_against_it(self, unable: MissionBrief) -> None:
        model = Player(said(INIT, SEARCH), declare("carry"))
        company = Company(opinion=lambda: author_offline(unable))
        made = author_tree(unable, model, company=company)
        assert "takes this mission for one that cannot be done" in model.heard[1][-1].text
        assert made.status == "cannot_be_done"

    def test_a_model_that_stays_with_it_leaves_a_warning(self, unable: MissionBrief) -> None:
        company = Company(opinion=lambda: author_offline(unable))
        made = author_tree(unable, Player(said(INIT, SEARCH), DONE), company=company)
        assert made.status == "complete"
        assert {notice.rule for notice in made.notices} == {"perhaps_impossible"}
        assert replay(made.transcript, unable).notices == made.notices

    def test_a_word_that_the_other_reader_does_not_know_leaves_none(self, brief: MissionBrief) -> None:
        odd = replace(brief, text="Repair the lift")
        company = Company(opinion=lambda: author_offline(odd))
        init = ("HierarchicalTree_init", {"objective": "Repair the lift"})
        reach = ("attachMultiSubTrees", {**SEARCH[1], "parentString": "Repair the lift", "treeArguments": [["lift"]]})
        made = author_tree(odd, Player(said(init, reach), DONE), company=company)
        assert (made.status, made.notices) == ("complete", ())


@pytest.mark.parametrize(
    "strange",
    [
        said(("no such function", {"a": 1})),
        Message("assistant", "\ud800", (ToolCall("", "HierarchicalTree_init", '{"objective": "\ud800'),)),
        Message("assistant", "", ()),
    ],
)
def test_history_stays_in_a_form_that_endpoints_take(brief: MissionBrief, strange: Message) -> None:
    model = Player(strange, said(INIT, SEARCH), DONE)
    assert author_tree(brief, model).status == "complete"
    history = sendable(model.heard[-1])
    for message in history:
        message.text.encode()
        assert message.speaker != "assistant" or message.text or message.calls
    speakers = [message.speaker for message in history]
    assert all(pair != ("user", "user") for pair in itertools.pairwise(speakers))


def test_the_reasons_of_an_opinion_are_asked_for_only_in_doubt(brief: MissionBrief) -> None:
    """A complete tree is reviewed with it; a provider that fails at once is not."""
    asked: list[bool] = []

    def opinion() -> Authored:
        asked.append(True)
        return author_offline(brief)

    author_tree(brief, Player(ProviderError("down", "unreachable")), company=Company(opinion=opinion))
    assert asked == []
    author_tree(brief, Player(said(INIT, SEARCH), DONE), company=Company(opinion=opinion))
    assert asked == [True]
