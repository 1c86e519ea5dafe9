"""Writes to its terminal as fast as it can, while the node does what is right."""

import os


def flood():
    while True:
        os.write(1, b"flood " * 10_000 + b"\n")


aside(flood)
