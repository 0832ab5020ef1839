"""What discovery costs a fleet, what dominates, and what would help, alone and combined.

Every remedy is a changed fleet, protocol or Wi-Fi that goes through the same `utilization`; no
formula is stated here. ``*_changes`` yield the changes, `plan` tries them, `result` holds what
comes of it, and `explanation_text` says it. For which protocols a kind of remedy works, with which effort
and trade-offs, is data: ``data/vendors/remedies.csv`` and ``efforts.csv``.
"""

from discostorm_planner.plan import plan
from discostorm_planner.remedy import Remedy
from discostorm_planner.result import Plan, Share

__all__ = ["Plan", "Remedy", "Share", "plan"]
