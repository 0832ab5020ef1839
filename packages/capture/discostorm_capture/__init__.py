"""Captures of real middleware: from a file of packets to messages by kind."""

from discostorm_capture.pcap import CaptureError
from discostorm_capture.read import read_capture
from discostorm_capture.result import Capture

__all__ = ["Capture", "CaptureError", "read_capture"]
