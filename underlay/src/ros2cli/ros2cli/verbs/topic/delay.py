"""`ros2 topic delay`."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from typing import Any

from ros2cli.errors import CommandError
from ros2cli.measuring import add_measuring_arguments, measure
from ros2cli.statistics_window import Window


def add_arguments(parser: ArgumentParser) -> None:
    add_measuring_arguments(parser, "topic", 10000, "calculate the delay")


def main(args: Namespace) -> int:
    delay = Delay(args.window)
    return measure(args, args.topic, delay.add, delay.report, raw=False)


class Delay:
    """How long after its header's time a message came."""

    def __init__(self, window: int) -> None:
        self._delays = Window(window)
        self._is_new = False

    def add(self, message: Any, moment: float) -> None:
        if not hasattr(message, "header"):
            raise CommandError("msg does not have header")
        stamp = message.header.stamp
        self._delays.add(moment - stamp.sec - stamp.nanosec / 1e9)
        self._is_new = True

    def report(self, now: float) -> None:
        if not self._is_new:
            return
        self._is_new = False
        found = self._delays.summary()
        print(f"average delay: {found.mean:.3f}")
        print(
            f"\tmin: {found.least:.3f}s max: {found.most:.3f}s std dev: {found.deviation:.5f}s "
            f"window: {found.count}"
        )
