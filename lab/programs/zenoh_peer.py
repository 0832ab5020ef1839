"""One process of the lab: a Zenoh session, a peer as shipped, with the endpoints of a process.

Half are publishers and half subscribers on key expressions as rmw_zenoh writes them. With a
VARIANT other than "default" there is a liveliness token for the node and for each endpoint too,
and a subscriber to everybody's tokens, as rmw_zenoh has them; zenoh.json may hold settings for it,
"peers" has those that the package says to paste, and connects to all hosts of a lower number.
ENDPOINTS may list them instead, "w KEY TYPE,r KEY TYPE"; with the VARIANT "warm" they are declared
a third of the SECONDS after the session has been opened. The session is left without a close.
"""

import json
import os
import sys
import time
from pathlib import Path

import zenoh

TYPE = "std_msgs::msg::dds_::String_"
HASH = "RIHS01_df668c740482bbd48fb39d76a70dfd4bd59db1288021743503259e948f6b1a18"


def tell(what: str) -> None:
    print(what, f"{time.time():.6f}", flush=True)


def ignore(sample: object) -> None:
    """Take what comes; nothing is ever published."""


SNIPPETS = Path(__file__).parents[2] / "discostorm" / "data" / "vendors" / "snippets"


def configured(variant: str, host: int) -> zenoh.Config:
    """Zenoh's own settings, for a variant with a router those of rmw_zenoh, or what is pasted."""
    if variant == "peers":
        config = zenoh.Config.from_file(str(SNIPPETS / "zenoh_peers.json5"))
        own, *_ = json.loads(config.get_json("connect/endpoints"))
        links = [own, *(f"tcp/10.77.0.{other}:7447" for other in range(1, host))]
        config.insert_json5("connect/endpoints", json.dumps(links))
        return config
    settings = json.loads(Path(__file__).with_name("zenoh.json").read_text())
    config = zenoh.Config()
    if variant in settings:
        for key, value in (settings["all"] | settings[variant]).items():
            config.insert_json5(key, json.dumps(value))
    return config


def main() -> None:
    seconds = float(sys.argv[1])
    host, process = map(int, sys.argv[2:4])
    listed = [item.split() for item in sys.argv[4].split(",") if " " in item]
    endpoints = 0 if listed else int(sys.argv[4])
    matching = {"matching": endpoints // 2, "shared": 1}.get(sys.argv[5], 0)
    variant = sys.argv[6]
    tokens = variant not in ("default", "warm")
    config = configured(variant, host)
    zenoh.init_log_from_env_or("error")
    tell("ready")
    start = float(sys.stdin.readline())
    time.sleep(max(0.0, start - time.time()))
    tell("begin")
    session = zenoh.open(config)
    tell("participant")
    own, node = f"@ros2_lv/0/{session.info.zid()}", f"lab_{host:02}{process:02}"
    kept: list[object] = []
    if variant == "warm":
        time.sleep(max(0.0, start + seconds / 3 - time.time()))
    for role, key, _ in listed:
        declared = session.declare_publisher(key) if role == "w" else None
        kept.append(declared or session.declare_subscriber(key, ignore))
    if tokens:
        kept += [
            session.liveliness().declare_token(f"{own}/0/0/NN/%/%/{node}"),
            session.liveliness().declare_subscriber("@ros2_lv/0/**", ignore, history=True),
        ]
    for number in range(endpoints // 2):
        for count, role in enumerate("wr"):
            name = f"lab_{host:02}{process:02}_{role}{number:03}"
            if number < matching:
                name = f"lab_0000_t{number:03}"
            key = f"0/{name}/{TYPE}/{HASH}"
            if role == "w":
                kept.append(session.declare_publisher(key))
            else:
                kept.append(session.declare_subscriber(key, ignore))
            if tokens:
                whose = f"{own}/0/{2 * number + count + 1}/{'MS' if count else 'MP'}/%/%/{node}"
                about = f"{whose}/%{name}/{TYPE}/{HASH}/::,10:,:,:,,"
                kept.append(session.liveliness().declare_token(about))
    tell("endpoints")
    time.sleep(max(0.0, start + seconds - time.time()))
    tell("end")
    os._exit(0)  # without a word to the others, which would still be captured


main()
