"""A node of ROS 2 with Zenoh: `node_zenoh.py NAME ENDPOINTS CONFIG [SETTINGS]`.

ENDPOINTS lists "w TOPIC TYPE HZ BYTES", "r TOPIC TYPE", "s SERVICE TYPE" (a server) and "c SERVICE
TYPE" (a client that calls once a second), with commas between them, in the names of ROS 2. Keys,
tokens and attachments are those of rmw_zenoh. CONFIG is JSON of Zenoh. SETTINGS is JSON: `block`
(congestion control of reliable writers), `ahead` (clock of the samples' timestamps [s]), `leaves`
(closes the session after this time [s]). The node prints how many samples and replies came.
"""

import datetime
import json
import struct
import sys
import time
from typing import Any

import zenoh

NAME, ENDPOINTS, CONFIG = sys.argv[1:4]
SETTINGS = json.loads(sys.argv[4]) if len(sys.argv) > 4 else {}
HASH = "RIHS01_df668c740482bbd48fb39d76a70dfd4bd59db1288021743503259e948f6b1a18"
#: The header of CDR, which begins each sample.
HEADER = b"\0\1\0\0"
KINDS = {"w": "MP", "r": "MS", "s": "SS", "c": "SC"}
came: dict[str, int] = {}


def reply(query: zenoh.Query) -> None:
    query.reply(query.key_expr, HEADER + b"\1")


def count(name: str) -> object:
    came[name] = 0

    def more(_: object) -> None:
        came[name] += 1

    return more


def main() -> None:
    config = zenoh.Config()
    for name, value in json.loads(CONFIG).items():
        config.insert_json5(name, json.dumps(value))
    zenoh.init_log_from_env_or("error")
    session = None
    while session is None:
        try:
            session = zenoh.open(config)
        except zenoh.ZError as error:
            print(f"{time.monotonic():.3f} refused", str(error).split("\n")[0], flush=True)
            time.sleep(1)
    zid = session.info.zid()
    own = f"@ros2_lv/0/{zid}/0"
    kept: list[object] = [
        session.liveliness().declare_token(f"{own}/0/NN/%/%/{NAME}"),
        session.liveliness().declare_subscriber("@ros2_lv/0/**", lambda _: None, history=True),
    ]
    writers: list[list[Any]] = []
    clients: list[list[Any]] = []
    for number, item in enumerate(ENDPOINTS.split(","), 1):
        role, topic, kind, *told = item.split()
        key = f"0/{topic.strip('/')}/{kind}/{HASH}"
        if role == "w":
            how = zenoh.CongestionControl
            control = how.BLOCK if SETTINGS.get("block") else how.DROP
            writer = session.declare_publisher(key, congestion_control=control)
            sample = HEADER + bytes(int(told[1]))
            writers.append([writer, 1 / float(told[0]), sample, time.monotonic() + 2, 0])
        elif role == "r":
            kept.append(session.declare_subscriber(key, count(topic)))
        elif role == "s":
            kept.append(session.declare_queryable(key, reply, complete=True))
        else:
            clients.append([key, count(topic), time.monotonic() + 2])
        named = f"{NAME}/{topic.replace('/', '%')}/{kind}/{HASH}"
        about = f"{own}/{number}/{KINDS[role]}/%/%/{named}/::,10:,:,:,,"
        kept.append(session.liveliness().declare_token(about))
    begin = time.monotonic()
    told_at = begin + 5
    while True:
        now = time.monotonic()
        for one in writers:
            if one[3] <= now:
                one[4] += 1
                attachment = struct.pack("<qq", one[4], time.time_ns()) + b"\x10" + bytes(16)
                more = {}
                if "ahead" in SETTINGS:
                    at = datetime.datetime.now(datetime.UTC)
                    more["timestamp"] = zenoh.Timestamp(
                        at + datetime.timedelta(seconds=SETTINGS["ahead"]),
                        session.new_timestamp().get_id(),
                    )
                one[0].put(one[2], attachment=attachment, **more)
                one[3] += one[1]
        for one in clients:
            if one[2] <= now:
                every = zenoh.QueryTarget.ALL_COMPLETE
                session.get(one[0], one[1], target=every, payload=HEADER + b"\1", timeout=5.0)
                one[2] += 1
        if now > told_at:
            sent = [one[4] for one in writers]
            print(f"{now:.3f} came", json.dumps(came), "sent", sent, flush=True)
            told_at += 5
        if now > begin + SETTINGS.get("leaves", 1e9):
            session.close()
            time.sleep(1e6)
        time.sleep(0.005)


main()
