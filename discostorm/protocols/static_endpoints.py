"""What Fast DDS sends if all endpoints are known in advance, as measured and as its source says.

Static endpoint discovery (an XML file that every process has) does away with SEDP, its Heartbeats
and ACKNACKs. Participants announce themselves as ever, and each announcement lists the endpoints
that its process has: 8 unicasts a pair in 24 s stay, and grow longer with each endpoint.
Each endpoint that is made is announced to all at once, so that a start is quadratic in endpoints:
processes with many of them pay more for their lists than for SEDP. It filters nothing: names that
match nobody cost the same.

Measured with 2 to 84 endpoints a process. Two things are less sure than the rest: how many of the
announcements of new endpoints go to each other process as well, none to all of them within the runs
of one point, as that is whether it was known before; and an announcement that no longer fits into
one frame, from some 17 endpoints on, counts as one, so that the airtime of the others' headers is
left out. Fast DDS 2.9.1 has to hold a lock that it does not, or it crashes (`lab/fast_dds.cpp`).
"""

from discostorm.protocols.as_built import as_built

STATIC_ENDPOINTS = as_built("static endpoints", "mitigations")
