"""The runs of failures: whoever did not lose another process heard it all along."""

import numpy as np

from discostorm_book import failure_runs
from discostorm_book.figures.servers import contact_after_failures, contact_after_failures_data
from discostorm_book.lab_counts import failure_summary, failure_times

#: Silence up to which a process counts as heard, as ``data/measured/README.md`` says [s].
SILENT = 2.0


def test_processes_lost_each_other_or_heard_each_other_all_along() -> None:
    rows = failure_summary()
    rows = rows[rows["phase"].eq("death") & rows["who"].isin(list(failure_runs._KNOWN))]
    rows = rows[rows["configuration"].isin(list(failure_runs.CONFIGURATIONS))]
    rows = rows[rows["event"].isin(["server killed", "server restarts"])]
    keys = rows[["configuration", "event", "phase", "who"]].drop_duplicates()
    assert len(keys) > 5
    for key in keys.itertuples(index=False):
        settled, lost, silence = (
            failure_times(*key, quantity) for quantity in ("settled", "unmatched", "silence")
        )
        assert ((settled > 0) == np.isfinite(lost)).all(), key
        assert ((settled > 0) | (silence < SILENT)).all(), key


def test_each_late_reunion_has_its_delay_after_the_server_came_back() -> None:
    rows = contact_after_failures_data()
    late = (rows["connected_from_s"] - rows["server_back_s"]).to_numpy()
    expected = [f"+{delay:.1f} s" for delay in late if delay > 0]
    texts = [text.get_text() for text in contact_after_failures().axes[0].texts]
    assert [text for text in texts if text.startswith("+")] == expected
    assert expected[:3] == ["+1.4 s", "+1.5 s", "+2.2 s"]
