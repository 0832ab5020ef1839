"""A process of the failure runs: the same as watch_fast_dds.cpp, with a Zenoh session; or a router.

`w` comes from the matching listener of a publisher to one other process, `r` from the liveliness
token of that process.
"""

import json
import os
import sys
import time
from functools import partial

import zenoh

PERIOD, LATE = 0.2, 0.5  # s


def print_event(event: str, subject: object) -> None:
    os.write(1, f"{time.monotonic():.3f} {event} {subject}\n".encode())


def on_sample(sample: zenoh.Sample) -> None:
    print_event("heard", sample.payload.to_string())


def on_liveliness_token(sample: zenoh.Sample) -> None:
    came = sample.kind == zenoh.SampleKind.PUT
    print_event("matched r" if came else "unmatched r", str(sample.key_expr).rpartition("/")[2])


def on_matching_change(other: int, status: zenoh.MatchingStatus) -> None:
    print_event("matched w" if status.matching else "unmatched w", other)


def main() -> None:
    """Log the matches of process NUMBER of MOST; a router, number 0, logs nothing."""
    number, most, settings = int(sys.argv[1]), int(sys.argv[2]), json.loads(sys.argv[3])
    config = zenoh.Config()
    for name, value in settings.items():
        config.insert_json5(name, json.dumps(value))
    zenoh.init_log_from_env_or("error")
    session = None
    while session is None:
        try:
            session = zenoh.open(config)
        except zenoh.ZError as error:
            if not number:
                raise
            # Without a router, a client fails at once; try again, as a supervisor would.
            print_event("refused", str(error).split("\n")[0])
            time.sleep(1)
    print_event("me", number)
    if not number:
        while True:
            time.sleep(60)
    kept: list[object] = [
        session.declare_subscriber("lab/beat", on_sample),
        session.declare_subscriber(f"lab/to/{number}", on_sample),
        session.liveliness().declare_token(f"lab/alive/{number}"),
        session.liveliness().declare_subscriber("lab/alive/*", on_liveliness_token, history=True),
    ]
    for other in range(1, most + 1):
        publisher = session.declare_publisher(f"lab/to/{other}")
        publisher.declare_matching_listener(partial(on_matching_change, other))
        kept.append(publisher)
        if publisher.matching_status.matching:
            print_event("matched w", other)
    beat = session.declare_publisher("lab/beat")
    following = time.monotonic()
    while True:
        following += PERIOD
        time.sleep(max(0.0, following - time.monotonic()))
        if time.monotonic() > following + LATE:
            print_event("late", "a sample")
            following = time.monotonic()
        beat.put(str(number))


main()
