"""What Zenoh peers send, as measured and as their source says; also as rmw_zenoh has them."""

from discostorm.protocols.as_built import as_built

ZENOH_PEER = as_built("Zenoh peer")
ZENOH_PEER_TOKENS = as_built("Zenoh peer, tokens")
