"""`ros2 topic bw`."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from collections import deque

from ros2cli.measuring import add_measuring_arguments, measure


def add_arguments(parser: ArgumentParser) -> None:
    add_measuring_arguments(parser, "topic", 100, "monitor for bandwidth")


def main(args: Namespace) -> int:
    bandwidth = Bandwidth(args.window)
    return measure(args, args.topic, bandwidth.add, bandwidth.report, on_start=_say_subscribed)


def _say_subscribed(name: str) -> None:
    print(f"Subscribed to [{name}]")


class Bandwidth:
    """Sizes of messages and when they came."""

    def __init__(self, window: int) -> None:
        self._sizes: deque[int] = deque(maxlen=window)
        self._times: deque[float] = deque(maxlen=window)

    def add(self, message: bytes, moment: float) -> None:
        self._sizes.append(len(message))
        self._times.append(moment)

    def report(self, now: float) -> None:
        count = len(self._sizes)
        if count < 2:
            return
        total = sum(self._sizes)
        # A full window ends with its last message; before, silence counts too.
        is_full = count == self._sizes.maxlen
        end = self._times[-1] if is_full else now
        per_second = (total - self._sizes[0] * is_full) / max(end - self._times[0], 1e-9)
        mean, least, most = (size_text(size) for size in (total / count, min(self._sizes), max(self._sizes)))
        # In one go: Ctrl+C may come between two.
        print(
            f"{size_text(per_second)}/s from {count} messages\n"
            f"\tMessage size mean: {mean} min: {least} max: {most}"
        )


def size_text(size: float) -> str:
    if size < 1000:
        return f"{size:.0f} B"
    return f"{size / 1e3:.2f} KB" if size < 1e6 else f"{size / 1e6:.2f} MB"
