"""Starts threads for as long as there are any."""

import time


def wait():
    time.sleep(600)


while True:
    try:
        aside(wait)
    except RuntimeError:
        time.sleep(0.01)
