"""What tests of the planner share: plans that simulate less."""

import pytest

from discostorm_planner import discovery


@pytest.fixture
def few_runs(monkeypatch: pytest.MonkeyPatch) -> None:
    """Simulate each fleet once or twice, for tests that do not look at how often."""
    monkeypatch.setattr(discovery, "RUNS", 2)
    monkeypatch.setattr(discovery, "FEW_RUNS", 1)
