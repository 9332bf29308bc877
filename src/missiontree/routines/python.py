'''
Routines written as Python functions. They give the same values as YAML files do.

The parameters of the function are the arguments of the routine, their ``Literal`` annotations the entity kinds accepted, the
first paragraph of its docstring the purpose. It is called once, with each parameter bound to its own name, and returns the
branches (or the parts it is composed of)::

    @routine(verbs=("inspect", "check"))
    def Inspect(thing: Literal["object", "place"]) -> Branch:
        """Inspect {thing} and report."""
        look = ActionStep(name="look", text="Look at {thing}", duration_s=30, at=thing)
        return Branch(name="inspect", roles=(RoleSpec(name="inspector", rating="inspect", actions=(look,)),))
'''

from __future__ import annotations

import importlib
import inspect
from collections.abc import Callable, Iterable
from pathlib import Path
from types import ModuleType
from typing import Any, Literal, get_args, get_origin, get_type_hints, overload

from missiontree.errors import InputError
from missiontree.formats.python_file import cannot_run, run_file
from missiontree.mission.routine import Argument, Branch, Part, Routine
from missiontree.mission.scene import BASE_KINDS

Body = Callable[..., Branch | Part | Iterable[Branch] | Iterable[Part]]


@overload
def routine(function: Body, /) -> Routine: ...


@overload
def routine(*, verbs: Iterable[str] = (), same_robot: Iterable[int] = ()) -> Callable[[Body], Routine]: ...


def routine(
    function: Body | None = None, /, *, verbs: Iterable[str] = (), same_robot: Iterable[int] = ()
) -> Routine | Callable[[Body], Routine]:
    """
    Make a routine of a function; a decorator, with or without arguments.

    Parameters
    ----------
    function
        Its name becomes the routine's id. A parameter without annotation accepts every kind.
    verbs
        English verbs whose objects are the arguments in order, for authors that read plain language.
    same_robot
        Indices of the parts that one robot does; for functions that return parts.

    Raises
    ------
    InputError
        If the function does not make a routine.
    """
    if function is None:
        return lambda body: _made(body, tuple(verbs), tuple(same_robot))
    return _made(function, tuple(verbs), tuple(same_robot))


def collect(source: Routine | ModuleType | Path | str | Iterable[Routine]) -> tuple[Routine, ...]:
    """
    The routines that something defines, in the order in which it defines them.

    Parameters
    ----------
    source
        A routine, several of them, a module, the path of a Python file or the dotted name of a module. The last two are run.

    Raises
    ------
    InputError
        If there is no such module, running it fails, or it defines no routine.
    """
    if isinstance(source, Routine):
        return (source,)
    if isinstance(source, str | Path):
        source = _module(source)
    if not isinstance(source, ModuleType):
        return tuple(source)
    found = [value for value in vars(source).values() if isinstance(value, Routine)]
    if not found:
        file = str(source.__file__) if getattr(source, "__file__", None) else ""
        raise InputError(
            f"module {source.__name__!r} defines no routine.", file=file, hint="Decorate a function with @routine."
        )
    return tuple({value.id: value for value in found}.values())


def _made(function: Body, verbs: tuple[str, ...], same_robot: tuple[int, ...]) -> Routine:
    name = getattr(function, "__name__", "")
    try:
        parameters = list(inspect.signature(function).parameters)
        hints = get_type_hints(function)
        body = function(**{parameter: parameter for parameter in parameters})
        items: tuple[Branch | Part, ...] = (body,) if isinstance(body, Branch | Part) else tuple(body)
        return Routine(
            id=name,
            purpose=" ".join((inspect.getdoc(function) or name).split("\n\n")[0].split()),
            arguments=tuple(Argument(name=each, kinds=_kinds(name, each, hints)) for each in parameters),
            verbs=verbs,
            branches=tuple(item for item in items if isinstance(item, Branch)),
            parts=tuple(item for item in items if isinstance(item, Part)),
            same_robot=same_robot,
        )
    except (ValueError, TypeError, NameError) as error:
        raise InputError(f"the function does not make a routine: {error}", where=name) from error


def _kinds(name: str, parameter: str, hints: dict[str, Any]) -> tuple[str, ...]:
    hint = hints.get(parameter)
    if hint is None:
        return BASE_KINDS
    if get_origin(hint) is not Literal:
        raise InputError(
            f"the annotation of {parameter!r} does not name entity kinds.",
            where=name,
            accepted='Literal["person", "place"] and the like',
        )
    return get_args(hint)


def _module(source: Path | str) -> ModuleType:
    path = Path(source)
    if path.suffix == ".py":
        return run_file(path, "routines")
    try:
        return importlib.import_module(str(source))
    except InputError as error:
        error.file = error.file or str(path)
        raise
    except (Exception, SystemExit) as error:  # the user's own code may fail, or end the program, in any way
        raise cannot_run(error, path) from error
