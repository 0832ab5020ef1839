"""What all chapters share: question and answer, tables for people, numbers of the paper."""

import ast
import inspect
import json
import re
from dataclasses import replace
from html import escape, unescape
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import pytest
import yaml
from compare_facts import has_facts
from playwright.sync_api import Browser
from support import ROOT
from test_links import parsed
from test_pages import TOC, toc_files

import discostorm as ds
from discostorm_book import show
from discostorm_book.figures import message_cost_charts

CHAPTERS = sorted(
    page
    for page in toc_files(yaml.safe_load(TOC.read_text(encoding="utf-8")))
    if page.startswith("notebooks/")
)
#: Those whose equations and figures have numbers.
NUMBERED = {
    chapter["file"]
    for part in yaml.safe_load(TOC.read_text(encoding="utf-8"))["parts"]
    if part.get("numbered")
    for chapter in part["chapters"]
}


def cells(page: str) -> list[dict[str, Any]]:
    found = json.loads((ROOT / f"{page}.ipynb").read_text(encoding="utf-8"))["cells"]
    assert isinstance(found, list)
    return found


@pytest.mark.parametrize("page", CHAPTERS)
def test_a_chapter_asks_a_question_and_answers_it(page: str) -> None:
    first, *_ = cells(page)
    opening = "".join(first["source"])
    boxed = re.search(r"^:::\{admonition\} The question\. .+\?$", opening, re.M)
    assert boxed or re.search(r"^> \*\*The question\.\*\* .+\?$", opening, re.M | re.S)
    if has_facts(cells(page)):
        starts = re.findall(r"^\*\*(In short\.|Before you start:|Assumes:)\*\* ", opening, re.M)
        assert starts == ["In short.", "Before you start:", "Assumes:"]
        # A title may be a question, too.
        question = opening.partition("The question.")[2].partition("**In short.**")[0]
        assert question.count("?") == 1
        headings = [
            "".join(cell["source"]) for cell in cells(page) if cell["cell_type"] == "markdown"
        ]
        # One screen needs no second answer.
        answered = any(re.search(r"^## The answer$", text, re.M) for text in headings)
        assert answered != page.endswith("06_does_it_reproduce")
        assert re.search(r"^\*\*What is next\.\*\* .+", headings[-1], re.M)
        return
    code = [cell for cell in cells(page) if cell["cell_type"] == "code"]
    answers = [
        "".join(output["data"].get("text/markdown", ""))
        for output in code[-1]["outputs"]
        if "data" in output
    ]
    assert [answer.startswith("> **The answer.** ") for answer in answers] == [True]


@pytest.mark.parametrize("page", CHAPTERS)
def test_nothing_that_is_made_to_be_shown_is_lost(page: str) -> None:
    # Jupyter shows what the last line of a cell gives; the value of any other is thrown away.
    shows = {
        f"show.{name}"
        for name, function in inspect.getmembers(show, inspect.isfunction)
        if function.__module__ == show.__name__
        and inspect.signature(function).return_annotation is not None
    } | {"Markdown"}
    assert {"show.table", "show.download"} < shows
    lost = [
        ast.unparse(line)
        for cell in cells(page)
        if cell["cell_type"] == "code"
        for line in ast.parse("".join(cell["source"])).body[:-1]
        if isinstance(line, ast.Expr)
        and isinstance(line.value, ast.Call)
        and ast.unparse(line.value.func) in shows
    ]
    assert lost == []


def test_tables_are_for_people() -> None:
    frame = pd.DataFrame(
        {
            "slot_us": [9.0, np.inf],
            "how_many": [1, 2],
            "fits": [True, False],
            "share": ["95%", "1,000%"],
            "rows": ["1, 2", "3"],
        }
    )
    heads, rule, *rows = show.table(frame, {"slot_us": ".1f"}).data.splitlines()
    assert re.findall(r"[^| ][^|]*[^| ]", heads) == [
        "slot [µs]",
        "how many",
        "fits",
        "share",
        "rows",
    ]
    assert [mark.endswith(":") for mark in rule.strip("|").split("|")] == [
        True,
        True,
        False,
        True,
        False,
    ]
    assert [cell.strip() for cell in rows[1].strip("|").split("|")] == [
        "∞",
        "2",
        "no",
        "1,000%",
        "3",
    ]


def test_a_minus_is_one_for_people_and_a_hyphen_for_machines() -> None:
    frame = pd.DataFrame(
        {
            "change": [-1.25, -np.inf],
            "points": [-3, 2],
            "share": ["-4.9%", "+3%"],
            "remark": ["off by -6%, from 2 to -3, in 7-8", "`ours -5`, $N^{-1}$, IEEE-754"],
        }
    )
    *_, rule, one, two = show.table(frame, {"change": ".1f"}).data.splitlines()
    minus = "\N{MINUS SIGN}"
    assert [cell.strip() for cell in one.strip("|").split("|")] == [
        f"{minus}1.2",
        f"{minus}3",
        f"{minus}4.9%",
        f"off by {minus}6%, from 2 to {minus}3, in 7-8",
    ]
    assert [cell.strip() for cell in two.strip("|").split("|")] == [
        f"{minus}∞",
        "2",
        "+3%",
        "`ours -5`, $N^{-1}$, IEEE-754",
    ]
    assert [mark.endswith(":") for mark in rule.strip("|").split("|")] == [True] * 3 + [False]
    assert show.download(frame[["points"]], "fig-some").content == "points\n-3\n2\n"


def test_advice_of_the_planner_is_the_same_in_the_pages_type() -> None:
    plan = ds.plan(ds.Fleet.swarm(3, 8, 5))
    shown = show.Advice(plan)
    markdown, html = shown._repr_markdown_(), shown._repr_html_()
    assert unescape(re.sub(r"[*]", "", markdown)).split() == plan.why().split()
    assert "**Changes, in the same order as above:**\n\n1. " in markdown
    # The table of configurations keeps its columns.
    for found in plan.configurations:
        assert f"\n    {found.name} " in markdown
        assert f"  {escape(found.name)} " in html
    remedies = [remedy for found in plan.sections().values() for remedy in found]
    assert html.count('class="plan-card"') == len(remedies)
    assert "`" not in html
    read = re.sub(r"</?code>", "", html)
    for remedy in remedies:
        caution = remedy.caution().replace("`", "").replace("'", "\N{RIGHT SINGLE QUOTATION MARK}")
        assert escape(caution) in read
        for piece in remedy.snippets:
            assert escape(piece.text) in html


def test_who_tells_whom_is_read_off_the_table() -> None:
    def said(protocol: ds.Protocol) -> list[str]:
        (axis,) = message_cost_charts.who_tells_whom(protocol).axes
        return [text.get_text().replace("\n", ": ") for text in axis.texts if text.get_text()]

    dds = said(ds.DDS)
    assert [text for text in dds if ": " in text] == [
        "SPDP: to all",
        "SEDP: 2 to each",
        "Heartbeat: 2 to each",
        "ACKNACK: 2 to each",
    ]
    # Two frames of the multicast message; of each other message two for each of two receivers.
    hops = [text for text in dds if text.split()[-1] in {"up", "down"}]
    assert hops == [f"{n} {'up' if n % 2 else 'down'}" for n in range(1, 15)]
    thrice = tuple(replace(message, per_unit=3 * message.per_unit) for message in ds.ZENOH.messages)
    assert [text for text in said(replace(ds.ZENOH, messages=thrice)) if ": " in text][1:] == [
        "Hello: 3 to each",
        "Declare: 6 to each",
        "KeepAlive: 6 to each",
    ]


@pytest.mark.book
def test_equations_and_figures_of_the_paper_have_its_numbers(book: Path) -> None:
    papers, others = {}, []
    for page in CHAPTERS:
        html = parsed(book.resolve() / f"{page}.html")
        if page not in NUMBERED:
            assert not html.select("figure .caption-number, div.math .eqno")
            continue
        numbered = {
            str(equation["id"]): equation.select_one(".eqno")
            .get_text()
            .strip("()\N{PILCROW SIGN}# ")
            for equation in html.select("div.math[id^=equation-]")
        } | {
            str(figure["id"]): figure.select_one(".caption-number").get_text().strip()
            for figure in html.select("figure[id^=fig-]")
        }
        for name, number in numbered.items():
            if found := re.fullmatch(r"(equation-eq|fig)-paper-(\d+)", name):
                papers[found[1], int(found[2])] = number.removeprefix("Fig. ")
            else:
                others.append(number.removeprefix("Fig. "))
    wanted = [("equation-eq", n) for n in range(1, 13)] + [("fig", n) for n in range(1, 5)]
    assert papers == {key: str(key[1]) for key in wanted}
    assert all(re.fullmatch(r"\d+\.\d+", number) for number in others)


@pytest.mark.book
def test_one_switch_shows_all_code_and_stays_so_on_the_next_page(
    book: Path, browser: Browser
) -> None:
    folded = "div.cell.tag_hide-input > details.hide.above-input"
    tab = browser.new_page()
    tab.goto((book / f"{CHAPTERS[0]}.html").as_uri())
    switch = tab.get_by_role("button", name="All code")
    assert not tab.locator(folded).first.is_visible()
    switch.click()
    assert tab.locator(f"{folded}[open] pre").first.is_visible()
    tab.goto((book / f"{CHAPTERS[1]}.html").as_uri())
    assert tab.locator(f"{folded}[open] pre").first.is_visible()
    tab.get_by_role("button", name="Hide code").click()
    assert not tab.locator(folded).first.is_visible()
    tab.close()
    context = browser.new_context(java_script_enabled=False)
    tab = context.new_page()
    tab.goto((book / f"{CHAPTERS[0]}.html").as_uri())
    assert tab.locator(f"{folded} > summary").first.is_visible()
    context.close()
