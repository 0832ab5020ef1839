"""Format numbers and sentences for people, and decide what "fits"."""

import math
import re
import textwrap

#: Threshold from which numbers are shown with a power of ten [1 or s].
HUGE = 1e6
#: Notes: on a fleet of one host, on a fleet without Wi-Fi, and on a radio that aggregates.
LONE_HOST_NOTE = "A single host has no one to discover, and no other host receives its messages."
ALL_WIRED_NOTE = "All hosts are wired; discovery needs no airtime."
AGGREGATION_NOTE = (
    "This radio aggregates frames: real airtime lies between single frames and full A-MPDUs."
)
#: The tcpdump command that captures all discovery traffic; the chapter on captures explains it.
TCPDUMP = "tcpdump -i wlan0 -s 0 -w {file} 'not tcp port 22'"


def below_capacity(utilization: float) -> bool:
    """Return whether a utilization is below 1, the capacity of the channel."""
    return utilization < 1


def last_integer_below(hosts: float) -> int:
    """Return the largest integer number of hosts below saturation."""
    return math.ceil(hosts) - 1


def percent(share: float, decimals: int = 0, below_prefix: str = "just below ") -> str:
    """Return a share in percent, with two digits if tiny; the prefix marks shares just below 1."""
    if 1 - 0.5 / 10 ** (decimals + 2) <= share < 1:
        return f"{below_prefix}{1:.{decimals}%}"
    if share >= HUGE:
        return f"{100 * share:.3g}%"
    if 0 < abs(share) < 10 ** -(decimals + 2):
        return f"{100 * share:.2g}%"
    return f"{share:,.{decimals}%}"


def format_load(utilization: float, to: str, capacity: str) -> str:
    """Return a load in percent, from ten times the capacity on as a multiple."""
    if utilization < 10:
        return f"{percent(utilization)} {to}"
    times = f"{utilization:.3g}" if utilization >= HUGE else f"{float(f'{utilization:.3g}'):,g}"
    return f"{times} times {capacity}"


def format_share(share: float) -> str:
    """Return a share in percent, or "nearly all"."""
    return "nearly all" if 0.995 <= share < 1 else percent(share)


#: Minimum of a time that has a unit, and the length of the unit [s].
TIME_UNITS = (
    (0.0, 1e-6, "µs"),
    (1e-3, 1e-3, "ms"),
    (0.1, 1.0, "s"),
    (100.0, 60.0, "minutes"),
    (6000.0, 3600.0, "hours"),
    (48 * 3600.0, 86_400.0, "days"),
    (700 * 86_400.0, 31_557_600.0, "years"),
)


def duration(time: float) -> str:
    """Return a time with its unit, to two or three digits."""
    if time == 0 or time == math.inf:
        return "indefinitely" if time else "no time"
    _, length, unit = next(row for row in reversed(TIME_UNITS) if abs(time) >= row[0])
    value = time / length
    if value >= HUGE:
        return f"{value:.0e} {unit}"
    if length < 1:
        return f"{value:.3g} {unit}"
    if length == 1:
        return f"{value:.2f} {unit}" if abs(value) < 10 else f"{value:.1f} {unit}"
    return f"{value:.1f} {unit}" if abs(value) < 10 else f"{float(f'{value:.3g}'):,.0f} {unit}"


def _range_with_unit(low: str, high: str) -> str:
    """Return a range, with a common unit only once."""
    if low == high:
        return low
    number, _, unit = low.rpartition(" ")
    return f"{number if unit and high.endswith(f' {unit}') else low} to {high}"


def time_range(low: float, high: float, never: str = "indefinitely") -> str:
    """Return a range of times; ``never`` stands for infinity."""
    return _range_with_unit(
        *(_duration_up_to_a_year(end) if math.isfinite(end) else never for end in (low, high))
    )


def _duration_up_to_a_year(time: float) -> str:
    """Return a time with its unit, from a year on as "more than a year"."""
    return duration(time) if time < TIME_UNITS[-1][1] else "more than a year"


def percent_range(low: float, high: float) -> str:
    """Return a range of shares in percent."""
    return _range_with_unit(percent(low), percent(high))


def airtime_text(utilization: float, window: float) -> str:
    """Return the airtime in a window with its unit; for an infinite window the share of time."""
    if math.isinf(window):
        return percent(utilization) + " of the time"
    return _duration_up_to_a_year(utilization * window)


def count_noun(count: float, noun: str, plural_ending: str = "s") -> str:
    """Return a count with its noun."""
    return f"{count:,.10g} {noun}{plural_ending if count != 1 else ''}"


def join_words(words: list[str], last: str = "and") -> str:
    """Return words with commas between, and a conjunction before the last."""
    if len(words) < 2:
        return "".join(words)
    return f"{', '.join(words[:-1])} {last} {words[-1]}"


def join_sentences(*clauses: str) -> str:
    """Join clauses to sentences; do not capitalize the first or add a last full stop."""
    first, *rest = [clause for clause in clauses if clause] or [""]
    return ". ".join((first, *map(capitalized, rest)))


def capitalized(sentence: str) -> str:
    """Return a sentence with a capital first letter; the others stay."""
    return sentence[:1].upper() + sentence[1:]


#: Units that stay with their number: a regular expression.
UNIT_PATTERN = r"(?:[mµn]?s|[kMG]?i?B|[MG]?Hz|Mbit/s|(?:second|minute|hour|day|year)s?)(?![\w/])"


def no_break_spaces(text: str) -> str:
    """Put a no-break space between each number and its unit."""
    return re.sub(rf"(?<=\d)[ \n](?={UNIT_PATTERN})", "\N{NO-BREAK SPACE}", text)


def wrap(line: str, width: int = 79) -> str:
    """Break a line at a width, but not before a unit; indent an item of a list."""
    indent = "  " if line.startswith("- ") else "    " if re.match(r" |\d+\. ", line) else ""
    lines = textwrap.fill(
        no_break_spaces(line), width, subsequent_indent=indent, break_on_hyphens=False
    )
    return lines.replace("\N{NO-BREAK SPACE}", " ")
