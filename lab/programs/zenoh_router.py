"""A Zenoh router of the lab, with the settings of rmw_zenoh's router.

Each router connects to the routers of all hosts with a lower number: one link per pair. In a star,
each router connects only to the wired router. A router on a wired host connects to no other router.
"""

import json
import sys
import time
from collections.abc import Sequence
from pathlib import Path

import zenoh

#: Hosts from this number on are wired and have the only router.
WIRED = 101


def main() -> None:
    host = int(sys.argv[1])
    settings = json.loads(Path(__file__).with_name("zenoh.json").read_text())
    others: Sequence[int] = range(1, host) if host < WIRED else ()
    config = zenoh.Config()
    for key, value in (settings["all"] | settings["zenohd"]).items():
        config.insert_json5(key, json.dumps(value))
    if sys.argv[2:] == ["star"]:
        others = (WIRED,)
    links = [f"tcp/10.77.0.{other}:7447" for other in others]
    config.insert_json5("connect/endpoints", json.dumps(links))
    zenoh.init_log_from_env_or("error")
    with zenoh.open(config):
        time.sleep(1e6)  # until the namespaces end


main()
