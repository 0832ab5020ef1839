"""Numbers and words for people."""

import pytest

from discostorm import wording


@pytest.mark.parametrize(
    ("seconds", "said"),
    [
        (0, "no time"),
        (5e-7, "0.5 µs"),
        (0.00123, "1.23 ms"),
        (0.0456, "45.6 ms"),
        (0.0999, "99.9 ms"),
        (0.1, "0.10 s"),
        (9.5, "9.50 s"),
        (10.5, "10.5 s"),
        (99.9, "99.9 s"),
        (100, "1.7 minutes"),
        (2907.1, "48 minutes"),
        (5999, "100 minutes"),
        (6000, "1.7 hours"),
        (86_400, "24 hours"),
        (48 * 3600, "2.0 days"),
        (1e9, "32 years"),
        (1e12, "31,700 years"),
        (1e15, "3e+07 years"),
        (float("inf"), "indefinitely"),
    ],
)
def test_times_in_words(seconds: float, said: str) -> None:
    assert wording.duration(seconds) == said


@pytest.mark.parametrize(
    ("share", "said"),
    [(0.5, "50%"), (0.994, "99%"), (0.995, "nearly all"), (1, "100%"), (0, "0%")],
)
def test_parts_in_words(share: float, said: str) -> None:
    assert wording.format_share(share) == said


@pytest.mark.parametrize(
    ("share", "said"),
    [
        (0.00087, "0.087%"),
        (0.01, "1%"),
        (0.994, "99%"),
        (0.995, "just below 100%"),
        (0.9969, "just below 100%"),
        (1, "100%"),
        (28.44, "2,844%"),
        (999_999.5, "99,999,950%"),
        (1e6, "1e+08%"),
        (3.7e15, "3.7e+17%"),
    ],
)
def test_percent_in_words(share: float, said: str) -> None:
    assert wording.percent(share) == said


@pytest.mark.parametrize(
    ("share", "said"),
    [
        (0.9994, "99.9%"),
        (0.9995, "<100.0%"),
        (1, "100.0%"),
        (0.0009, "0.09%"),
        (0, "0.0%"),
        (-0.05, "-5.0%"),
    ],
)
def test_percent_with_decimals(share: float, said: str) -> None:
    assert wording.percent(share, decimals=1, below_prefix="<") == said


def test_a_channel_that_is_just_full_does_not_fit() -> None:
    assert wording.below_capacity(0.9999999)
    assert not wording.below_capacity(1)
    assert [wording.last_integer_below(hosts) for hosts in (1, 6.99, 7, 7.01)] == [0, 6, 6, 7]


@pytest.mark.parametrize(
    ("written", "text"),
    [
        (wording.time_range(1.514, 27.67), "1.51 to 27.7 s"),
        (wording.time_range(0.0123, 1.5), "12.3 ms to 1.50 s"),
        (wording.time_range(2, 2), "2.00 s"),
        (
            wording.time_range(469, float("inf"), never="never done"),
            "7.8 minutes to never done",
        ),
        (wording.percent_range(0.1, 0.234), "10% to 23%"),
        (wording.percent_range(0.5, 0.5), "50%"),
        (wording.format_load(1.38, "of it", "its capacity"), "138% of it"),
        (wording.format_load(28.44, "of it", "its capacity"), "28.4 times its capacity"),
        (wording.format_load(1.5e6, "of it", "its capacity"), "1.5e+06 times its capacity"),
        (wording.airtime_text(1.375, 1), "1.38 s"),
        (wording.airtime_text(0.1, float("inf")), "10% of the time"),
        (wording.count_noun(1, "host"), "1 host"),
        (wording.count_noun(24, "process", "es"), "24 processes"),
        (wording.join_sentences("it fits", "", "both agree"), "it fits. Both agree"),
        (wording.no_break_spaces("2 hosts, 3 s"), "2 hosts, 3\N{NO-BREAK SPACE}s"),
    ],
)
def test_ranges_loads_counts_and_sentences(written: str, text: str) -> None:
    assert written == text


def test_lists_in_words() -> None:
    assert [wording.join_words(list("abc"[:n])) for n in range(4)] == [
        "",
        "a",
        "a and b",
        "a, b and c",
    ]


def test_lines_are_broken_between_words_and_not_before_a_unit() -> None:
    text = "- " + "word " * 14 + "and 144 Mbit/s"
    first, second = wording.wrap(text).split("\n")
    assert len(first) <= 79
    assert second == "  144 Mbit/s"
    assert wording.wrap("1 host " + "word " * 16).split("\n")[1].startswith("word")
    assert wording.wrap("12. " + "word " * 16).split("\n")[1].startswith("    word")
    assert wording.capitalized("802.11n and Zenoh") == "802.11n and Zenoh"
    assert wording.capitalized("") == ""
