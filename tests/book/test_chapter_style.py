"""How chapters teach: first a difficulty, few numerals in running text, exercises that compute."""

import re

import pytest
from compare_facts import read_cells
from support import ROOT

from discostorm_book.facts import numerals

#: Whose running text has few numerals, and whose exercises stand where they are needed.
TEACHING = [
    "01_who_tells_whom",
    "02_message_to_airtime",
    "03_hosts",
    "04_processes",
    "05_nav2",
]
#: Which look up rows or details, and may have more numerals.
APPENDIX = [
    "16_ledger",
    "17_enumeration",
    "18_constants",
    "19_uncertainty",
    "20_fits",
    "21_command_line",
    "22_checks",
]
#: Which begin with a difficulty, and whose running text has few numerals.
OPENED = [
    "00_captures",
    *TEACHING,
    "06_does_it_reproduce",
    "07_what_100_percent_means",
    "08_any_wifi",
    "09_mixed_fleets",
    "10_products",
    "10b_releases",
    "11_burst_on_air",
    "12_convergence",
    "12b_air",
    "15b_what_to_change",
    "14_servers",
    "15_hybrid",
]
EXERCISE = re.compile(
    r"^\*\*(\d+)\.\*\* (★{1,3}) \*(?:Predict|Derive|Break an assumption)\.\* ", re.MULTILINE
)

#: A box with the question and the short answer, then one folded line.
_BOX = re.compile(
    r"^:::\{admonition\} The question\. (?P<question>[^\n]+\?)\n:class: question\n\n"
    r"\*\*In short\.\*\* (?P<answer>.+?)\n:::\n\n"
    r":::\{dropdown\} Before you start, and what this chapter assumes\n"
    r"\*\*Before you start:\*\* .+?\n\n\*\*Assumes:\*\* .+?\n:::\s*\Z",
    re.MULTILINE | re.DOTALL,
)
#: What is no running text: tables, equations, answers of exercises, directives.
_SET_OFF = re.compile(
    r"""
    ^[ ]*\|[^\n]*$
    | ^\$\$.*?^\$\$[^\n]*$
    | ^:::\{dropdown\}\ Answer$.*?^:::$
    | ^:{3,}[^\n]*$
    | ^:class:[^\n]*$
    """,
    re.VERBOSE | re.MULTILINE | re.DOTALL,
)


def markdown(chapter: str) -> list[str]:
    """Return the Markdown cells of a chapter."""
    cells = read_cells(ROOT / "notebooks" / f"{chapter}.ipynb")
    return ["".join(cell["source"]) for cell in cells if cell["cell_type"] == "markdown"]


def running_text(text: str) -> str:
    """Return the running text of a chapter: sections that compute by hand are worked examples."""
    sections = re.split(r"^(?=#{1,3} )", text, flags=re.MULTILINE)
    kept = [one for one in sections if not re.match(r"#+ [^\n]*\bby hand\b", one)]
    return _SET_OFF.sub("", "".join(kept))


def numerals_per_100_words(text: str) -> float:
    """Return how many numbers in digits a text has for each hundred words."""
    digits = [numeral for numeral in numerals(text) if not numeral.optional]
    return 100 * len(digits) / len(re.findall(r"[^\W_][\w'’,.-]*", text))


def test_numerals_are_counted_in_running_text_only() -> None:
    text = (
        "# Title\n\nOf 7 robots, 2 fit. See chapter 3.\n\n| 1 | 2 |\n\n$$\n3 + 4\n$$ (eq)\n\n"
        "## One swarm by hand\n\n1 + 8 = 9\n\n## More\n\n"
        ":::{dropdown} Answer\nIt is 5.\n:::\n\nEnd."
    )
    kept = running_text(text)
    assert [n.text for n in numerals(kept) if not n.optional] == ["7", "2"]
    assert numerals_per_100_words("4 robots and " * 50) == pytest.approx(100 / 3)


@pytest.mark.parametrize("chapter", OPENED)
def test_running_text_has_few_numerals(chapter: str) -> None:
    assert numerals_per_100_words(running_text("\n\n".join(markdown(chapter)))) <= 3


@pytest.mark.parametrize("chapter", OPENED)
def test_a_chapter_begins_with_its_difficulty(chapter: str) -> None:
    first = markdown(chapter)[0]
    box = _BOX.search(first)
    assert box
    scene = re.sub(r"^(\(.+\)=|# .+)$", "", first[: box.start()], flags=re.MULTILINE)
    assert 100 <= len(scene.split()) <= 200
    assert len([n for n in numerals(scene) if not n.optional]) <= 2
    assert "?" in scene  # what would the reader guess?


@pytest.mark.parametrize("chapter", [*OPENED, *APPENDIX])
def test_an_exercise_says_what_to_do_and_how_hard_it_is(chapter: str) -> None:
    text = "\n\n".join(markdown(chapter))
    begun = re.findall(r"^\*\*(\d+)\.\*\*", text, re.MULTILINE)
    assert [found[1] for found in EXERCISE.finditer(text)] == begun
    assert begun or not re.search(r"^## Exercises?$|dropdown\} Answer$", text, re.MULTILINE)


@pytest.mark.parametrize("chapter", TEACHING)
def test_exercises_come_where_they_are_needed_and_compute(chapter: str) -> None:
    cells = read_cells(ROOT / "notebooks" / f"{chapter}.ipynb")
    text = "\n\n".join(markdown(chapter))
    assert "## Exercise" not in text
    assert [int(found[1]) for found in EXERCISE.finditer(text)] == [
        *range(1, len(re.findall(r"^\*\*\d+\.\*\*", text, re.MULTILINE)) + 1)
    ]
    asked = [i for i, cell in enumerate(cells) if EXERCISE.search("".join(cell["source"]))]
    assert len(asked) >= 3
    for index in asked:
        computation, answer = cells[index + 1 : index + 3]
        assert EXERCISE.search("".join(cells[index]["source"]).rpartition("\n\n")[2])
        assert computation["metadata"]["mystnb"]["code_prompt_show"] == "Show the computation"
        assert {"hide-cell", "facts"} <= set(computation["metadata"]["tags"])
        assert "".join(answer["source"]).startswith(":::{dropdown} Answer\n")


@pytest.mark.parametrize("chapter", TEACHING)
def test_a_figure_of_the_paper_is_called_so(chapter: str) -> None:
    figure = r"(?:\{numref\}`fig-paper-\d`|Fig\. \d(?!\.\d))"
    for text in markdown(chapter):
        for found in re.finditer(figure, text):
            around = text[max(0, found.start() - 15) : found.end() + 15].replace("\n", " ")
            assert re.search(
                r"(?:paper's|its) " + figure + "|" + figure + " of the paper", around
            ), around
