"""Captures of real middleware: from a file of packets to messages by kind."""

from discostorm.capture.pcap import CaptureError
from discostorm.capture.result import Capture, read_capture

__all__ = ["Capture", "CaptureError", "read_capture"]
