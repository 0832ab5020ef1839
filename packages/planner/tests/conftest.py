"""What tests of the planner share: plans that simulate less."""

import pytest
import simulated_once

from discostorm_planner import simulation_jobs


@pytest.fixture(autouse=True)
def _equal_runs_once(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(simulation_jobs, "_run_summary", simulated_once.summary)


@pytest.fixture
def few_runs(monkeypatch: pytest.MonkeyPatch) -> None:
    """Simulate each fleet once or twice, for tests that do not look at how often."""
    monkeypatch.setattr(simulation_jobs, "RUNS", 2)
    monkeypatch.setattr(simulation_jobs, "RUNS_IF_LONG", 1)
