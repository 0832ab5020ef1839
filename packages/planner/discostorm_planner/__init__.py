"""Plan a fleet: compute what its discovery costs, and rank the changes that would help.

A remedy is a changed fleet, protocol or Wi-Fi, evaluated by the core's `utilization`; this package
has no formula of its own. The modules ``*_changes`` yield the changes, `plan` evaluates them,
`change_simulation` simulates the best of them, and `result` holds the `Plan`. `answer_text` and
`explanation_text` write its sentences. The files ``data/vendors/remedies.csv`` and ``efforts.csv``
say for which protocols a kind of remedy works, with which effort and which trade-offs.
"""

from discostorm_planner.plan import plan
from discostorm_planner.remedy import Remedy
from discostorm_planner.result import Plan, Share

__all__ = ["Plan", "Remedy", "Share", "plan"]
