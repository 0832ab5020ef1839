"""Interactive elements of pages: their data for scripts, and the questions that pages ask."""

import json
from collections.abc import Mapping, Sequence
from dataclasses import replace
from itertools import product
from typing import Any

import numpy as np
import pandas as pd
import sympy as sp
from IPython.display import HTML
from matplotlib.figure import Figure

from discostorm import figures
from discostorm.data import read_data
from discostorm.lookup import AnyProtocol, as_protocol
from discostorm.messages import ONCE, Protocol
from discostorm.model import utilization
from discostorm.notation import N_E, N_H, N_P, NOTATION, O_MULTI, O_UNI, R_MULTI, R_UNI
from discostorm.palette import PALETTE
from discostorm.protocols import PROTOCOLS
from discostorm.wifi import PAPER
from discostorm_book import enumeration, failure_runs, frame_trace, sweeps
from discostorm_book.facts import first_mismatch
from discostorm_book.figures import convergence, message_cost_charts, startup_queue
from discostorm_book.phone_figures import adapt_for_phone
from discostorm_book.show import payload_meaning

#: Endpoints that all processes of a robot have together: fewest and most to choose [1].
FIG3_ENDPOINT_LIMITS = (4, 100)
#: Processes at which the line of Fig. 3 starts, with the paper's endpoints: Sec. IV-B's most [1].
FIG3_FIRST_PROCESSES = 8
#: First settings of a reader's own starts: robots [1] and middleware.
FIRST_OWN_START = (10, "Fast DDS 3.6")
#: Choices for the queue: endpoints of a process, fewest and most [1]; periods [s].
QUEUE_ENDPOINTS = (0, 40)
QUEUE_PERIODS = tuple(range(1, 11))
#: Choices for the blocks of airtime: fewest and most hosts, processes and endpoints of each [1].
BLOCK_LIMITS = {N_H: (1, 20), N_P: (1, 5), N_E: (0, 40)}
_MESSAGE_WORDS = read_data("paper/message_words.csv", "discostorm_book")
#: A sentence for each of the paper's messages.
SENTENCES = {row["message"]: row["sentence"] for row in _MESSAGE_WORDS}
#: Units of the notation as pages show them: a factor and the unit.
_DISPLAY_UNITS = {"bit/s": (1e-6, "Mbit/s"), "s": (1e6, "µs"), "B": (1.0, "B")}
_CHAPTER_FILES = ("chapters/pages.css", "chapters/chapter.js")


def embed_data(name: str, data: Any, *files: str) -> HTML:
    """Put data on a page under a name, and load style sheets and scripts of ``book/_static``."""
    text = json.dumps(data, separators=(",", ":"), ensure_ascii=False).replace("</", r"<\/")
    parts = [f'<script type="application/json" id="{name}-data">{text}</script>']
    for address in (f"../_static/{file}" for file in files):
        sheet = f'<link rel="stylesheet" href="{address}">'
        parts.append(sheet if address.endswith(".css") else f'<script src="{address}"></script>')
    return HTML("\n".join(parts))


def ask_guess(
    question: str,
    answer: float,
    *,
    minimum: float,
    maximum: float,
    step: float,
    unit: str,
    given: Mapping[str, float] | None = None,
) -> HTML:
    """Ask for a guess before *In short* is read; numbers of the question are given facts."""
    if problem := first_mismatch(question, given or {}):
        raise ValueError(f"question and given disagree: {problem}")
    if not minimum < answer < maximum:
        raise ValueError(f"the answer, {answer:g}, must lie between {minimum:g} and {maximum:g}")
    digits = len(f"{step:g}".partition(".")[2])
    question = question.replace("'", "\N{RIGHT SINGLE QUOTATION MARK}")
    data = {"question": question, "answer": round(float(answer), digits)}
    data |= {"least": minimum, "most": maximum, "step": step, "places": digits, "unit": unit}
    return embed_data("guess", data, "chapters/pages.css", "guess.js")


def show_dials(
    title: str,
    lead: str,
    dials: Mapping[str, Sequence[str]],
    start: Sequence[int],
    bars: Mapping[str, tuple[AnyProtocol, Any]],
    *,
    maximum: float,
    limit: float | None = None,
    unit: str = " s",
) -> HTML:
    """Let the reader turn dials, and show the results as bars in the colors of protocols.

    The values of a bar have the shape of the dials; ``maximum`` and ``limit`` are in ``unit``.
    """
    shape = tuple(map(len, dials.values()))
    shown = []
    for name, (protocol, values) in bars.items():
        numbers = np.broadcast_to(values, shape).ravel().tolist()
        short = [float(f"{value:.3g}") if np.isfinite(value) else None for value in numbers]
        color = figures.css_color_property(as_protocol(protocol))
        shown.append({"name": name, "color": color, "values": short})
    named = zip(dials.items(), start, strict=True)
    turned = [{"label": label, "values": [*values], "start": at} for (label, values), at in named]
    data = {"title": title, "lead": lead, "dials": turned, "bars": shown, "most": maximum}
    data |= {"limit": limit, "unit": unit}
    return embed_data("choose", data, *_CHAPTER_FILES, "chapters/choose.js")


def step_messages(hosts: int, processes: int, endpoints: int) -> HTML:
    """Let the reader click through the messages of a swarm, one by one."""
    order = product(range(1, hosts + 1), range(1, processes + 1))
    index: dict[Any, int] = {enumeration.Process(*one): row for row, one in enumerate(order)}
    protocols = []
    for protocol in figures.PAPER_PROTOCOLS:
        kinds = [message.name for message in protocol.messages]
        every = enumeration.enumerate_messages(protocol.name, [[endpoints] * processes] * hosts)
        messages = []
        for sent in (one for one in every if one.hop == "up"):
            ends = [index.get(process) for process in (sent.sender, sent.receiver)]
            about = getattr(sent.about, "number", sent.about)
            named = about if isinstance(about, (int, str)) else ""
            messages.append([kinds.index(sent.kind), *ends, named])
        described = [
            {"name": kind, "color": PALETTE["shade", kind].property, "says": SENTENCES[kind]}
            for kind in kinds
        ]
        protocols.append({"name": protocol.name, "kinds": described, "messages": messages})
    data = {"processes": processes, "protocols": protocols}
    return embed_data("network", data, *_CHAPTER_FILES, "chapters/network.js")


def drag_line_of_fig3() -> HTML:
    """Let the reader drag the line of Fig. 3: the endpoints of a robot in all."""
    protocols = []
    for protocol in figures.PAPER_PROTOCOLS:
        known = protocol.values() | PAPER.values() | {N_H: figures.FIG3_HOSTS}
        terms = sp.Poly(protocol.utilization().subs(known), N_P, N_E).terms()
        # Powers of the processes and of the endpoints of each, and the factor.
        factors = [[i, j, _without_last_bits(factor)] for (i, j), factor in terms]
        color = figures.css_color_property(protocol)
        protocols.append({"name": protocol.name, "color": color, "terms": factors})
    data = {
        **_panel_positions(figures.fig3()),
        "hosts": figures.FIG3_HOSTS,
        "protocols": protocols,
        "endpoints": [*FIG3_ENDPOINT_LIMITS, figures.FIG3_ENDPOINTS_IN_ALL],
        "processes": [1, 10, FIG3_FIRST_PROCESSES],
    }
    return embed_data("line", data, *_CHAPTER_FILES, "chapters/line.js")


def adjust_queue(protocol: Protocol, hosts: int, processes: int, endpoints: int) -> HTML:
    """Let the reader change endpoints and period of a startup, and see when its queue clears."""
    schedules = dict.fromkeys(message.schedule for message in protocol.messages)
    rounds = []
    for schedule in schedules:
        messages = (m for m in protocol.messages if m.schedule == schedule)
        once = tuple(replace(message, schedule=ONCE, answers=None) for message in messages)
        table = Protocol(protocol.name, once)
        none, one = np.asarray(utilization(table, hosts, processes, [0.0, 1.0])).tolist()
        # Airtime without endpoints, and per endpoint of a process [s].
        airtime = [_without_last_bits(none), _without_last_bits(one - none)]
        repeats = bool(np.isfinite(schedule.period))
        rounds.append({"starts": list(schedule.starts), "repeats": repeats, "airtime": airtime})
    (period,) = {s.period for s in schedules if np.isfinite(s.period)}
    swarm = {"processes": processes, "endpoints": endpoints}
    periods = []
    for each in QUEUE_PERIODS:
        table = startup_queue.with_period(protocol, each)
        used = utilization(table, hosts, processes, endpoints, window=np.inf)
        periods.append([each, _without_last_bits(used)])
    data = {
        **_panel_positions(startup_queue.queue_over_time(protocol, hosts, swarm)),
        "color": figures.css_color_property(protocol),
        "hosts": hosts,
        "processes": processes,
        "rounds": rounds,
        "periods": periods,
        "period": period,
        "endpoints": [*QUEUE_ENDPOINTS, endpoints],
    }
    return embed_data("queue", data, *_CHAPTER_FILES, "chapters/queue.js")


def step_frames() -> HTML:
    """Let the reader step through a start, frame by frame."""
    scripts = ("chapter", "trace", "lanes_of_start", "scrub")
    sheets = ("chapters/pages.css", "chapters/live.css")
    files = (*sheets, "live/live.js", *(f"chapters/{name}.js" for name in scripts))
    return embed_data("scrub", frame_trace.page_data(), *files)


def run_own_starts(rows: pd.DataFrame, names: Sequence[str]) -> HTML:
    """Let the reader simulate starts beside the stored ones of the sweep ``convergence``."""
    columns = ["processes", "endpoints", "queue_frames", "queue_s", "until_s", "runs"]
    (common,) = rows[columns].drop_duplicates().astype(object).to_dict("records")
    hosts, name = FIRST_OWN_START
    # For each number of robots the quartiles [s], None for never, and how many runs converged.
    shown = ["hosts", *(f"convergence_time_s{end}" for end in ("_q25", "", "_q75")), "converged"]
    stored = rows.sort_values("hosts").astype(object).replace({np.inf: None})
    data = {
        **_panel_positions(convergence.time_quartiles(rows, names)),
        "begin": [names.index(name), hosts],
        "never": convergence.NEVER_AT,
        **{name: common[name] for name in ("runs", "processes", "endpoints")},
        "setting": {
            "radio": sweeps.sweep_channel().name,
            "queue": [common["queue_frames"], common["queue_s"]],
            "until": common["until_s"],
        },
        "middleware": [
            {
                "name": name,
                "color": figures.css_color_property(PROTOCOLS[name]),
                "stored": stored.loc[stored["protocol"] == name, shown].to_numpy().tolist(),
            }
            for name in names
        ],
    }
    files = ("pages.css", "live.css", "chapter.js", "own.js")
    return embed_data("own", data, "live/live.js", *(f"chapters/{file}" for file in files))


def adjust_blocks(hosts: int, processes: int, endpoints: int) -> HTML:
    """Let the reader change a swarm, and see the terms of equation (12) as blocks of airtime."""
    start = dict(zip(BLOCK_LIMITS, (hosts, processes, endpoints), strict=True))
    frames = message_cost_charts.frame_airtime_data().set_index(["message", "direction"])
    values: dict[sp.Symbol, float] = {}
    meanings = {quantity.symbol: quantity for quantity in NOTATION.values()}
    symbols = {symbol.name: [meanings[symbol].meaning, ""] for symbol in BLOCK_LIMITS}
    protocols = []
    for protocol in figures.PAPER_PROTOCOLS:
        values |= protocol.values() | PAPER.values()
        messages = []
        for message in protocol.messages:
            payload = message.payload_symbol
            (header,) = message.frame_symbolic.free_symbols - {payload}
            down = (R_MULTI, O_MULTI) if message.cast == "multicast" else (R_UNI, O_UNI)
            links = {"up": (R_UNI, O_UNI), "down": down}
            for symbol in (header, *links["up"], *links["down"]):
                factor, unit = _DISPLAY_UNITS[meanings[symbol].unit]
                shown = f"{float(f'{factor * float(values[symbol]):.6g}'):g} {unit}"
                symbols[symbol.name] = [meanings[symbol].meaning, shown]
            size = f"{float(values[payload]):g} B"
            symbols[payload.name] = [payload_meaning(protocol, message), size]
            row: dict[str, Any] = {"name": message.name, "count": _load_factors(message.load())}
            row |= {"header": header.name, "payload": payload.name}
            for way, (rate, overhead) in links.items():
                parts = frames.loc[(message.name, way), ["overhead_s", "bits_s"]]
                row[way] = {"rate": rate.name, "overhead": overhead.name}
                row[way]["seconds"] = list(map(_without_last_bits, parts))
            messages.append(row)
        color = figures.css_color_property(protocol)
        protocols.append({"name": protocol.name, "color": color, "messages": messages})
    data = {
        "sizes": [[symbol.name, *BLOCK_LIMITS[symbol], start[symbol]] for symbol in BLOCK_LIMITS],
        "symbols": symbols,
        "protocols": protocols,
    }
    sheets, scripts = ("pages.css", "blocks.css"), ("chapter.js", "blocks.js")
    return embed_data("blocks", data, *(f"chapters/{file}" for file in (*sheets, *scripts)))


def _load_factors(load: sp.Expr) -> list[list[Any]]:
    """Return the factors of a number of messages: a symbol, its subtrahend, and a power."""
    factors = []
    for factor in sp.Mul.make_args(sp.factor(load)):
        base, power = factor.as_base_exp()
        number, symbol = base.as_coeff_Add()
        factors.append(["" if base.is_Number else symbol.name, -int(number), int(power)])
    order = ["", *(symbol.name for symbol in BLOCK_LIMITS)]
    return sorted(factors, key=lambda factor: order.index(factor[0]))


def replay_failures() -> HTML:
    """Let the reader kill a server or router, and see who hears whom in each run of the lab."""
    data = [
        {"title": title, "victim": victim.replace("'", "\N{RIGHT SINGLE QUOTATION MARK}")}
        | {"routers": routers, "relations": failure_runs.observed_pairs(name)}
        | {"stagings": failure_runs.failures_of_configuration(name)}
        for name, (title, victim, routers) in failure_runs.CONFIGURATIONS.items()
    ]
    files = ("pages.css", "failures.css", "chapter.js", "failures.js")
    return embed_data("failures", data, *(f"chapters/{file}" for file in files))


def _without_last_bits(value: Any) -> float:
    """Return a number without its last bits, which differ between processors."""
    return float(f"{float(value):.12g}")


def _panel_positions(figure: Figure) -> dict[str, Any]:
    """Return the size of a figure and its panels' positions, on desktops and on phones."""
    return _size_and_panels(figure) | {"narrow": _size_and_panels(adapt_for_phone(figure))}


def _size_and_panels(figure: Figure) -> dict[str, Any]:
    with figures.style():
        figure.draw_without_rendering()
    panels = []
    for axis in figure.axes:
        box = axis.get_position()
        # Parts of the figure: from the left and from above.
        x = [round(float(x), 5) for x in (box.x0, box.x1)]
        y = [round(1 - float(y), 5) for y in (box.y0, box.y1)]
        limits = axis.get_xlim(), axis.get_ylim()
        xlim, ylim = (list(map(_without_last_bits, limit)) for limit in limits)
        panels.append({"x": x, "y": y, "xlim": xlim, "ylim": ylim})
    size = [round(96 * float(inches), 2) for inches in figure.get_size_inches()]
    return {"size": size, "panels": panels}
