"""Fixtures of the tests of all packages: plans that simulate less."""

import pytest
import simulated_once

from discostorm_planner import simulation_jobs


@pytest.fixture(autouse=True)
def few_runs(monkeypatch: pytest.MonkeyPatch) -> None:
    """Simulate each fleet once or twice, as texts and tables do not depend on how often."""
    monkeypatch.setattr(simulation_jobs, "_run_summary", simulated_once.summary)
    monkeypatch.setattr(simulation_jobs, "RUNS", 2)
    monkeypatch.setattr(simulation_jobs, "RUNS_IF_LONG", 1)
