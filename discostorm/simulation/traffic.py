"""From fleet, protocol and channel to the arrays that the inner loops take."""

import numpy as np

from discostorm.simulation import cell as _cell
from discostorm.simulation.cell import NEVER, Cell

TICK = 1e-7


def ticks(seconds):
    return int(round(seconds / TICK)) if seconds != np.inf else int(NEVER)


def radio_80211n(mpdus=1, queue=(500, 0.5), grid=36, **k):
    frames, seconds = queue if queue is not None else (NEVER, np.inf)
    d = dict(slot=90, sifs=160, aifs=160 + 270, cw_min=15, cw_max=1023, attempts=7, edca=1,
        timeout=450, heard=0, ack=280, block_ack=320, request=320 , preamble=400, symbol=36, grid=grid,
        bits=520, added=22, mpdus=mpdus, most_bytes=65535, window=64, queue=int(frames),
        lifetime=ticks(seconds)) | k
    r = np.zeros(1, _cell.RADIO)
    for n, v in d.items(): r[n] = v
    return r


def build(hosts, processes, endpoints, messages, radio, seed, loss=0.0, pool=4096, log=4096):
    R = radio[0]
    K = len(messages)
    n = hosts + 1
    st = np.zeros(n, _cell.STATION)
    for f in ("head", "tail", "to_head", "to_tail", "behind"): st[f] = -1
    st["processes"][:hosts] = processes
    st["endpoints"][:hosts] = endpoints
    st["first"][:hosts] = np.arange(hosts) * processes
    st["loss"] = loss
    pr = np.zeros(hosts * processes, np.dtype([("host", np.int64)]))
    pr["host"] = np.repeat(np.arange(hosts), processes)
    kinds = np.zeros(K, _cell.KIND)
    def data(o):
        sym = -(-(R["added"] + 8*o)//R["bits"])
        return R["preamble"] + -(-sym*R["symbol"]//R["grid"])*R["grid"]
    def slow(o):
        return 200 + -(-(22+8*o)//24)*40
    q = 2 if R["mpdus"] > 1 else 0
    for i, (o, m, per, ee) in enumerate(messages):
        kinds[i]["octets"] = o; kinds[i]["multicast"] = m; kinds[i]["per"] = per; kinds[i]["each_endpoint"] = ee
        kinds[i]["up"] = kinds[i]["down"] = 1
        kinds[i]["time_up"] = data(o + q); kinds[i]["time_down"] = slow(o + q) if m else data(o + q)
    now = np.zeros(1, _cell.NOW)
    now["base"] = 90
    now["step"] = 10_000
    now["spare"] = pool
    now["hosts"] = hosts; now["links"] = hosts - 1; now["kinds"] = K
    now["per_receiver"] = R["mpdus"] > 1
    now["random"] = np.random.SeedSequence(seed).generate_state(1, np.uint64).view(np.int64)
    p = np.zeros(pool, _cell.WAITING); p["next"] = np.arange(1, pool + 1)
    wheel = 1 << int(4 * (R["cw_max"] + 2)).bit_length()
    b = np.ones((1, K + 1), np.int64); b[:, K] = 0
    return Cell(radio=radio, now=now, stations=st, window=np.zeros((n, R["mpdus"]), _cell.HELD),
        wheel=np.full(wheel, -1, np.int64), strays=np.zeros(n, _cell.STRAY), senders=np.zeros(max(n, 64), _cell.SENDER),
        pool=p, events=np.zeros(8 * hosts + 1024, _cell.EVENT), kinds=kinds, batches=b, processes=pr,
        airtime=np.zeros((K + 1, 3), np.int64), samples=np.zeros(512, _cell.SAMPLE), log=np.zeros(log, _cell.SENT))


def grow(cell):
    size = cell.pool.size
    pool = np.zeros(2 * size, _cell.WAITING)
    pool[:size] = cell.pool
    pool["next"][size:] = np.arange(size + 1, 2 * size + 1)
    pool["next"][-1] = cell.now[0]["free"]
    cell.now["free"] = size
    cell.now["spare"] += size
    return cell._replace(pool=pool)


DDS = [(414, 1, 1, 0), (464, 0, 1, 1), (116, 0, 2, 0), (114, 0, 2, 0)]
ZENOH = [(80, 1, 1, 0), (144, 0, 1, 0), (176, 0, 1, 1), (84, 0, 2, 0)]


def run(cell, starts=None, until=10**15):
    from discostorm.simulation.engine import MEMORY, OVER, advance
    for h in range(cell.now[0]["hosts"]):
        cell.events["time"][h] = 0 if starts is None else int(starts[h]); cell.events["what"][h] = h
    cell.now["events"] = cell.now["coming"] = h + 1
    while True:
        r = advance(cell, until, 128, 10_000_000)
        if r == OVER:
            return cell
        if r == MEMORY:
            cell = grow(cell)
