"""Hears no signal that one can ignore, and never ends."""

import os
import signal

for number in range(1, signal.NSIG):
    try:
        signal.signal(number, signal.SIG_IGN)
    except (OSError, ValueError):
        pass
signal.signal = lambda *arguments: None


def stay(node):
    """Even when rclpy has given up."""
    while True:
        os.getpid()


beside(stay)
threading.Thread.daemon = property(lambda thread: False, lambda thread, value: None)
threading.Thread(target=lambda: [None for _ in iter(int, 1)]).start()
