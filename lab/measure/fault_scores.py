"""Score the first finding of each staged fault against its true cause, for a chapter.

Reads `lab/data/faults.csv`, as `fault_findings.py` wrote it, and `grids/fault_truth.csv`.
"""

import csv
from collections import Counter
from typing import Any

from lab_data import BOOK, read_lab_table, write_table
from run_grid import GRIDS
from score_faults import score_answers

from discostorm_capture.diagnosis.finding import finding_kinds

SOURCE = {"source": "lab/data/faults.csv; lab/grids/fault_truth.csv"}


def score_rows() -> list[dict[str, Any]]:
    """Return, for each fault, how many runs there are, and in how many which answer was right."""
    with (GRIDS / "fault_truth.csv").open(newline="") as file:
        truth = {row["ill"]: row for row in csv.DictReader(file)}
    rows = []
    for staged in dict.fromkeys(row["staged"] for row in read_lab_table("faults.csv")):
        known, files, answers = truth[staged.partition(",")[0]], [], dict[str, tuple[str, str]]()
        for number, row in enumerate(read_lab_table("faults.csv")):
            cause = row["found"].partition(";")[0]
            if row["staged"] == staged:
                for run in range(int(row["in"])):
                    files.append(known | {"file": f"{number} {run}"})
                    remedy = finding_kinds()[cause]["remedy"] if cause in finding_kinds() else ""
                    answers[f"{number} {run}"] = cause, remedy or "none"
        found = score_answers(files, answers)
        counts = Counter(cause for cause, _ in answers.values()).most_common()
        names = "; ".join(f"{cause} ({count})" for cause, count in counts)
        right = {name: found[name] for name in ("causes", "actions")}
        rows.append({"staged": staged, "runs": len(files)} | right | {"told_first": names} | SOURCE)
    return rows


if __name__ == "__main__":
    write_table(BOOK / "fault_scores.csv", score_rows())
