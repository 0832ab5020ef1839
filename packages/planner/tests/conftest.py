"""What tests of the planner share: plans that simulate less."""

import pytest

from discostorm_planner import runs


@pytest.fixture
def few_runs(monkeypatch: pytest.MonkeyPatch) -> None:
    """Simulate each fleet once or twice, for tests that do not look at how often."""
    monkeypatch.setattr(runs, "RUNS", 2)
    monkeypatch.setattr(runs, "FEW_RUNS", 1)
