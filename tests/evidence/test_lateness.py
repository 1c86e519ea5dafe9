"""Whether the machine had too much to do."""

from __future__ import annotations

import pytest

from course.evidence.recording import is_overloaded
from course.model.events import Late, Watched

BEGIN, END = Watched(1.0, True), Watched(5.0, False)


def notes(number: int, seconds: float) -> list[Late]:
    return [Late(1.0 + 4.0 * place / number, seconds) for place in range(number)]


@pytest.mark.parametrize(
    ("late", "overloaded"),
    [
        ([], False),
        (notes(2, 0.0099), False),
        (notes(2, 0.0101), True),  # a two-hundredth of the time
        (notes(9, 0.0022), False),
        (notes(400, 0.003), True),
        (notes(1, 0.3), True),
    ],
)
def test_overloaded(late: list[Late], overloaded: bool) -> None:
    assert is_overloaded([BEGIN, *late, END], 1.0, 5.0) is overloaded


def test_only_then() -> None:
    events = [BEGIN, *notes(100, 0.02), END]
    assert not is_overloaded(events, 5.1, 9.0)
    assert is_overloaded(events, 2.0, 2.5)


@pytest.mark.parametrize(("waited", "overloaded"), [(0.19, False), (0.21, True)])  # of four seconds
def test_a_program_that_had_to_wait(waited: float, overloaded: bool) -> None:
    events = [BEGIN, Watched(5.0, False, waited), Watched(6.0, True), Watched(8.0, False)]
    assert is_overloaded(events, 1.5, 4.5) is overloaded
    assert is_overloaded(events, 4.0, 7.0) is overloaded
    assert not is_overloaded(events, 5.5, 9.0)
