"""What Fast DDS sends, as measured and as its source says."""

from discostorm.protocols.as_built import as_built

FAST_DDS = as_built("Fast DDS")
