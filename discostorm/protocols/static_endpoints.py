"""What Fast DDS sends if all endpoints are known in advance, as measured and as its source says.

Static endpoint discovery (an XML file that every process has) does away with SEDP, its Heartbeats
and ACKNACKs. Participants announce themselves as ever, and each announcement lists the endpoints
that its process has: 8 unicasts a pair in 24 s stay, and grow longer with each endpoint.
Each endpoint that is made is announced to all at once, so that a start is quadratic in endpoints:
processes with many of them pay more for their lists than for SEDP. It filters nothing: names that
match nobody cost the same. Measured with up to ten endpoints a process; announcements that no
longer fit into one frame count as one.
"""

from discostorm.protocols.as_built import as_built

STATIC_ENDPOINTS = as_built("static endpoints", "mitigations")
