"""Rules for the whole suite: no wall-clock deadlines in property tests, no model from the environment, no silent skips in CI."""

from __future__ import annotations

import os

import pytest
from hypothesis import HealthCheck, settings

from tests.browser.chromium import chromium

NAMING = {"MISSIONTREE_MODEL", "MISSIONTREE_BASE_URL", "OPENAI_BASE_URL", "ANTHROPIC_BASE_URL"}

settings.register_profile(
    "missiontree",
    deadline=None,
    derandomize=True,
    database=None,
    suppress_health_check=[HealthCheck.too_slow, HealthCheck.data_too_large],
)
settings.load_profile("missiontree")

# Where there is no Chromium the tests of the page are left out, and the first lines say so. In CI there is one, or they fail.
_without_page = chromium() is None and not os.environ.get("CI")
collect_ignore = ["browser"] if _without_page else []


def pytest_report_header() -> str:
    """Say whether the page is tested."""
    return (
        "page: not tested, for there is no Chromium on the path" if _without_page else f"page: tested in {chromium()}"
    )


@pytest.fixture(autouse=True)
def _no_model_from_the_environment(monkeypatch: pytest.MonkeyPatch) -> None:
    """No test can reach a provider by accident."""
    for name in [name for name in os.environ if name in NAMING or name.endswith("_API_KEY")]:
        monkeypatch.delenv(name)
    monkeypatch.setenv("XDG_CACHE_HOME", os.path.join(os.path.abspath(os.devnull), "none"))  # nothing is remembered


def pytest_sessionfinish(session: pytest.Session) -> None:
    """In CI everything is installed, so a skipped test is a failure."""
    if _skipped_in_ci(session.config):
        session.exitstatus = pytest.ExitCode.TESTS_FAILED


def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter, config: pytest.Config) -> None:
    """Say why a run without a failed test fails."""
    if _skipped_in_ci(config):
        terminalreporter.write_line(
            "FAILED: a test was skipped, and in CI (the variable CI is set) none may be", red=True
        )


def _skipped_in_ci(config: pytest.Config) -> bool:
    reporter = config.pluginmanager.get_plugin("terminalreporter")
    return bool(os.environ.get("CI") and reporter is not None and reporter.stats.get("skipped"))
