"""A Zenoh router of the lab, with the settings that rmw_zenoh gives its own.

On the host of the lowest number it is alone at first; each other one connects to those of all
hosts of a lower number: one link for each two routers. In a star each connects to the wired one
alone. On a host behind the others, wired, a router connects to no other one.
"""

import json
import sys
import time
from collections.abc import Sequence
from pathlib import Path

import zenoh

#: Hosts from this number on are wired, and have the only router.
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
        time.sleep(1e6)  # until the stage is taken away


main()
