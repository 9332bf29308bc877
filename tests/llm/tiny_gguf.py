"""
A language model written on the spot: a GGUF file of the llama family with weights drawn at random, a few hundred kilobytes small.

It knows no language, but the engine loads it like any other, and it answers anything with letters drawn by its weights. So whatever
comes out as a well-formed turn is the grammar's doing.
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Sequence
from pathlib import Path

import numpy as np
from gguf import GGUFWriter, TokenType

# The engine's threads wait for one another longer than so small a model takes to compute, most of all on a machine that is busy.
os.environ.setdefault("RAYON_NUM_THREADS", "1")

TURNS = (
    "{{ bos_token }}{% for message in messages %}<|{{ message['role'] }}|>{{ message['content'] }}<|end|>{% endfor %}"
    "{% if add_generation_prompt %}<|assistant|>{% endif %}"
)
"""A chat template that takes whatever roles come."""
NO_SYSTEM = "{% if messages[0]['role'] == 'system' %}{{ raise_exception('no system here') }}{% endif %}" + TURNS
"""One that knows no system, as those of the first Gemma models."""
THINKING = TURNS.replace(
    "<|assistant|>",
    "<|assistant|><think>\n{% if enable_thinking is defined and not enable_thinking %}\n</think>\n\n{% endif %}",
)
"""One that makes the model think aloud first, unless it is told not to."""
ALTERNATING = (
    "{% for message in messages %}{% if loop.index0 > 0 and (message['role'] == 'user') != (loop.index0 % 2 == 1) %}"
    "{{ raise_exception('roles must alternate') }}{% endif %}{% endfor %}" + TURNS
)
"""One that wants a system, then user and assistant by turns."""

_WORD = re.compile(r" ?[^\W\d_]+| ?[^\s\w]+")
_SPECIAL = ("<s>", "</s>", "<|system|>", "<|user|>", "<|assistant|>", "<|end|>")
_WIDTH, _HEADS, _LAYERS, _INNER = 32, 2, 1, 64
_SCALE = 0.5  # large enough for one token to be clearly the likeliest, which rounding must not decide


def write_tiny_gguf(
    path: Path,
    *,
    seed: int = 0,
    template: str | None = TURNS,
    context: int = 16_384,
    tensors_per_part: int = 0,
    base_model: str = "",
    words_of: str = "thought calls name arguments",
) -> Path:
    """
    Write the model and give its path back.

    Parameters
    ----------
    path
        Where to.
    seed
        Of the weights.
    template
        Chat template; None for a file without.
    context
        Tokens it can take in.
    tensors_per_part
        Tensors in each of several files; 0 for a single file. The parts get the endings ``-00001-of-00003.gguf`` and so on.
    base_model
        Address of the model that the file claims to be made from; empty for none.
    words_of
        A text whose words become tokens, so that it is read in fewer steps; every other byte is a token of its own.
    """
    writer = GGUFWriter(path, "llama", split_max_tensors=tensors_per_part)
    tokens, merges = _vocabulary(_WORD.findall(words_of))
    if base_model:
        writer.add_base_model_count(1)
        writer.add_base_model_repo_url(0, base_model)
    writer.add_context_length(context)
    writer.add_embedding_length(_WIDTH)
    writer.add_block_count(_LAYERS)
    writer.add_feed_forward_length(_INNER)
    writer.add_head_count(_HEADS)
    writer.add_head_count_kv(_HEADS)
    writer.add_layer_norm_rms_eps(1e-5)
    writer.add_rope_dimension_count(_WIDTH // _HEADS)
    writer.add_rope_freq_base(10_000.0)
    writer.add_vocab_size(len(tokens) + len(_SPECIAL))
    writer.add_tokenizer_model("gpt2")
    writer.add_tokenizer_pre("gpt-2")
    writer.add_token_list([*tokens, *_SPECIAL])
    writer.add_token_types([TokenType.NORMAL] * len(tokens) + [TokenType.CONTROL] * len(_SPECIAL))
    writer.add_token_merges(merges)
    writer.add_bos_token_id(len(tokens))
    writer.add_eos_token_id(len(tokens) + 1)
    if template is not None:
        writer.add_chat_template(template)
    _add_weights(writer, len(tokens) + len(_SPECIAL), np.random.default_rng(seed))
    writer.write_header_to_file()
    writer.write_kv_data_to_file()
    writer.write_tensors_to_file()
    writer.close()
    return path


def _vocabulary(words: Iterable[str]) -> tuple[list[str], list[str]]:
    """A token for each byte, and for each beginning of each word; a merge appends one byte."""
    letters = _letters()
    tokens = dict.fromkeys(letters)
    merges = []
    for word in words:
        spelt = [letters[byte] for byte in word.encode()]
        for end in range(2, len(spelt) + 1):
            if (token := "".join(spelt[:end])) not in tokens:
                tokens[token] = None
                merges.append(f"{token[:-1]} {token[-1]}")
    return list(tokens), merges


def _letters() -> Sequence[str]:
    """How tokenizers of this kind write each byte: as itself if it can be seen, else as a letter from 256 on."""
    seen = {*range(ord("!"), ord("~") + 1), *range(ord("¡"), ord("¬") + 1), *range(ord("®"), ord("ÿ") + 1)}
    unseen = iter(range(256, 512))
    return [chr(byte if byte in seen else next(unseen)) for byte in range(256)]


def _add_weights(writer: GGUFWriter, num_tokens: int, rng: np.random.Generator) -> None:
    def add(name: str, *shape: int) -> None:
        writer.add_tensor(name, (rng.standard_normal(shape) * _SCALE).astype(np.float32))

    ones = np.ones(_WIDTH, dtype=np.float32)
    add("token_embd.weight", num_tokens, _WIDTH)
    add("output.weight", num_tokens, _WIDTH)
    writer.add_tensor("output_norm.weight", ones)
    for layer in range(_LAYERS):
        for norm in ("attn_norm", "ffn_norm"):
            writer.add_tensor(f"blk.{layer}.{norm}.weight", ones)
        for name in ("attn_q", "attn_k", "attn_v", "attn_output"):
            add(f"blk.{layer}.{name}.weight", _WIDTH, _WIDTH)
        add(f"blk.{layer}.ffn_gate.weight", _INNER, _WIDTH)
        add(f"blk.{layer}.ffn_up.weight", _INNER, _WIDTH)
        add(f"blk.{layer}.ffn_down.weight", _WIDTH, _INNER)
