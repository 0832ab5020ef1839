"""Interactive lanes of captures on a page: the chapter's own captures, and a reader's."""

from collections.abc import Mapping
from typing import Any

from IPython.display import HTML

from discostorm.data import read_data
from discostorm.palette import PALETTE
from discostorm_book.figures.captures import ROWS
from discostorm_book.interactive import embed_data
from discostorm_capture import Capture

_PURPOSES = read_data("captures/purposes.csv", "discostorm_book")
#: Purposes of messages, by their kind.
PURPOSES = {row["kind"]: row["purpose"] for row in _PURPOSES if "{}" not in row["kind"]}
#: Purposes by the end of a kind; "{}" is the part before it.
PURPOSES_BY_ENDING = {row["kind"][2:]: row["purpose"] for row in _PURPOSES if "{}" in row["kind"]}
#: Zenoh's messages, by the DDS messages with the same purpose, whose row they share.
ZENOH_COUNTERPARTS = {"SPDP": ("Scout",), "SEDP": ("Declare",)}


def lane_rows() -> list[dict[str, Any]]:
    """Return the rows of a lane from its top: name, kinds of message and color."""
    listed: list[dict[str, Any]] = []
    for name, (kinds, _, _) in ROWS.items():
        both = (*kinds, *ZENOH_COUNTERPARTS.get(name, ()))
        color = PALETTE["shade", kinds[0]].property
        listed.append({"name": ", ".join(both), "kinds": both, "color": color})
    listed[-1]["name"] += ", others"
    return listed


def embed_capture_lanes(captures: Mapping[str, Capture], max_pairs: int, end_s: float) -> HTML:
    """Show captures as lanes to touch, up to a time [s]; list at most so many incomplete pairs."""
    shown = [{"name": name, "diagnosis": _excerpt(each)} for name, each in captures.items()]
    data: dict[str, Any] = {"rows": lane_rows(), "means": PURPOSES, "endings": PURPOSES_BY_ENDING}
    data |= {"most": max_pairs, "until": end_s, "captures": shown}
    scripts = (f"captures/{name}.js" for name in ("lanes", "told", "own"))
    return embed_data("lanes", data, "captures/captures.css", *scripts)


def _excerpt(capture: Capture) -> dict[str, Any]:
    """Return a part of a diagnosis as `discostorm capture --json` writes it."""
    found = capture.diagnosis().to_dict()
    hosts = [{key: host[key] for key in ("host", "knows_all_s")} for host in found["hosts"]]
    return {key: found[key] for key in ("complete_s", "timeline", "incomplete")} | {"hosts": hosts}
