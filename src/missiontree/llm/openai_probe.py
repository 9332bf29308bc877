"""A few tiny questions that show what a model at an endpoint can do."""

from __future__ import annotations

from dataclasses import dataclass

from missiontree.llm.chat import Message, ProviderError, Tool, Usage
from missiontree.llm.features import Features
from missiontree.llm.openai import OpenAIModel

_SYSTEM = Message("system", "You test whether functions can be called. Do exactly what you are asked.")
_WORD = {
    "type": "object",
    "properties": {"word": {"type": "string"}},
    "required": ["word"],
    "additionalProperties": False,
}
_PING = Tool("ping", "Sends a word to the first place.", _WORD)
_PONG = Tool("pong", "Sends a word to the second place.", _WORD)


@dataclass(frozen=True, slots=True, kw_only=True)
class Probed:
    """
    What a model was found to do.

    Parameters
    ----------
    endpoint, model
        Who was asked; the address holds nothing secret.
    features
        What is made use of from now on.
    calls
        Whether it calls a function when asked to in words; without that it is of no use here.
    calls_together
        Whether it makes two calls in one answer; without that a dialogue takes more turns.
    usage
        Tokens that the questions took; None if the endpoint does not count.
    fault
        Why it could not be asked, or not to the end; None if it could.
    """

    endpoint: str
    model: str
    features: Features
    calls: bool = False
    calls_together: bool = False
    usage: Usage | None = None
    fault: ProviderError | None = None


def probe(model: OpenAIModel) -> Probed:
    """
    Ask a model three tiny questions: for a call by name, for a call of any function, and for two calls in words alone.

    What was known of it is forgotten first and what is found out is remembered, so an endpoint that has learnt something new is used to
    the full again. If it cannot be asked to the end, what was known stays.

    Parameters
    ----------
    model
        The model. Its patience is the probe's.
    """
    before = model.features
    model.memory.learn(model.endpoint, model.model, Features())
    answers: list[Message] = []
    fault = None
    try:
        demand = Message("user", 'Call ping with the word "one".', must_call=True)
        answers.append(model([_SYSTEM, demand], [_PING]))
        answers.append(model([_SYSTEM, demand], [_PING, _PONG]))
        both = Message("user", 'Call ping with the word "one" and pong with the word "two", both in one answer.')
        answers.append(model([_SYSTEM, both], [_PING, _PONG]))
    except ProviderError as error:
        fault = error
        model.memory.learn(model.endpoint, model.model, before)
    unasked = answers[2].calls if len(answers) == 3 else ()
    return Probed(
        endpoint=model.endpoint,
        model=model.model,
        features=model.features,
        calls=bool(unasked),
        calls_together={"ping", "pong"} <= {call.name for call in unasked},
        usage=_together(answers),
        fault=fault,
    )


def _together(answers: list[Message]) -> Usage | None:
    counted = [answer.usage for answer in answers if answer.usage is not None]
    if not counted or len(counted) < len(answers):
        return None
    costs = [usage.cost_usd for usage in counted if usage.cost_usd is not None]
    return Usage(
        sum(usage.input_tokens for usage in counted),
        sum(usage.output_tokens for usage in counted),
        sum(costs) if len(costs) == len(counted) else None,
    )
