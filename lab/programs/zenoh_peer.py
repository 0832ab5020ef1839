"""A process of the lab: a Zenoh session, a peer as shipped, with the endpoints of a process.

Half of the endpoints are publishers and half subscribers on rmw_zenoh's key expressions. Variants
other than "default" add rmw_zenoh's liveliness tokens for the node and each endpoint, and a
subscriber to all tokens; zenoh.json may hold their settings. "peers" uses the configuration to copy
from the package, and connects to all hosts of a lower number. "warm" declares the endpoints a third
of SECONDS after the session opened. ENDPOINTS is a number or a list, "w KEY TYPE,r KEY TYPE". The
session ends without a close.
"""

import json
import os
import sys
import time
from pathlib import Path

import zenoh

TYPE = "std_msgs::msg::dds_::String_"
HASH = "RIHS01_df668c740482bbd48fb39d76a70dfd4bd59db1288021743503259e948f6b1a18"


def print_time(what: str) -> None:
    print(what, f"{time.time():.6f}", flush=True)


def ignore_sample(sample: object) -> None:
    """Ignore a sample; no process publishes any."""


SNIPPETS = Path(__file__).parents[2] / "discostorm" / "data" / "vendors" / "snippets"


def zenoh_settings(variant: str, host: int) -> zenoh.Config:
    """Return Zenoh's settings: its defaults, rmw_zenoh's, or the configuration to copy."""
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
    config = zenoh_settings(variant, host)
    zenoh.init_log_from_env_or("error")
    print_time("ready")
    start = float(sys.stdin.readline())
    time.sleep(max(0.0, start - time.time()))
    print_time("begin")
    session = zenoh.open(config)
    print_time("participant")
    domain = os.environ.get("ROS_DOMAIN_ID", "0")
    own, node = f"@ros2_lv/{domain}/{session.info.zid()}", f"lab_{host:02}{process:02}"
    kept: list[object] = []
    if variant == "warm":
        time.sleep(max(0.0, start + seconds / 3 - time.time()))
    for role, key, _ in listed:
        declared = session.declare_publisher(key) if role == "w" else None
        kept.append(declared or session.declare_subscriber(key, ignore_sample))
    if tokens:
        kept += [
            session.liveliness().declare_token(f"{own}/0/0/NN/%/%/{node}"),
            session.liveliness().declare_subscriber(
                f"@ros2_lv/{domain}/**", ignore_sample, history=True
            ),
        ]
    for number in range(endpoints // 2):
        for count, role in enumerate("wr"):
            name = f"lab_{host:02}{process:02}_{role}{number:03}"
            if number < matching:
                name = f"lab_0000_t{number:03}"
            key = f"{domain}/{name}/{TYPE}/{HASH}"
            if role == "w":
                kept.append(session.declare_publisher(key))
            else:
                kept.append(session.declare_subscriber(key, ignore_sample))
            if tokens:
                whose = f"{own}/0/{2 * number + count + 1}/{'MS' if count else 'MP'}/%/%/{node}"
                about = f"{whose}/%{name}/{TYPE}/{HASH}/::,10:,:,:,,"
                kept.append(session.liveliness().declare_token(about))
    print_time("endpoints")
    time.sleep(max(0.0, start + seconds - time.time()))
    print_time("end")
    os._exit(0)  # exit without goodbyes, which the capture would contain


main()
