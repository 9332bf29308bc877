"""
CP-SAT at work, in this process or in one of its own: the only file that loads the solver.

Run as a program it reads, from its standard input, a line of JSON with the parameters and the length of the model, then the model in
text form; it answers with a line of JSON for each answer and bound, and one at the end. A further line of input, or its end, asks it
to stop. It imports nothing of missiontree, so that it starts quickly.
"""

from __future__ import annotations

import json
import sys
import threading
from collections.abc import Callable
from typing import Any

Message = dict[str, Any]
Tell = Callable[[Message], None]


class Work:
    """
    One search.

    Parameters
    ----------
    text
        The model.
    parameters
        Of the solver, by name.
    tell
        Told each answer (``values``, ``objective``), each ``bound``, and the last word (``status``).
    """

    def __init__(self, text: str, parameters: dict[str, Any], tell: Tell) -> None:
        self._text, self._parameters, self._tell = text, parameters, tell
        self._lock, self._stopped = threading.Lock(), False
        self._solver: Any = None

    def run(self) -> None:
        """Search until the end, the time limit, or :meth:`stop`."""
        from ortools.sat.python import cp_model_helper  # noqa: PLC0415 - heavy, and only here

        tell = self._tell
        model = cp_model_helper.CpModelProto()
        if not model.parse_text_format(self._text):
            raise ValueError("the solver cannot read the model.")
        parameters = cp_model_helper.SatParameters()
        for name, value in self._parameters.items():
            setattr(parameters, name, value)

        class Listener(cp_model_helper.SolutionCallback):
            def OnSolutionCallback(self) -> None:
                found: Any = self.Response()  # type: ignore[no-untyped-call]
                tell({"values": list(found.solution), "objective": found.objective_value})

        solver = cp_model_helper.SolveWrapper()
        solver.set_parameters(parameters)
        listener = Listener()
        solver.add_solution_callback(listener)
        solver.add_best_bound_callback(lambda bound: tell({"bound": bound}))
        with self._lock:
            self._solver = solver
            stopped = self._stopped
        status, values, bound, objective = "UNKNOWN", [], None, None
        if not stopped:
            response: Any = solver.solve(model)  # type: ignore[no-untyped-call]
            status = response.status.name
            values = list(response.solution)
            bound, objective = response.best_objective_bound, response.objective_value
        solver.clear_solution_callback(listener)
        with self._lock:
            self._solver = None
        tell({"status": status, "values": values, "bound": bound, "objective": objective})

    def stop(self) -> None:
        """Ask the search to end soon."""
        with self._lock:
            self._stopped = True
            if self._solver is not None:
                self._solver.stop_search()


def main() -> None:
    """Be a process of its own."""
    header = json.loads(sys.stdin.buffer.readline())
    text = sys.stdin.buffer.read(header["length"]).decode()
    writing = threading.Lock()

    def tell(message: Message) -> None:
        with writing:
            sys.stdout.write(json.dumps(message) + "\n")
            sys.stdout.flush()

    work = Work(text, header["parameters"], tell)

    def listen() -> None:
        sys.stdin.buffer.readline()
        work.stop()

    threading.Thread(target=listen, daemon=True).start()
    work.run()


if __name__ == "__main__":
    main()
