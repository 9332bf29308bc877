"""The Gemini API on loopback: plays scripted answers in its wire form, and rejects what the API rejects."""

from __future__ import annotations

import base64
import json
import re
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from typing import Any

from jsonschema import Draft202012Validator

from missiontree.llm.gemini import GeminiModel
from tests.llm.loopback import Loopback, Reply, Request, serving

KEY = "AIza-loopback-0123456789"
ANY_SIGNATURE = b"skip_thought_signature_validator"
Part = dict[str, Any]

_PATH = re.compile(r"/v1(beta)?/models/gemini-loopback:(generateContent|streamGenerateContent\?alt=sse)")
_FUNCTION = re.compile(r"[A-Za-z_][A-Za-z0-9_.:-]{0,127}")
_REQUEST = {"contents", "systemInstruction", "tools", "toolConfig", "generationConfig"}
_DATA = ("text", "functionCall", "functionResponse")
_MODES = {"AUTO", "ANY", "NONE", "VALIDATED"}


def text(words: str, signature: bytes = b"", thought: bool = False) -> Part:
    return _signed({"text": words} | ({"thought": True} if thought else {}), signature)


def call(name: str, arguments: Mapping[str, Any], signature: bytes = b"", call_id: str = "") -> Part:
    made = {"name": name, "args": dict(arguments)}
    return _signed({"functionCall": made | ({"id": call_id} if call_id else {})}, signature)


def _signed(part: Part, signature: bytes) -> Part:
    return part | ({"thoughtSignature": base64.b64encode(signature).decode()} if signature else {})


def signature_of(part: Part) -> bytes:
    """The signature, in either alphabet of base64, as protobuf reads it."""
    return base64.b64decode(part.get("thoughtSignature", "").replace("-", "+").replace("_", "/"))


@dataclass(frozen=True)
class Said:
    """One answer of the model."""

    parts: Sequence[Part]
    reason: str | None = "STOP"
    usage: Mapping[str, int] | None = field(
        default_factory=lambda: {"promptTokenCount": 10, "candidatesTokenCount": 5, "totalTokenCount": 15}
    )


@dataclass
class GeminiEndpoint:
    """
    The API.

    Parameters
    ----------
    script
        Answers, in order; a ``Reply`` is sent as it is, a ``Said`` in the form that was asked for.
    strict
        Whether calls must bear the signatures that they came with, as newer models want it.
    """

    script: list[Said | Reply]
    strict: bool = False
    issued: list[Part] = field(default_factory=list)
    refusals: list[str] = field(default_factory=list)

    def __call__(self, request: Request) -> Reply:
        try:
            self._check(request)
        except ValueError as error:
            self.refusals.append(str(error))
            return failure(400, "INVALID_ARGUMENT", str(error))
        said = self.script.pop(0)
        if isinstance(said, Reply):
            return said
        self.issued += said.parts
        if "streamGenerateContent" in request.path:
            return Reply.of_events(chunks_of(said))
        return Reply.of_json(response_of(said.parts, said.reason, said.usage))

    def _check(self, request: Request) -> None:
        _demand(bool(_PATH.fullmatch(request.path)), f"models/... is not found for API version: {request.path}")
        _demand(request.headers.get("x-goog-api-key") == KEY, "API key not valid. Please pass a valid API key.")
        body = request.body
        _only(body, _REQUEST, "request")
        if "systemInstruction" in body:
            _demand(bool(body["systemInstruction"]["parts"][0]["text"].strip()), "systemInstruction: must not be empty")
        _only(body.get("generationConfig", {}), {"maxOutputTokens"}, "generation_config")
        _check_tools(body)
        self._check_contents(body["contents"])

    def _check_contents(self, contents: list[Part]) -> None:
        _demand(bool(contents) and contents[0]["role"] == "user", "contents: must begin with the user")
        _demand(contents[-1]["role"] == "user", "contents: must end with the user")
        asked: list[Part] = []
        role = ""
        for number, content in enumerate(contents):
            where = f"contents[{number}]"
            _only(content, {"role", "parts"}, where)
            _demand(content["role"] in {"user", "model"} and content["role"] != role, f"{where}: roles must alternate")
            role = content["role"]
            _demand(bool(content["parts"]), f"{where}.parts must not be empty.")
            for part in content["parts"]:
                _check_part(part, role, where)
            _check_answers([part["functionResponse"] for part in content["parts"] if "functionResponse" in part], asked)
            asked = [part["functionCall"] for part in content["parts"] if "functionCall" in part]
            if self.strict and role == "model":
                self._check_signatures(content["parts"], where)

    def _check_signatures(self, parts: Sequence[Part], where: str) -> None:
        calls = [part for part in parts if "functionCall" in part]
        _demand(
            not calls or bool(signature_of(calls[0])),
            f"Function call is missing a thought_signature in functionCall parts. {where}",
        )
        known = {signature_of(part) for part in self.issued} | {ANY_SIGNATURE, b""}
        for part in parts:
            _demand(signature_of(part) in known, f"{where}: Thought signature is not valid.")


def _check_part(part: Part, role: str, where: str) -> None:
    _only(part, {*_DATA, "thought", "thoughtSignature"}, f"{where}.parts")
    data = [name for name in _DATA if name in part]
    _demand(len(data) == 1, f"{where}.parts.data: required oneof field 'data' must have one initialized field")
    _demand("text" not in part or bool(part["text"] or signature_of(part)), f"{where}: empty text parameter")
    if made := part.get("functionCall"):
        _demand(role == "model", f"{where}: a function call is the model's")
        _only(made, {"name", "args", "id"}, f"{where}.functionCall")
        _demand(bool(_FUNCTION.fullmatch(made["name"])), f"{where}: invalid function name")
        _demand(isinstance(made.get("args", {}), dict), f"{where}: args must be a Struct")
    if answered := part.get("functionResponse"):
        _demand(role == "user", f"{where}: a function response is the user's")
        _only(answered, {"name", "response", "id"}, f"{where}.functionResponse")
        _demand(isinstance(answered["response"], dict), f"{where}: response must be a Struct")


def _check_answers(answers: Sequence[Part], asked: Sequence[Part]) -> None:
    _demand(
        len(answers) == len(asked),
        "Please ensure that the number of function response parts is equal to the number of function call parts of the function call turn.",
    )
    for answer, made in zip(answers, asked, strict=True):
        same = (answer["name"], answer.get("id")) == (made["name"], made.get("id"))
        _demand(same, "Please ensure that function response names and ids match those of the function calls.")


def _check_tools(body: Part) -> None:
    tools = body.get("tools", [])
    declared = [function for tool in tools for function in tool["functionDeclarations"]]
    names = [function["name"] for function in declared]
    _demand(len(set(names)) == len(names), "Duplicate function declaration found")
    for function in map(_spelt, declared):
        _only(function, {"name", "description", "parametersJsonSchema"}, "tools")
        _demand(bool(_FUNCTION.fullmatch(function["name"])), "Invalid function name.")
        if "parametersJsonSchema" in function:
            schema = function["parametersJsonSchema"]
            Draft202012Validator.check_schema(schema)
            _demand(schema["type"] == "object" and bool(schema["properties"]), "properties: should be non-empty")
    if "toolConfig" in body:
        _demand(bool(declared), "Function calling config is set without function_declarations.")
        _demand(body["toolConfig"]["functionCallingConfig"]["mode"] in _MODES, "Invalid mode")


def _spelt(plain: Part) -> Part:
    """The fields as the API names them: it also takes them with underscores, and the SDK writes some so."""
    return {re.sub(r"_([a-z])", lambda letter: letter[1].upper(), name): value for name, value in plain.items()}


def _only(plain: Part, allowed: set[str], where: str) -> None:
    extra = ", ".join(sorted(set(plain) - allowed))
    _demand(not extra, f"Invalid JSON payload received. Unknown name \"{extra}\" at '{where}': Cannot find field.")


def _demand(held: bool, words: str) -> None:
    if not held:
        raise ValueError(words)


def failure(code: int, status: str, words: str, *details: Part, **headers: str) -> Reply:
    """An error in the API's form."""
    told: Part = {"code": code, "message": words, "status": status}
    return Reply.of_json({"error": told | ({"details": list(details)} if details else {})}, code, **headers)


def response_of(parts: Sequence[Part], reason: str | None, usage: Mapping[str, int] | None) -> Part:
    candidate: Part = {"content": {"role": "model", "parts": list(parts)}, "index": 0}
    response: Part = {"candidates": [candidate | ({"finishReason": reason} if reason else {})]}
    return response | ({"usageMetadata": dict(usage)} if usage else {}) | {"modelVersion": "gemini-loopback"}


def chunks_of(said: Said) -> list[bytes]:
    """The answer as the chunks that the API streams: texts in two each, and the end with the last."""
    parts = [piece for part in said.parts for piece in _pieces(part)]
    responses = [response_of([part], None, None) for part in parts[:-1]]
    responses.append(response_of(parts[-1:], said.reason, said.usage))
    return [chunk(response) for response in responses]


def chunk(response: Any) -> bytes:
    return f"data: {json.dumps(response)}\r\n\r\n".encode()


def _pieces(part: Part) -> list[Part]:
    """A text in two, the signature with the second; a call is never parted."""
    words = part.get("text", "")
    if len(words) < 2:
        return [part]
    middle = len(words) // 2
    head = {"text": words[:middle]} | ({"thought": True} if part.get("thought") else {})
    return [head, {**part, "text": words[middle:]}]


@dataclass
class Answered:
    """A model, and the endpoint that it asks."""

    model: GeminiModel
    endpoint: GeminiEndpoint
    server: Loopback

    @property
    def bodies(self) -> list[Part]:
        return [request.body for request in self.server.requests]


@contextmanager
def answering(*script: Said | Reply, strict: bool = False, **settings: Any) -> Iterator[Answered]:
    """A model of Gemini's whose API answers from the script."""
    endpoint = GeminiEndpoint(list(script), strict)
    with serving(endpoint) as server:
        model = GeminiModel(**{"model": "gemini-loopback", "api_key": KEY, "base_url": server.url, **settings})
        yield Answered(model, endpoint, server)
