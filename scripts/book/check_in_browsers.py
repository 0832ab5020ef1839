"""Compare the built pages' texts in Firefox and Chromium, and measure frame rates.

Interactive pages are opened as files. The texts for screen readers are compared: each status line
and each slider. Chromium draws the first page for the frame rates, so run this on an idle machine.
"""

import argparse
import csv
import os
import shutil
import statistics
import sys
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

sys.path.append(str(Path(__file__).parents[1]))

from headless_firefox import AnswerServer, ask_firefox

if TYPE_CHECKING:
    from playwright.sync_api import Browser, Page

ROOT = Path(__file__).parents[2]
HTML = ROOT / "_build" / "html"
#: Tables that the book's page on checks reads.
PAGES_TABLE = ROOT / "packages/book/discostorm_book/data/simulated" / "pages.csv"
FRAME_RATES_TABLE = ROOT / "packages/book/discostorm_book/data/simulated" / "frames.csv"

#: Fragments of the pages' addresses.
PAGE_STATES = {"book/index.html": "#robots=5"}
#: Script: wait until the page has simulated, then return its texts.
WORD_SCRIPT = """async () => {
    const wait = (time) => new Promise((done) => setTimeout(done, time));
    document.getElementById("air")?.scrollIntoView();
    document.getElementById("calc-simulate")?.click();
    const busy = { "air-sum": /after/, "calc-simulated": /Simulated: / };
    const waits = ([id, said]) => {
        const element = document.getElementById(id);
        return element && !said.test(element.textContent);
    };
    for (let i = 0; i < 1200 && Object.entries(busy).some(waits); i++) await wait(100);
    await wait(1000);
    const press = { key: "ArrowRight", bubbles: true };
    for (const track of document.querySelectorAll("div[role=slider]"))
        track.dispatchEvent(new KeyboardEvent("keydown", press));
    const texts = (what, text) => [...document.querySelectorAll(what)].map(text);
    return {
        said: texts("[role=status], #air-sum", (element) => element.textContent),
        sliders: texts("[role=slider]", (element) => element.getAttribute("aria-valuetext")),
        errors: window.errors,
    };
}"""
ERROR_LOG_SCRIPT = """
    window.errors = [];
    addEventListener("error", ({ message }) => window.errors.push(message));
    addEventListener("unhandledrejection", ({ reason }) => window.errors.push(String(reason)));
"""
#: Script: record the time of each animation frame [ms].
FRAME_TIMES_SCRIPT = """
    window.frames_at = [];
    const request = window.requestAnimationFrame.bind(window);
    window.requestAnimationFrame = (callback) => request((at) => {
        window.frames_at.push(at);
        callback(at);
    });
"""
#: Number of robots, sizes of windows, and slowdown factors of the processor.
ROBOTS, SECONDS, ROUNDS = 12, 5, 3
VIEWPORTS = {"desktop": (1440, 900), "phone": (360, 740)}
CPU_SLOWDOWNS = (1, 4)
#: A reference page that draws one rectangle per frame.
REFERENCE_PAGE = """<canvas id=c></canvas><script>(function draw(at) {
    c.getContext("2d").fillRect(at / 10 - 100, 0, 1, 9);
    requestAnimationFrame(draw);
})(0)</script>"""


def list_scripted_pages() -> Iterator[str]:
    """Yield the pages that bring data for their own scripts."""
    for path in sorted(HTML.glob("[bn]*/*.html")):
        text = path.read_text(encoding="utf-8")
        if 'type="application/json" id="' in text or "calculator/calculator.js" in text:
            yield path.relative_to(HTML).as_posix()


@contextmanager
def chromium() -> "Iterator[Browser]":
    """Open headless Chromium."""
    from playwright.sync_api import sync_playwright

    with sync_playwright() as playwright:
        yield playwright.chromium.launch(
            executable_path=shutil.which("chromium"),
            args=["--no-sandbox", "--disable-dev-shm-usage", "--disable-background-networking"],
        )


def read_pages_in_chromium(pages: list[str]) -> tuple[str, dict[str, Any]]:
    """Return the texts of the pages in Chromium, with the network off."""
    found = {}
    with (
        chromium() as browser,
        browser.new_context(offline=True, reduced_motion="reduce") as context,
    ):
        for name in pages:
            page = context.new_page()
            page.add_init_script(ERROR_LOG_SCRIPT)
            page.goto((HTML / name).as_uri() + PAGE_STATES.get(name, ""))
            found[name] = page.evaluate(WORD_SCRIPT)
            page.close()
        return f"Chromium {browser.version.split('.')[0]}", found


def read_pages_in_firefox(pages: list[str], program: str = "firefox") -> tuple[str, dict[str, Any]]:
    """Return the texts of the pages in Firefox; a script in a copy of each page posts them here."""
    found: dict[str, Any] = {}
    version = ""
    with tempfile.TemporaryDirectory(dir=HTML.parent, ignore_cleanup_errors=True) as folder:
        copy = Path(folder, "html")
        shutil.copytree(HTML, copy, copy_function=os.link)
        for name in pages:
            with AnswerServer() as server:
                post = f"""<script>{ERROR_LOG_SCRIPT} addEventListener("load", async () => {{
                    const body = {{ found: await ({WORD_SCRIPT})(), browser: navigator.userAgent }};
                    const post = {{ method: "POST", mode: "no-cors", body: JSON.stringify(body) }};
                    fetch("http://127.0.0.1:{server.server_port}/", post);
                }})</script>"""
                text = (copy / name).read_text(encoding="utf-8")
                (copy / name).unlink()
                (copy / name).write_text(text.replace("<head>", f"<head>{post}", 1), "utf-8")
                profile = Path(folder, f"profile {len(found)}")
                profile.mkdir()
                (profile / "user.js").write_text('user_pref("ui.prefersReducedMotion", 1);\n')
                address = (copy / name).as_uri() + PAGE_STATES.get(name, "")
                answer = ask_firefox(program, profile, address, server)
            found[name] = answer["found"]
            version = answer["browser"].rpartition("/")[2].partition(".")[0]
    return f"Firefox {version}", found


def compare_browsers() -> list[dict[str, Any]]:
    """Return a row for each page: words in Chromium, and words that Firefox shows as well."""
    pages = list(list_scripted_pages())
    (first, here), (second, there) = read_pages_in_chromium(pages), read_pages_in_firefox(pages)
    rows = []
    for name in pages:
        said = [*here[name]["said"], *here[name]["sliders"]]
        again = [*there[name]["said"], *there[name]["sliders"]]
        for one, other in zip(said, again, strict=False):
            if one != other:
                print(f"{name}: {one!r}\n  but in {second}: {other!r}")
        rows.append(
            {
                "page": name.removesuffix(".html"),
                "texts": len(said),
                "same": sum(map(str.__eq__, said, again)) if len(said) == len(again) else 0,
                "errors": len(here[name]["errors"]) + len(there[name]["errors"]),
                "browsers": f"{first}; {second}",
                "source": "scripts/book/check_in_browsers.py",
            }
        )
    return rows


def measure_frame_rate() -> list[dict[str, Any]]:
    """Return the frame rate of the first page and of a reference page, with processor times.

    The reference page draws next to nothing and shows the machine's speed at that time.
    """
    first = (HTML / "book" / "index.html").as_uri()
    lanes = {"none": f"data:text/html,{REFERENCE_PAGE}", "one": f"{first}#robots={ROBOTS}"}
    lanes["two"] = lanes["one"] + "&compare=Zenoh+peer"
    rows = []
    with chromium() as browser:
        for view, (width, height) in VIEWPORTS.items():
            for middlewares, address in lanes.items():
                size: Any = {"width": width, "height": height}
                with browser.new_context(viewport=size, offline=True) as context:
                    page = context.new_page()
                    page.add_init_script(FRAME_TIMES_SCRIPT)
                    page.goto(address)
                    rates, spent = _rates(page)
                row = {"robots": ROBOTS, "view": view, "middlewares": middlewares}
                row |= {"ms_per_frame": f"{spent:.2f}"}
                row |= {f"frames_{slower}": f"{rate:.1f}" for slower, rate in rates.items()}
                row |= {"browser": f"Chromium {browser.version.split('.')[0]}"}
                rows.append(row | {"source": "scripts/book/check_in_browsers.py"})
                print(", ".join(map(str, rows[-1].values())), flush=True)
    return rows


def _rates(page: "Page") -> tuple[dict[int, float], float]:
    """Return frame rates by slowdown of the processor, and the processor time per frame [ms]."""
    session = page.context.new_cdp_session(page)
    session.send("Performance.enable", {"timeDomain": "threadTicks"})

    def spent() -> float:
        metrics = session.send("Performance.getMetrics")["metrics"]
        return next(float(one["value"]) for one in metrics if one["name"] == "TaskDuration")

    rates, each = {}, []
    for slower in CPU_SLOWDOWNS:
        session.send("Emulation.setCPUThrottlingRate", {"rate": slower})
        found = []
        for _ in range(ROUNDS):
            if page.locator("#air-again").count():
                page.locator("#air-again").click()
                page.locator("#air-canvas").scroll_into_view_if_needed()
            page.wait_for_timeout(1000)
            page.evaluate("window.frames_at.length = 0")
            before = spent()
            page.wait_for_timeout(SECONDS * 1000)
            after, at = spent(), page.evaluate("window.frames_at")
            found.append(1e3 * (len(at) - 1) / (at[-1] - at[0]))
            if slower == 1:
                each.append(1e3 * (after - before) / len(at))
        rates[slower] = statistics.median(found)
    return rates, statistics.median(each)


def write_csv(path: Path, rows: list[dict[str, Any]]) -> None:
    """Write rows as a table."""
    with path.open("w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, list(rows[0]), lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


def main() -> None:
    """Compare the texts or measure frame rates, and write the table."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("what", choices=["said", "frames"])
    if parser.parse_args().what == "frames":
        write_csv(FRAME_RATES_TABLE, measure_frame_rate())
        return
    rows = compare_browsers()
    write_csv(PAGES_TABLE, rows)
    wrong = [row["page"] for row in rows if row["errors"] or row["same"] != row["texts"]]
    print(f"{len(rows)} pages, {sum(row['texts'] for row in rows)} texts")
    if wrong:
        raise SystemExit(f"discostorm: not as they should be: {', '.join(wrong)}")


if __name__ == "__main__":
    main()
