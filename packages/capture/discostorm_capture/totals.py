"""Two sums: what is sent for discovery, and what users' data take."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from discostorm_capture._bytes import Array

if TYPE_CHECKING:
    import pandas as pd

#: What a sum is called; the last is of what both share: the segments of TCP itself.
DISCOVERY, USERS = "discovery", "user data"
#: Of Zenoh, messages of users; those that carry others are what the others in their packet are.
_USERS = ("Push", "Request", "Response", "ResponseFinal")
_CARRIERS = ("Frame", "Fragment")


def user_data_share(rows: pd.DataFrame) -> Array:
    """Return the part of each message that is of users' data, from 0 to 1.

    A segment of TCP itself is shared as the other segments between its hosts are.
    """
    kind, frame = rows["kind"].to_numpy(str), rows["frame"].to_numpy()
    users = np.isin(kind, _USERS)
    carriers = np.isin(kind, _CARRIERS) & np.isin(frame, frame[users])
    part = (users | carriers | np.char.startswith(kind, "User")).astype(np.float64)
    own = (rows["protocol"] == "TCP").to_numpy()
    if own.any():
        # A number for each two hosts, whichever speaks.
        pairs = np.sort(rows[["sender", "receiver"]].to_numpy(str), axis=1)
        ends = np.unique(pairs, axis=0, return_inverse=True)[1].ravel()
        content = ~own & (rows["transport"] == "TCP").to_numpy()
        size = int(ends.max()) + 1
        weight = rows["frames"].to_numpy(np.float64)
        whole = np.bincount(ends[content], weight[content], size)
        theirs = np.bincount(ends[content], weight[content] * part[content], size)
        part[own] = (theirs / np.where(whole > 0, whole, 1.0))[ends[own]]
    return part


def traffic_totals(rows: pd.DataFrame, seconds: float) -> pd.DataFrame:
    """Return the two sums of messages that have their ``airtime_s``; see `Capture.sums`."""
    import pandas as pd

    part = user_data_share(rows)
    shares = pd.DataFrame({DISCOVERY: 1 - part, USERS: part}, index=rows.index)
    found = pd.DataFrame({"messages": shares.sum()}).rename_axis("what")
    for column in ("bytes", "airtime_s"):
        found[column] = shares.mul(rows[column], axis=0).sum()
    found["of_time"] = found["airtime_s"] / seconds if seconds > 0 else np.nan
    return found
