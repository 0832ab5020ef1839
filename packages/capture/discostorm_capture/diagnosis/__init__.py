"""What is wrong with discovery, by what a capture shows of it."""

from discostorm_capture.diagnosis.finding import Finding
from discostorm_capture.diagnosis.observations import Seen, view_of, without_jumps
from discostorm_capture.diagnosis.result import Diagnosis, diagnose

__all__ = ["Diagnosis", "Finding", "Seen", "diagnose", "view_of", "without_jumps"]
