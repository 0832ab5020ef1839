"""The protocols: tables of messages, one file a family."""

from discostorm.protocols.paper import DDS, ZENOH

__all__ = ["DDS", "ZENOH"]
