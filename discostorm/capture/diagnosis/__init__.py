"""What is wrong with discovery, by what a capture shows of it."""

from discostorm.capture.diagnosis.finding import Finding
from discostorm.capture.diagnosis.result import Diagnosis, diagnose
from discostorm.capture.diagnosis.seen import Seen, view_of, without_jumps

__all__ = ["Diagnosis", "Finding", "Seen", "diagnose", "view_of", "without_jumps"]
