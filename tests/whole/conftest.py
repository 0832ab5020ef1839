"""Fixtures of the tests of all packages: plans that simulate less."""

import pytest
import simulated_once

from discostorm_planner import runs


@pytest.fixture(autouse=True)
def few_runs(monkeypatch: pytest.MonkeyPatch) -> None:
    """Simulate each fleet once or twice, as texts and tables do not depend on how often."""
    monkeypatch.setattr(runs, "_summary", simulated_once.summary)
    monkeypatch.setattr(runs, "RUNS", 2)
    monkeypatch.setattr(runs, "FEW_RUNS", 1)
