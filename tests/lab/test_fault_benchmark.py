"""The benchmark of sick fleets: built from stored captures, and scored as any tool would be."""

import csv
import io
import json
import lzma
import re
import subprocess
import sys
from pathlib import Path

import fault_benchmark
import fault_scores
import pytest
import score_faults
import unlisted_faults
from support import REFERENCE, ROOT

import discostorm as ds
from discostorm.data import data_path
from discostorm_capture.diagnosis.finding import finding_kinds, remedies

ILLS = REFERENCE / "captures" / "ills"


def table(path: Path) -> list[dict[str, str]]:
    with path.open(newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


@pytest.fixture(scope="module")
def benchmark(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A benchmark of four stored captures."""
    folder = tmp_path_factory.mktemp("captures")
    for name in ("firewall_on_one_host", "healthy", "multicast_filtered", "restart"):
        for path in sorted(ILLS.glob(f"{name}-*"))[:1]:
            (folder / path.name).write_bytes(path.read_bytes())
    out = folder / "benchmark"
    script = ROOT / "lab" / "measure" / "fault_benchmark.py"
    words = [sys.executable, str(script), "--captures", str(folder), "--out", str(out)]
    subprocess.run(words, check=True, capture_output=True)
    return out


def run_score_script(folder: Path, answers: Path) -> tuple[int, str]:
    """Run the script as another tool's author does, without this project."""
    words = [sys.executable, "-I", str(folder / "score_faults.py"), str(answers)]
    done = subprocess.run(words, capture_output=True, text=True, check=False)
    return done.returncode, done.stdout + done.stderr


def test_packets_are_cut_only_where_the_diagnosis_stays_the_same(benchmark: Path) -> None:
    rows = table(benchmark / "truth.csv")
    assert len(rows) == 4
    for row in rows:
        kept = ds.read_capture(benchmark / row["file"])
        whole = ds.read_capture(ILLS / row["file"])
        told = [
            [(one.kind, one.hosts, one.advice) for one in capture.diagnosis().findings]
            for capture in (kept, whole)
        ]
        assert told[0] == told[1]
        assert kept.packets == whole.packets
        long = len(lzma.decompress((ILLS / row["file"]).read_bytes()))
        short = len(lzma.decompress((benchmark / row["file"]).read_bytes()))
        assert short < long if row["bytes_kept"] == "400" else short == long


def test_a_packet_that_is_cut_keeps_its_time_and_its_length_on_the_wire() -> None:
    content = lzma.decompress((ILLS / "restart-cyclone_dds_0_10.pcap.xz").read_bytes())
    short = fault_benchmark.truncate_packets(content, 100)
    assert len(short) < len(content)
    before, after = (ds.read_capture(io.BytesIO(data)) for data in (content, short))
    assert (after.packets, after.duration) == (before.packets, before.duration)
    assert fault_benchmark.truncate_packets(content, 1 << 18) == content


def test_the_own_answers_are_scored_by_a_script_that_needs_only_python(benchmark: Path) -> None:
    code, said = run_score_script(benchmark, benchmark / "answers.csv")
    assert code == 0
    assert said.startswith("4 of 4 causes, 4 first actions\n0 false alarms in 1 healthy fleets\n")
    assert "restart: restart (1)" in said


def test_wrong_and_missing_answers_and_false_alarms_are_counted(
    benchmark: Path, tmp_path: Path
) -> None:
    truth = table(benchmark / "truth.csv")
    (healthy,) = (row["file"] for row in truth if row["ill"] == "healthy")
    (firewall,) = (row["file"] for row in truth if row["ill"] == "firewall on one host")
    answers = tmp_path / "answers.csv"
    answers.write_text(f"file,cause,action\n{healthy},crash,crash\n{firewall},firewall,none\n")
    code, said = run_score_script(benchmark, answers)
    assert code == 0
    assert said.startswith("1 of 4 causes, 0 first actions\n1 false alarms in 1 healthy fleets\n")
    assert "restart: no answer (1)" in said


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("file,cause\nx,y\n", "columns file, cause, action"),
        ("file,cause,action\nx.pcap,y,z\n", "'x.pcap' is no capture"),
    ],
)
def test_a_table_that_is_wrong_is_refused(
    benchmark: Path, tmp_path: Path, text: str, said: str
) -> None:
    answers = tmp_path / "answers.csv"
    answers.write_text(text)
    code, error = run_score_script(benchmark, answers)
    assert code == 1
    assert said in error


def test_the_sheet_has_a_license_a_field_for_the_doi_and_every_file(benchmark: Path) -> None:
    sheet = (benchmark / "README.md").read_text(encoding="utf-8")
    assert "License: CC BY 4.0" in sheet
    assert re.search(r"^DOI:$", sheet, re.MULTILINE)
    for path in benchmark.iterdir():
        named = path.name in sheet or path.name.endswith(".pcap.xz") or path.name == "README.md"
        assert named, path.name
    assert (benchmark / "LICENSE-CC-BY-4.0.txt").exists()


def test_what_is_true_is_told_of_each_ill_in_words_of_the_vocabulary() -> None:
    truth = table(ROOT / "lab" / "grids" / "fault_truth.csv")
    staged = {row["ill"] for row in table(ROOT / "lab" / "grids" / "faults.csv")}
    assert {row["ill"] for row in truth} == staged
    for row in truth:
        assert set(row["causes"].split("; ")) <= {*finding_kinds(), "nothing"}
        assert set(row["actions"].split("; ")) <= {*remedies(), "none"}
    words = json.dumps(fault_benchmark.causes_and_actions())
    assert all(f'"{word}"' in words for word in [*finding_kinds(), *remedies(), "nothing", "none"])


def test_a_confusion_table_has_a_row_an_ill() -> None:
    truth = [{"file": name, "ill": "crash", "causes": "crash"} for name in ("a", "b")]
    table_of = score_faults.count_confusions(truth, {"a": ("crash", ""), "b": ("restart", "")})
    assert table_of == {"crash": {"crash": 1, "restart": 1}}


def test_the_chapters_scores_are_those_of_the_stored_findings() -> None:
    path = data_path("measured/fault_scores.csv", "discostorm_book")
    rows = [{name: str(value) for name, value in row.items()} for row in fault_scores.score_rows()]
    assert table(path) == rows
    (loop,) = (row for row in rows if row["staged"] == "crash loop")
    assert (loop["causes"], loop["told_first"]) == ("15", "crash loop (14); restart (1)")


def test_right_answers_to_unlisted_ills_are_words_of_the_diagnosis() -> None:
    causes, actions = {*finding_kinds(), "nothing"}, {*remedies(), "none"}
    for ill in unlisted_faults.table().values():
        assert {*ill["causes"]} <= causes
        assert {*ill["actions"]} <= actions


def test_scores_of_unlisted_ills_follow_from_what_is_true() -> None:
    staged = unlisted_faults.table()
    rows = table(data_path("measured/unlisted_faults.csv", "discostorm_book"))
    assert {row["ill"] for row in rows} == {*staged}
    for row in rows:
        ill = staged[row["ill"]]
        right = row["cause"] in ill["causes"] and row["action"] in ill["actions"]
        assert (row["right"], row["true"]) == (str(int(right)), ill["true"])
