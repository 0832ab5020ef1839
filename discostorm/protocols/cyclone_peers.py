"""What Cyclone DDS sends with other settings, as measured and as its source says.

With a list of peers and no multicast, each process announces itself to each peer on as many ports
as `MaxAutoParticipantIndex` says, 9 by default, as it cannot know which of them are in use; and
hosts answer what comes to one that is not. With multicast for SEDP, Cyclone's choice on wires,
endpoints and what repeats are told once to all, over Wi-Fi at the rate of multicast.
"""

from discostorm.protocols.as_built import as_built

CYCLONE_DDS_PEERS = as_built("Cyclone DDS peers", "mitigations")
CYCLONE_DDS_MULTICAST = as_built("Cyclone DDS multicast SEDP", "mitigations")
