#!/usr/bin/python3
"""Waits on an event that Ctrl+C sets."""
import signal
import threading
from types import FrameType
from typing import NoReturn

stop = threading.Event()


def on_interrupt(number: int, frame: "FrameType | None") -> None:
    """Let the loop come to its end."""
    stop.set()


def main() -> "NoReturn | None":
    """Say it, wait, and see whether it is time to stop."""
    signal.signal(signal.SIGINT, on_interrupt)
    while not stop.is_set():
        print("Howdy!", flush=True)
        stop.wait(timeout=1 / 2)
    return None


if __name__ == '__main__':
    main()
