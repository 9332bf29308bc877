"""Templates filled in. Whatever is put into one stands there as words: never as markup, never as hidden direction."""

from __future__ import annotations

from functools import lru_cache
from importlib.resources import files
from typing import Any

from jinja2 import Environment, FunctionLoader, StrictUndefined, Undefined
from markupsafe import Markup

from missiontree.reporting.escape import terminal_safe


def resource(name: str) -> str:
    """Text of a file that stands beside this one."""
    return files(__package__).joinpath(name).read_text(encoding="utf-8")


def filled(template: str, **values: Any) -> str:
    """
    Fill in a template.

    Parameters
    ----------
    template
        Name of a file in ``templates``.
    values
        What it speaks of.

    Raises
    ------
    UndefinedError
        If the template speaks of something that is not given.
    TypeError
        If it shows something that is neither text nor a number.
    """
    return _environment().get_template(template).render(values)


@lru_cache(maxsize=1)
def _environment() -> Environment:
    return Environment(
        loader=FunctionLoader(lambda name: resource(f"templates/{name}")),
        autoescape=True,
        undefined=StrictUndefined,
        finalize=_shown,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=False,
        auto_reload=False,
    )


def _shown(value: object) -> object:
    """What stands for a value; text of users loses control and format characters, and is escaped after this."""
    if isinstance(value, Markup) or (isinstance(value, int) and not isinstance(value, bool)):
        return value
    if isinstance(value, str):
        return terminal_safe(value)
    if isinstance(value, Undefined):
        return str(value)  # which raises, and says what is not given
    raise TypeError(f"a template shows {value!r}; give it text")
