"""What belongs to the paper alone: the ledger of its claims, and its messages one by one."""
