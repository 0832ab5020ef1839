"""Changes of a channel: radio, multicast rate, aggregation."""

from collections.abc import Iterator
from dataclasses import replace
from typing import Any

from discostorm import wording
from discostorm.wifi import PAPER, Radio, Wifi
from discostorm.wifi.radio import USUAL_MPDUS, aggregation_bounds, most_mpdus
from discostorm_planner.changes import Change

#: The fastest mandatory OFDM rate [bit/s] (IEEE Std 802.11-2020, 17.2.2.3), and the number of
#: frames in an A-MPDU [1].
FASTER_MULTICAST_RATE, MAX_MPDUS = 24e6, USUAL_MPDUS
#: Other radios: changed parameters, and minimum number of streams.
OTHER_RADIOS: tuple[dict[str, Any], ...] = (
    {"standard": "802.11n", "width": 40e6},
    {"standard": "802.11ac", "width": 80e6},
    {"standard": "802.11ax", "width": 160e6},
)
MIN_STREAMS = 2


def radio_changes(wifi: Wifi) -> Iterator[Change | str]:
    """Yield faster multicast, other radios and aggregation, or the reason against a change."""
    radio = _comparable_radio(wifi)
    if isinstance(radio, str):
        yield f"another radio, multicast rate and aggregation: {radio}"
        return
    timed = replace(radio.wifi(), name=wifi.name) != wifi
    basis = "both values use the timing of the 802.11 standard" if timed else ""
    if radio.basic_rate < FASTER_MULTICAST_RATE:
        rates = f"{FASTER_MULTICAST_RATE / 1e6:g} instead of {radio.basic_rate / 1e6:g} Mbit/s"
        yield Change(
            "multicast rate",
            f"sending multicast at {rates}",
            "multicast rate",
            radio=lambda old: replace(old, multicast_rate=FASTER_MULTICAST_RATE, name=None),
            combined_note=basis,
        )
    for changes in OTHER_RADIOS:
        other = _other_radio(radio, changes)
        if other.rate > radio.rate:
            yield Change(
                "radio",
                f"another radio ({other.wifi().name})",
                "radio",
                radio=lambda old, changes=changes: _other_radio(old, changes),  # type: ignore[misc]
                note=_comparison_note(radio, other, basis),
                combined_note=basis,
            )
    if most_mpdus(radio.standard) == 1:
        yield f"aggregation: {radio.standard} has none"
    elif aggregation_bounds(wifi) != (wifi, wifi):
        yield "aggregation: already counted, because radios since 802.11n aggregate by default"
    elif radio.mpdus < MAX_MPDUS:
        yield Change(
            "aggregation",
            f"aggregating up to {MAX_MPDUS} frames",
            "aggregation",
            radio=lambda r: replace(r, mpdus=min(MAX_MPDUS, most_mpdus(r.standard)), name=None),
            combined_note=basis,
        )


def _comparable_radio(wifi: Wifi) -> Radio | str:
    """Return the radio of a channel, or the reason why its changes cannot be computed."""
    if wifi.radio is None:
        return (
            "the channel has rates and overheads but no Radio, so its back-off, preambles and "
            "symbols cannot be compared with those of another radio"
        )
    papers = (PAPER.unicast, PAPER.multicast, PAPER.aggregation)
    is_papers = (wifi.unicast, wifi.multicast, wifi.aggregation) == papers
    if is_papers or replace(wifi.radio.wifi(), name=wifi.name) == wifi:
        return wifi.radio
    return (
        "the channel was changed by hand and no longer matches its Radio, so it cannot be "
        "compared with the channel of another radio"
    )


def _other_radio(radio: Radio, changes: dict[str, Any]) -> Radio:
    """Return another radio at its top rate that keeps the present radio's settings."""
    rate = radio.multicast_rate
    return Radio(
        **changes,
        streams=max(MIN_STREAMS, int(radio.streams)),
        # DSSS rates exist in the 2.4 GHz band only.
        multicast_rate=rate if rate and rate >= Radio("802.11a").basic_rate else None,
        aifsn=radio.aifsn,
        mpdus=min(int(radio.mpdus), most_mpdus(changes["standard"])),
        start_spacing=radio.start_spacing,
    )


def _comparison_note(old: Radio, new: Radio, basis: str) -> str:
    """Compare the rates and the frame overhead of two channels."""
    before, after = old.wifi(), new.wifi()
    rates = _number_instead_of(after.unicast.rate / 1e6, before.unicast.rate / 1e6, "Mbit/s")
    was, becomes = ((wifi.aggregation or wifi.unicast).overhead * 1e6 for wifi in (before, after))
    overheads = _number_instead_of(becomes, was, "µs")
    multicast = _number_instead_of(new.basic_rate / 1e6, old.basic_rate / 1e6, "Mbit/s")
    differences = [rates, f"{overheads} of overhead per frame exchange"]
    differences += [f"multicast at {multicast}"] * (new.basic_rate != old.basic_rate)
    told = f"compared with {before.name}: {wording.join_words(differences)}"
    return wording.join_sentences(told, basis)


def _number_instead_of(new: float, old: float, unit: str) -> str:
    """Write a number and the number it replaces; write one number if both look the same."""
    return " instead of ".join(dict.fromkeys([f"{new:.0f}", f"{old:.0f}"])) + f" {unit}"
