"""Captures of real middleware: from a file of packets to messages by kind."""

from discostorm.capture.pcap import CaptureError
from discostorm.capture.read import read_capture
from discostorm.capture.result import Capture

__all__ = ["Capture", "CaptureError", "read_capture"]
