"""Write one capture of each staged fault into a folder for other tools, with the true causes.

Reads the captures that `faults.py` and `unlisted_faults.py` made. Packets are cut to 400 bytes
where this changes nothing in the diagnosis. Beside the captures: `truth.csv`, `vocabulary.csv`,
`score_faults.py`, the answers of `discostorm capture`, and a data sheet.
"""

import argparse
import csv
import gzip
import io
import lzma
import shutil
import struct
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from faults import list_runs
from lab_data import write_table
from run_grid import BUILD, GRIDS, MEASURE
from unlisted_faults import table

import discostorm as ds
from discostorm.data import read_data
from discostorm_capture.pcap import PCAP_MAGICS

#: Columns of the true fault, and of the right causes and actions.
TRUTH_COLUMNS = ("true", "causes", "actions")
#: Bytes of a packet that are kept [B], and the most that all files take together [B].
KEPT_PACKET_BYTES, MAX_TOTAL_BYTES = 400, 60_000_000
README_TEXT = """# Captures of ROS 2 discovery with one thing wrong

{count} captures of small fleets, {bytes:,} bytes. Each fleet ran in network namespaces of one Linux
machine, on a bridge without losses of its own, with real middleware: {products}.
One thing was wrong with each fleet, or nothing. All addresses are private, and no person and no
robot took part.

DOI:

License: CC BY 4.0 (LICENSE-CC-BY-4.0.txt). How to cite: CITATION.cff of discostorm.

| file | what it has |
|---|---|
| `*.pcap.xz` | a capture; its packets are cut to {kept} bytes where `bytes_kept` says so |
| `truth.csv` | a row a capture: ill, product, version, what is true, right causes and actions |
| `vocabulary.csv` | the words for causes and actions, with what they mean |
| `answers.csv` | what `discostorm capture` says of these captures |
| `score_faults.py` | scores such a table: `python score_faults.py answers.csv` |

To score another tool, write a table with the columns `file`, `cause` and `action`, in the words of
`vocabulary.csv`. The tool must not look at the names of files, which name the ill. Several causes
are right where a capture cannot tell them apart.

Limits: one machine without a radio, at most {hosts} hosts, one fault at a time. The rules of
`discostorm capture` were written with such captures in view, so its score here says nothing about
new ones.
"""


def truncate_packets(content: bytes, max_bytes: int = KEPT_PACKET_BYTES) -> bytes:
    """Return a pcap file with packets truncated to a number of bytes."""
    order, _, header = PCAP_MAGICS[content[:4]]
    parts, at = [content[:24]], 24
    while at + header <= len(content):
        (size,) = struct.unpack_from(order + "I", content, at + 8)
        short = struct.pack(order + "I", min(size, max_bytes))
        parts.append(content[at : at + 8] + short + content[at + 12 : at + header])
        parts.append(content[at + header : at + header + min(size, max_bytes)])
        at += header + size
    return b"".join(parts)


def summarize_diagnosis(content: bytes) -> list[tuple[str, tuple[str, ...], str]]:
    """Return kind, hosts and first action of each finding of a capture."""
    findings = ds.read_capture(io.BytesIO(content)).diagnosis().findings
    return [(finding.kind, finding.hosts, finding.advice) for finding in findings]


def staged_captures(folder: Path) -> Iterator[tuple[dict[str, Any], Path]]:
    """Yield each staging of both tables with its first capture, if there is one."""
    for name, fault in table().items():
        once = folder.with_name("unlisted_ills") / f"{name}.pcap.gz"
        # A tool is not told which hosts are expected.
        if once.exists() and "expect" not in fault:
            truth = {key: "; ".join(fault[key]) for key in ("causes", "actions")}
            what = "healthy" if "nothing" in fault["causes"] else name
            yield fault | truth | {"ill": what, "stem": name}, once
    for job in list_runs(GRIDS / "faults.csv", [], 1):
        stem = job["name"].removesuffix("-r1")
        paths = [*sorted(folder.glob(f"{stem}-r?.pcap.gz")), folder / f"{stem}.pcap.xz"]
        if path := next((path for path in paths if path.exists()), None):
            yield job | {"stem": stem}, path


def product_version(product: str) -> str:
    """Return the version of a product of the lab, such as "zenoh_peer" or "fast_dds-server"."""
    name = product.partition("-")[0]
    rows = [row for row in read_data("vendors/products.csv") if row["product"].startswith(name)]
    return rows[0]["versions"]


def write_benchmark(folder: Path, out: Path) -> list[dict[str, Any]]:
    """Write the captures; return the table of their true causes."""
    with (GRIDS / "fault_truth.csv").open(newline="") as file:
        truth = {row.pop("ill"): row for row in csv.DictReader(file)}
    rows = []
    for job, path in staged_captures(folder):
        with (gzip if path.suffix == ".gz" else lzma).open(path) as file:
            content = file.read()
        short = truncate_packets(content)
        is_cut = short != content and summarize_diagnosis(short) == summarize_diagnosis(content)
        name = f"{job['stem']}.pcap.xz"
        (out / name).write_bytes(lzma.compress(short if is_cut else content))
        case = {key: job[key] for key in ("ill", "product", "hosts", "processes", "endpoints")}
        case |= {
            "version": product_version(job["product"]),
            "bytes_kept": KEPT_PACKET_BYTES if is_cut else "all",
        }
        true = job if "true" in job else truth[job["ill"]]
        rows.append({"file": name} | case | {key: true[key] for key in TRUTH_COLUMNS})
    return rows


def diagnosis_answer(path: Path) -> dict[str, str]:
    """Return the cause and first action that `discostorm capture` names first."""
    found = ds.read_capture(path).diagnosis().findings
    first = found[0] if found else None
    cause, action = (first.kind, first.remedy) if first else ("nothing", "none")
    return {"file": path.name, "cause": cause, "action": action or "none"}


def causes_and_actions() -> list[dict[str, str]]:
    """Return the words for causes and actions, with their meanings."""
    causes = read_data("diagnosis/findings.csv", "discostorm_capture")
    actions = read_data("diagnosis/remedies.csv", "discostorm_capture")
    rows = [{"of": "cause", "word": row["kind"], "means": row["summary"]} for row in causes]
    rows += [{"of": "action", "word": row["remedy"], "means": row["what"]} for row in actions]
    rows.append({"of": "cause", "word": "nothing", "means": "nothing is wrong"})
    return [*rows, {"of": "action", "word": "none", "means": "there is nothing to do"}]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--captures", type=Path, default=BUILD / "ills", help="folder to read")
    parser.add_argument("--out", type=Path, default=BUILD / "fault_benchmark", help="new folder")
    given = parser.parse_args()
    shutil.rmtree(given.out, ignore_errors=True)
    given.out.mkdir(parents=True)
    rows = write_benchmark(given.captures, given.out)
    if not rows:
        raise SystemExit(f"{given.captures}: there is no capture of grids/faults.csv; make ills")
    write_table(given.out / "truth.csv", rows)
    write_table(
        given.out / "answers.csv", [diagnosis_answer(given.out / row["file"]) for row in rows]
    )
    write_table(given.out / "vocabulary.csv", causes_and_actions())
    for path in (MEASURE / "score_faults.py", GRIDS.parents[1] / "LICENSE-CC-BY-4.0.txt"):
        shutil.copy(path, given.out)
    total = sum(path.stat().st_size for path in given.out.iterdir())
    products = sorted({f"{row['product']} {row['version']}" for row in rows})
    sheet = README_TEXT.format(
        count=len(rows),
        bytes=total,
        kept=KEPT_PACKET_BYTES,
        products=", ".join(products),
        hosts=max(int(row["hosts"]) for row in rows),
    )
    (given.out / "README.md").write_text(sheet, encoding="utf-8")
    if total > MAX_TOTAL_BYTES:
        raise SystemExit(
            f"{given.out}: {total:,} bytes; a release has room for {MAX_TOTAL_BYTES:,}"
        )
    print(f"{len(rows)} captures, {total:,} bytes in {given.out}")


if __name__ == "__main__":
    main()
