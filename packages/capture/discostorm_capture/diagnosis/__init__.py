"""What is wrong with discovery, judged by what a capture shows of it."""

from discostorm_capture.diagnosis.finding import Finding
from discostorm_capture.diagnosis.missing import expected_hosts
from discostorm_capture.diagnosis.observations import (
    Observations,
    vantage_host,
    without_clock_steps,
)
from discostorm_capture.diagnosis.result import Diagnosis, diagnose

__all__ = [
    "Diagnosis", "Finding", "Observations", "diagnose", "expected_hosts", "vantage_host",
    "without_clock_steps",
]  # fmt: skip
