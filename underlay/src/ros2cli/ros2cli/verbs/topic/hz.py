"""`ros2 topic hz`."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from collections.abc import Callable
from typing import Any

from ros2cli.measuring import add_measuring_arguments, measure
from ros2cli.statistics_window import Window


def add_arguments(parser: ArgumentParser) -> None:
    add_measuring_arguments(parser, "topic_name", 10000, "listen to for calculating the rate")
    parser.add_argument(
        "--filter", dest="filter_expr",
        help="only measure messages matching the specified Python expression, which calls the message m",
    )  # fmt: skip
    parser.add_argument(
        "--wall-time", action="store_true",
        help="measure by the wall clock even with --use-sim-time",
    )  # fmt: skip


def main(args: Namespace) -> int:
    from ros2cli.echo_form import wanted

    rate = Rate(args.window, wanted(args.filter_expr))
    return measure(args, args.topic_name, rate.add, rate.report, raw=args.filter_expr is None)


class Rate:
    """Counts messages by the times at which they reached this machine's middleware."""

    def __init__(self, window: int, wanted: Callable[[Any], bool]) -> None:
        self._intervals = Window(window)
        self._wanted = wanted
        self._last: float | None = None
        self._is_new = False

    def add(self, message: Any, moment: float) -> None:
        if not self._wanted(message):
            return
        if self._last is not None:
            self._intervals.add(moment - self._last)
            self._is_new = True
        self._last = moment

    def report(self, now: float) -> None:
        if not self._is_new:
            return
        self._is_new = False
        found = self._intervals.summary()
        rate = 1 / found.mean if found.mean > 0 else float("inf")
        print(f"average rate: {rate:.3f}")
        print(
            f"\tmin: {found.least:.3f}s max: {found.most:.3f}s std dev: {found.deviation:.5f}s "
            f"window: {found.count + 1}"
        )
