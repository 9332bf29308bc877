"""A file of Python that the user names: it is run, and what goes wrong in it is told with its line."""

from __future__ import annotations

import importlib.util
import sys
import traceback
from pathlib import Path
from types import ModuleType

from missiontree.errors import InputError


def run_file(path: Path, what: str) -> ModuleType:
    """
    Run a Python file, with all rights of whoever runs this program.

    Parameters
    ----------
    path
        The file.
    what
        What it defines, one word.

    Raises
    ------
    InputError
        If there is no such file, or running it fails or ends the program; with the line.
    """
    if not path.is_file():
        raise InputError("there is no such file.", file=str(path), accepted=f"a Python file that defines {what}")
    name = f"missiontree_{what}_{path.stem}"
    spec = importlib.util.spec_from_file_location(name, path)
    if spec is None or spec.loader is None:
        raise InputError("this is no Python file", file=str(path), accepted="a file whose name ends in .py")
    module = importlib.util.module_from_spec(spec)
    sys.modules[name] = module  # annotations are resolved by way of the module's name
    try:
        spec.loader.exec_module(module)
    except InputError as error:
        error.file = error.file or str(path)
        raise
    except (Exception, SystemExit) as error:  # the user's own code may fail, or end the program, in any way
        raise cannot_run(error, path) from error
    return module


def cannot_run(error: BaseException, path: Path) -> InputError:
    """The refusal of a file that failed when it was run."""
    return InputError(
        f"the module cannot be run: {type(error).__name__}: {error}", file=str(path), line=_line(error, path)
    )


def _line(error: BaseException, path: Path) -> int:
    """Line of a file that an error came by last; 0 if it did not come by."""
    if isinstance(error, SyntaxError):
        return error.lineno or 0
    frames = traceback.extract_tb(error.__traceback__)
    lines = [frame.lineno or 0 for frame in frames if Path(frame.filename) == path.absolute()]
    return lines[-1] if lines else 0
