"""Captures of real middleware: from a file of packets to messages by kind."""

from discostorm_capture.capture import Capture
from discostorm_capture.pcap import CaptureError
from discostorm_capture.read import read_capture

__all__ = ["Capture", "CaptureError", "read_capture"]
