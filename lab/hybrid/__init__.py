"""The prototype of the hybrid discovery: its rules, simulated and over UDP (see ../README.md).

Its tables of messages belong to the package: `discostorm.protocols.hybrid`.
"""
