"""Captures on a page as lanes to touch: the chapter's own, and those that a reader drops there."""

from collections.abc import Mapping
from typing import Any

from IPython.display import HTML

from discostorm.palette import PALETTE
from discostorm_book.figures.captures import ROWS
from discostorm_book.pages import carried
from discostorm_capture import Capture

#: Purposes of messages, by their kind.
MEANS = {
    "SPDP": "announces a process",
    "SEDP": "announces an endpoint",
    "Heartbeat": "says which endpoint announcements there are",
    "ACKNACK": "confirms endpoint announcements or asks for missing ones",
    "Gap": "says which endpoint announcements are void",
    "Liveliness": "renews a lease",
    "Type lookup": "asks for a data type",
    "User data": "is what the robots\N{RIGHT SINGLE QUOTATION MARK} programs send",
    "Encrypted": "can't be read",
    "Encrypted key exchange": "exchanges keys for encryption",
    "Authentication": "proves who a process is",
    "Scout": "looks for other processes",
    "Hello": "answers a Scout",
    "Init": "begins a session",
    "Open": "opens a session",
    "Close": "ends a session",
    "Declare": "announces an endpoint",
    "Declare key expression": "numbers a name for the announcements that follow",
    "Declare final": "ends an answer of announcements",
    "Undeclare": "takes back an announcement",
    "Interest": "asks which endpoints there are",
    "OAM": "exchanges link states",
    "KeepAlive": "renews a lease",
    "Frame": "carries other messages",
    "Fragment": "carries a part of a message",
    "Push": "is what the robots\N{RIGHT SINGLE QUOTATION MARK} programs send",
    "Request": "asks a program",
    "Response": "answers a program",
    "ResponseFinal": "ends the answers of a program",
    "TCP ACK": "confirms that bytes arrived",
    "TCP control": "opens or ends a connection",
    "TCP retransmission": "is sent again, because it was not confirmed",
}
#: Purposes by the end of a kind; "{}" is the kind before it.
ENDINGS = {
    " Heartbeat": "says which {} messages there are",
    " Gap": "says which {} messages are void",
    " HEARTBEAT_FRAG": "says which parts of {} messages there are",
    " ACKNACK": "confirms {} messages or asks for missing ones",
}
#: Messages of Zenoh, where those of DDS that do the same are drawn.
LIKE = {"SPDP": ("Scout",), "SEDP": ("Declare",)}


def rows() -> list[dict[str, Any]]:
    """Return the rows of a lane from its top, with kinds and color; the last has others, too."""
    listed: list[dict[str, Any]] = []
    for name, (kinds, _, _) in ROWS.items():
        both = (*kinds, *LIKE.get(name, ()))
        color = PALETTE["captured", name].property if name in LIKE else "--ds-neutral-gray"
        listed.append({"name": ", ".join(both), "kinds": both, "color": color})
    listed[-1]["name"] += ", others"
    return listed


def lanes(captures: Mapping[str, Capture], most: int, until: float) -> HTML:
    """Let readers touch the messages of captures, all on one clock, and of captures of their own.

    At first so many pairs that never completed are listed, and so many seconds are shown.
    """
    data = {
        "rows": rows(),
        "means": MEANS,
        "endings": ENDINGS,
        "most": most,
        "until": until,
        "captures": [
            {"name": name, "diagnosis": _diagnosis(capture)} for name, capture in captures.items()
        ],
    }
    scripts = (f"captures/{name}.js" for name in ("lanes", "told", "own"))
    return carried("lanes", data, "captures/captures.css", *scripts)


def _diagnosis(capture: Capture) -> dict[str, Any]:
    """Return a part of a diagnosis as `discostorm capture --json` writes it."""
    told = capture.diagnosis().to_dict()
    hosts = [{key: host[key] for key in ("host", "knows_all_s")} for host in told["hosts"]]
    return {key: told[key] for key in ("complete_s", "timeline", "incomplete")} | {"hosts": hosts}
