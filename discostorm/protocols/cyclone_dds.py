"""What Cyclone DDS sends, as measured and as its source says: on Wi-Fi, and on wires."""

from discostorm.protocols.as_built import as_built

CYCLONE_DDS = as_built("Cyclone DDS")
CYCLONE_DDS_WIRED = as_built("Cyclone DDS, wired")
CYCLONE_DDS_11 = as_built("Cyclone DDS, version 11")
