"""Prototype of the hybrid discovery: its rules, simulated and over UDP (see ../README.md).

Its message tables belong to the core package: `discostorm.protocols.proposal`.
"""
