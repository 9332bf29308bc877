"""Are the inputs in the plan those that it was made from?"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from missiontree.checking.case import Case
from missiontree.checking.fault import Fault
from missiontree.formats.digest import digest
from missiontree.formats.inputs import inputs_of


def digest_mismatch(case: Case) -> Iterator[Fault]:
    """The digest of an input is missing, or is not that of the input in the plan."""
    for name, value in _inputs(case).items():
        found, needed = case.plan.digests.get(name), digest(value)
        if found != needed:
            yield Fault(
                f"the {name} in the plan is not the one that it was made from: its digest is "
                f"{'not given' if found is None else 'another'}.",
                found=found or "none",
                needed=needed,
            )


def digest_unknown(case: Case) -> Iterator[Fault]:
    """A digest is given for an input that the plan does not have."""
    for name in sorted(case.plan.digests.keys() - _inputs(case).keys()):
        yield Fault(f"a digest is given for {name!r}, and the plan has no such input.", found=name)


def _inputs(case: Case) -> dict[str, Any]:
    return inputs_of(case.plan.brief, case.plan.tree)
