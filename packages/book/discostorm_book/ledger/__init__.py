"""The ledger of the paper's claims."""
