"""Score the answers of a tool on the benchmark's captures against the true causes.

    python score_faults.py ANSWERS.csv [TRUTH.csv]

ANSWERS has a row for each capture: `file`, `cause` and `action`, in the words of `vocabulary.csv`.
Where a tool finds nothing, the cause is "nothing" and the action "none". A capture without a row
counts as wrong. Needs nothing but Python.
"""

import csv
import sys
from collections import Counter
from pathlib import Path

UNANSWERED = "no answer"
Answers = dict[str, tuple[str, str]]


def read_rows(path: Path, columns: tuple[str, ...]) -> list[dict[str, str]]:
    """Return the rows of a table that has at least these columns."""
    with path.open(newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    lacking = [column for column in columns if rows and column not in rows[0]]
    if lacking or not rows:
        raise SystemExit(f"{path}: it must have rows with the columns {', '.join(columns)}")
    return rows


def read_answers(path: Path, known: set[str]) -> Answers:
    """Return cause and action by file."""
    answers: Answers = {}
    for row in read_rows(path, ("file", "cause", "action")):
        if row["file"] not in known:
            raise SystemExit(f"{path}: {row['file']!r} is no capture of the table of what is true")
        if row["file"] in answers:
            raise SystemExit(f"{path}: {row['file']!r} is there twice")
        answers[row["file"]] = row["cause"].strip(), row["action"].strip()
    return answers


def score_answers(truth: list[dict[str, str]], answers: Answers) -> dict[str, int]:
    """Return how many captures there are, right causes and actions, and false alarms."""
    found = Counter({"captures": len(truth)})
    for row in truth:
        cause, action = answers.get(row["file"], (UNANSWERED, UNANSWERED))
        right = cause in row["causes"].split("; ")
        found["causes"] += right
        found["actions"] += right and action in row["actions"].split("; ")
        found["healthy"] += row["ill"] == "healthy"
        found["false_alarms"] += row["ill"] == "healthy" and cause not in ("nothing", UNANSWERED)
    return dict(found)


def count_confusions(truth: list[dict[str, str]], answers: Answers) -> dict[str, Counter[str]]:
    """Return how often each cause was named for each fault."""
    table: dict[str, Counter[str]] = {}
    for row in truth:
        cause = answers.get(row["file"], (UNANSWERED, ""))[0]
        table.setdefault(row["ill"], Counter())[cause] += 1
    return table


def main() -> None:
    if len(sys.argv) not in (2, 3):
        raise SystemExit(__doc__)
    beside = Path(__file__).resolve().with_name("truth.csv")
    truth_path = Path(sys.argv[2]) if len(sys.argv) == 3 else beside
    truth = read_rows(truth_path, ("file", "ill", "causes", "actions"))
    answers = read_answers(Path(sys.argv[1]), {row["file"] for row in truth})
    found = score_answers(truth, answers)
    print("{causes} of {captures} causes, {actions} first actions".format_map(found))
    print("{false_alarms} false alarms in {healthy} healthy fleets".format_map(found))
    for fault, named in count_confusions(truth, answers).items():
        print(
            f"{fault}: " + ", ".join(f"{cause} ({count})" for cause, count in named.most_common())
        )


if __name__ == "__main__":
    main()
