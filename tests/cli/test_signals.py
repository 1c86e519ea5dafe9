"""A signal ends a command, even if its exception is lost."""

from __future__ import annotations

import signal
import sys
from collections.abc import Callable, Iterator

import pytest

from course.cli.signals import ended_cleanly

ENDS = [(signal.SIGINT, KeyboardInterrupt), (signal.SIGTERM, SystemExit), (signal.SIGHUP, SystemExit)]


class Dying:
    """Receives a signal while it is destroyed."""

    def __init__(self, number: signal.Signals) -> None:
        self._number = number

    def __del__(self) -> None:
        signal.raise_signal(self._number)


@pytest.fixture
def lost(monkeypatch: pytest.MonkeyPatch) -> list[object]:
    """What Python would print and forget."""
    found: list[object] = []
    monkeypatch.setattr(sys, "unraisablehook", lambda caught: found.append(caught.exc_type))
    return found


@pytest.fixture(autouse=True)
def usual() -> Iterator[None]:
    """The tests may run where Ctrl+C is ignored, or handled by others."""
    numbers = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)
    before = {number: signal.getsignal(number) for number in numbers}
    signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    for number, handler in before.items():
        signal.signal(number, handler)


@pytest.mark.parametrize(("number", "raised"), ENDS)
def test_a_signal_ends_it(number: signal.Signals, raised: type[BaseException]) -> None:
    before = signal.getsignal(number)
    with pytest.raises(raised) as caught, ended_cleanly():
        signal.raise_signal(number)
    assert getattr(caught.value, "code", 128 + number) == 128 + number
    assert signal.getsignal(number) == before


@pytest.mark.parametrize(("number", "raised"), ENDS)
def test_what_was_lost_is_raised_again(
    number: signal.Signals, raised: type[BaseException], lost: list[object]
) -> None:
    def work(again: Callable[[], None]) -> None:
        again()
        Dying(number)
        assert lost == [raised]
        again()
        pytest.fail("it goes on")

    with pytest.raises(raised), ended_cleanly() as again:
        work(again)


def test_who_ignores_ctrl_c_goes_on_doing_so() -> None:
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    with ended_cleanly() as again:
        signal.raise_signal(signal.SIGINT)
        again()
    assert signal.getsignal(signal.SIGINT) is signal.SIG_IGN
