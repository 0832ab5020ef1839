"""Numbers and words for people, and what "fits" means."""

import math
import re
import textwrap

#: From this on, numbers are told with their power of ten [1 or s].
HUGE = 1e6
#: What is said of a fleet of one host.
ALONE = "A single host has no one to discover, and no other host receives its messages."
#: What is said of the numbers of a radio that aggregates.
AGGREGATES = (
    "This radio aggregates: the answer lies between one frame in each exchange and full A-MPDUs."
)
#: How discovery is recorded so that nothing of it is lost; the chapter on captures says why.
RECORD = "tcpdump -i wlan0 -s 0 -w {file} 'udp or ip6 or (tcp and not port 22)'"


def fits(utilization: float) -> bool:
    """Return whether there is less of it than the channel has."""
    return utilization < 1


def whole_below(hosts: float) -> int:
    """Return the largest whole number of hosts that stays below saturation."""
    return math.ceil(hosts) - 1


def percent(share: float, decimals: int = 0, below: str = "just below ") -> str:
    """Return a share in percent, what is too small for the decimals to two digits.

    What is less than all is never told as 100%, but as below it.

    Examples
    --------
    >>> percent(0.954), percent(0.9999), percent(0.00087), percent(28.44)
    ('95%', 'just below 100%', '0.087%', '2,844%')
    """
    if 1 - 0.5 / 10 ** (decimals + 2) <= share < 1:
        return f"{below}{1:.{decimals}%}"
    if share >= HUGE:
        return f"{100 * share:.3g}%"
    if 0 < abs(share) < 10 ** -(decimals + 2):
        return f"{100 * share:.2g}%"
    return f"{share:,.{decimals}%}"


def charged(utilization: float, to: str, capacity: str) -> str:
    """Return the load of a time: in percent, from ten times its capacity on as times.

    Examples
    --------
    >>> charged(1.38, "of it", "its capacity"), charged(28.44, "of it", "its capacity")
    ('138% of it', '28.4 times its capacity')
    """
    if utilization < 10:
        return f"{percent(utilization)} {to}"
    times = f"{utilization:.3g}" if utilization >= HUGE else f"{float(f'{utilization:.3g}'):,g}"
    return f"{times} times {capacity}"


def part(share: float) -> str:
    """Return a part of a whole in percent; almost all of it as "nearly all"."""
    return "nearly all" if 0.995 <= share < 1 else percent(share)


#: From how many seconds on a time is told in which unit, and how long that is [s].
TIMES = (
    (0.0, 1e-6, "µs"),
    (1e-3, 1e-3, "ms"),
    (0.1, 1.0, "s"),
    (100.0, 60.0, "minutes"),
    (6000.0, 3600.0, "hours"),
    (48 * 3600.0, 86_400.0, "days"),
    (700 * 86_400.0, 31_557_600.0, "years"),
)


def duration(time: float) -> str:
    """Return a time as people tell it, to two digits or three.

    Examples
    --------
    >>> duration(0.00123), duration(0.0456), duration(1.375), duration(28.44)
    ('1.23 ms', '45.6 ms', '1.38 s', '28.4 s')
    >>> duration(2907.1), duration(349_491), duration(0), duration(math.inf)
    ('48 minutes', '4.0 days', 'no time', 'indefinitely')
    """
    if time == 0 or time == math.inf:
        return "indefinitely" if time else "no time"
    _, length, unit = next(row for row in reversed(TIMES) if abs(time) >= row[0])
    value = time / length
    if value >= HUGE:
        return f"{value:.0e} {unit}"
    if length < 1:
        return f"{value:.3g} {unit}"
    if length == 1:
        return f"{value:.2f} {unit}" if abs(value) < 10 else f"{value:.1f} {unit}"
    return f"{value:.1f} {unit}" if abs(value) < 10 else f"{float(f'{value:.3g}'):,.0f} {unit}"


def _between(low: str, high: str) -> str:
    """Return two ends in words, with the unit once where it is the same."""
    if low == high:
        return low
    number, _, unit = low.rpartition(" ")
    return f"{number if unit and high.endswith(f' {unit}') else low} to {high}"


def durations(low: float, high: float, never: str = "indefinitely") -> str:
    """Return a range of times as people tell it.

    Examples
    --------
    >>> durations(1.514, 27.67), durations(0.0123, 1.5), durations(2, 2)
    ('1.51 to 27.7 s', '12.3 ms to 1.50 s', '2.00 s')
    >>> durations(469, math.inf, never="never done")
    '7.8 minutes to never done'
    """
    return _between(*(duration(end) if math.isfinite(end) else never for end in (low, high)))


def percents(low: float, high: float) -> str:
    """Return a range of shares in percent.

    Examples
    --------
    >>> percents(0.1, 0.234), percents(0.5, 0.5)
    ('10% to 23%', '50%')
    """
    return _between(percent(low), percent(high))


def airtime(utilization: float, window: float) -> str:
    """Return the airtime of the window in seconds, in the steady state the share of the time."""
    if math.isinf(window):
        return percent(utilization) + " of the time"
    return duration(utilization * window)


def many(count: float, noun: str, plural: str = "s") -> str:
    """Return a count with its noun.

    Examples
    --------
    >>> many(1, "host"), many(24, "process", "es")
    ('1 host', '24 processes')
    """
    return f"{count:,.10g} {noun}{plural if count != 1 else ''}"


def listed(words: list[str], last: str = "and") -> str:
    """Return words with commas, and an "and" or another word before the last.

    Examples
    --------
    >>> listed(["SEDP", "Heartbeat", "ACKNACK"])
    'SEDP, Heartbeat and ACKNACK'
    """
    if len(words) < 2:
        return "".join(words)
    return f"{', '.join(words[:-1])} {last} {words[-1]}"


def sentences(*said: str) -> str:
    """Return what is said as sentences, but for the first capital and the last full stop.

    Examples
    --------
    >>> sentences("it fits", "", "both values use standard timing")
    'it fits. Both values use standard timing'
    """
    first, *rest = [one for one in said if one] or [""]
    return ". ".join((first, *map(capitalized, rest)))


def capitalized(sentence: str) -> str:
    """Return a sentence with a capital first letter; the others stay."""
    return sentence[:1].upper() + sentence[1:]


#: Units that stay with their number: a regular expression.
UNIT = r"(?:[mµn]?s|[kMG]?i?B|[MG]?Hz|Mbit/s|(?:second|minute|hour|day|year)s?)(?![\w/])"


def unbroken(text: str) -> str:
    """Return a text in which no line can end between a number and its unit.

    Examples
    --------
    >>> unbroken("2 hosts, 3 s, 11 Mbit/s").count("\N{NO-BREAK SPACE}")
    2
    """
    return re.sub(rf"(?<=\d) (?={UNIT})", "\N{NO-BREAK SPACE}", text)


def wrapped(line: str, width: int = 79) -> str:
    """Return a line broken at a width, but not between a number and its unit.

    What follows in an item of a list is indented.
    """
    indent = "  " if line.startswith("- ") else "    " if re.match(r" |\d+\. ", line) else ""
    lines = textwrap.fill(unbroken(line), width, subsequent_indent=indent, break_on_hyphens=False)
    return lines.replace("\N{NO-BREAK SPACE}", " ")
