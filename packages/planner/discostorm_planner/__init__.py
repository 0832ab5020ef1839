"""What discovery costs a fleet, what dominates, and what would help, alone and combined.

Every remedy is a changed fleet, protocol or Wi-Fi that goes through the same `utilization`;
no formula is stated here. `plan` tries what `fleets`, `tables` and `radios` change, `result` is
what comes of it, and `remedy` one line of that. For which protocols a kind of remedy works, what
it costs otherwise, how hard it is, what fails when and whether all robots still find each other is
data, which `known` reads: ``data/vendors/remedies.csv`` and ``efforts.csv``. What to paste is
`snippets`.
"""

from discostorm_planner.plan import plan
from discostorm_planner.remedy import Remedy
from discostorm_planner.result import Plan, Share

__all__ = ["Plan", "Remedy", "Share", "plan"]
