"""Which hosts are expected, and missing in a capture."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from ipaddress import ip_address

from discostorm import _checks, wording
from discostorm_capture.diagnosis.evidence import Evidence
from discostorm_capture.diagnosis.finding import Finding, listed
from discostorm_capture.diagnosis.observations import Expected


def expected_hosts(expected: int | Sequence[str] | None) -> Expected:
    """Return how many hosts are expected, or their addresses, each once and as captures name them.

    An address that cannot be read or is there twice raises a ValueError, one text a TypeError.
    """
    if expected is None:
        return None
    if isinstance(expected, int):
        _checks.integer("expected", expected, 1, _checks.MAX_COUNT)
        return expected
    addresses = []
    for text in _checks.tuple_of("expected", expected, str):
        try:
            addresses.append(str(ip_address(text.strip())))
        except ValueError:
            raise ValueError(
                "expected must be a number of hosts or IP addresses such as 10.0.0.5; got "
                f"{_checks.shorten_name(text)!r}"
            ) from None
    _checks.distinct("expected", addresses, "addresses")
    return tuple(addresses)


def missing(evidence: Evidence) -> Iterator[Finding]:
    """Yield the expected hosts that announced nothing."""
    obs, expected = evidence.obs, evidence.obs.expected
    present = {str(host) for scope in evidence.scopes for host in scope.hosts}
    if isinstance(expected, int):
        robots = sorted(present - obs.server_hosts)
        if len(robots) < expected:
            said = f"{wording.count_noun(expected, 'host')} expected, {len(robots)} in the capture"
            yield Finding("too few hosts", (), f"{said}{': ' + listed(robots) if robots else ''}")
    elif absent := tuple(host for host in expected or () if host not in present):
        others = {*obs.network_events["sender"].astype(str)}
        silent = [host for host in absent if host in others]
        said = f"{listed(absent)} announced nothing; {len(expected or ())} hosts are expected"
        if silent:
            said += f"; {listed(silent)} sent other packets, so the host itself is on the network"
        yield Finding("missing", absent, said)
