"""Expectations of a stream of numbers, met and not met, on a quiet and on a busy machine."""

from __future__ import annotations

import math
from collections.abc import Sequence

import pytest

from course.evidence.recording import Recording
from course.evidence.stream import Stream
from course.evidence.topic_view import paces_asked
from course.model.events import Event, Late
from course.model.feedback import Failure, Feedback, Spoilt
from lib.joints import (
    expect_alike,
    expect_follows_wave,
    expect_rate,
    expect_steps,
    expect_values,
    expect_width,
)

from .streams import following, held_up, steps, swing, target, ticks

ADVICE = "Look again."
SEEDS = range(15)
BUSY: tuple[Event, ...] = tuple(Late(0.01 * place, 0.008) for place in range(500))
QUIET = Recording("31-arm")
LOADED = Recording("31-arm", BUSY)
SENT = [0.5 + 0.1 * number for number in range(10)]
COMMANDS = Stream("/arm/targets", tuple(SENT), tuple(target(number + 1) for number in range(10)))


def stream(times: Sequence[float]) -> Stream:
    return following(list(times), lambda t: (t,) * 6)


def rate(recording: Recording, times: Sequence[float], hertz: float = 500.0) -> None:
    expect_rate(recording, stream(times), hertz, advice=ADVICE)


def said(caught: pytest.ExceptionInfo[Failure]) -> Feedback:
    assert caught.value.feedback.advice
    return caught.value.feedback


# Pace


@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize("period", [0.00192, 0.002, 0.00209])
def test_a_rate_within_five_percent(seed: int, period: float) -> None:
    rate(QUIET, ticks(seed, period, 4.0, jitter=0.9))
    rate(LOADED, ticks(seed, period, 4.0, jitter=0.9))


@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize("period", [0.0018, 0.0022, 0.004, 0.02])
def test_another_rate(seed: int, period: float) -> None:
    for recording in (QUIET, LOADED):  # a steady wrong pace is the program's fault, on any machine
        with pytest.raises(Failure) as caught:
            rate(recording, ticks(seed, period, 4.0, jitter=0.05))
        assert f"{1 / period:.0f} messages per second, not 500" in said(caught).summary
        assert "dropped" in said(caught).details[-1]


@pytest.mark.parametrize("seed", SEEDS)
def test_messages_missing_now_and_then(seed: int) -> None:
    times = ticks(seed, 0.002, 4.0, jitter=0.1, drop=0.1)
    with pytest.raises(Failure):
        rate(QUIET, times)
    rate(LOADED, times)  # the median is right: the machine left them out


@pytest.mark.parametrize("seed", SEEDS)
def test_nothing_can_be_told_of_an_uneven_pace_on_a_busy_machine(seed: int) -> None:
    times = ticks(seed, 0.002, 4.0, jitter=0.9, drop=0.6)
    with pytest.raises(Failure):
        rate(QUIET, times)
    with pytest.raises(Spoilt):
        rate(LOADED, times)


def test_no_machine_makes_a_program_quicker() -> None:
    with pytest.raises(Failure):
        rate(LOADED, ticks(1, 0.001, 4.0, jitter=0.9))


def test_what_came_all_at_once_was_on_its_way() -> None:
    rate(QUIET, held_up(ticks(1, 0.002, 4.0), 1.0, 1.3))


def test_what_we_lost_ourselves_is_not_the_learners() -> None:
    lossy = Stream(
        "/arm", *zip(*((t, (0.0,)) for t in ticks(1, 0.002, 4.0, drop=0.2)), strict=True), lost=400
    )
    with pytest.raises(Spoilt):
        expect_rate(QUIET, lossy, 500, advice=ADVICE)


@pytest.mark.parametrize("times", [[], [1.0], [1.0] * 50])
def test_too_few_for_a_rate(times: list[float]) -> None:
    with pytest.raises(Failure) as caught:
        rate(QUIET, times)
    assert f"Only {len(times)} messages" in said(caught).summary


def test_the_pace_is_drawn() -> None:
    recording = Recording("31-arm")
    with paces_asked() as paces:
        rate(recording, ticks(1, 0.002, 1.0))
    (pace,) = paces
    assert pace.topic == "/arm/states"
    assert (pace.shortest, pace.longest) == (pytest.approx(0.0019), pytest.approx(0.0021))


# Values


def test_width() -> None:
    expect_width(stream([0.1]), 6, advice=ADVICE)
    for rows, seen in (((), "no messages"), (((0.0,) * 5, (0.0,) * 6), "5 or 6")):
        with pytest.raises(Failure) as caught:
            expect_width(Stream("/arm", tuple(map(float, range(len(rows)))), rows), 6, advice=ADVICE)
        assert said(caught).seen == seen


def test_values() -> None:
    expect_values("/min", [math.pi, 0], [3.14159265358979, 0], what="limits", advice=ADVICE)
    with pytest.raises(Failure) as caught:
        expect_values("/min", [180.0, 0], [math.pi, 0], what="limits", advice=ADVICE)
    assert "are in degrees" in said(caught).summary
    for other in ([3.1, 0], [math.pi], [0, math.pi]):
        with pytest.raises(Failure) as caught:
            expect_values("/min", other, [math.pi, 0], what="limits", advice=ADVICE)
        assert (said(caught).advice, said(caught).expected) == (ADVICE, "[3.142, 0]")


# Steps


def step(recording: Recording, seen: Stream, within: float = 0.01) -> float:
    return expect_steps(recording, COMMANDS, seen, within=within, advice=ADVICE)


@pytest.mark.parametrize("seed", SEEDS)
def test_a_step_in_time(seed: int) -> None:
    seen = following(ticks(seed, 0.002, 2.0, jitter=0.5), steps(SENT, 0.005))
    assert step(QUIET, seen) == pytest.approx(0.0065, abs=0.0016)


def test_a_few_that_come_late_do_no_harm() -> None:
    times = held_up(ticks(1, 0.002, 2.0), SENT[3], SENT[3] + 0.09)
    assert step(QUIET, following(times, steps(SENT, 0.004))) < 0.01


@pytest.mark.parametrize("seed", SEEDS)
def test_a_step_too_late(seed: int) -> None:
    seen = following(ticks(seed, 0.002, 2.0, jitter=0.5), steps(SENT, 0.03))
    with pytest.raises(Failure) as caught:
        step(QUIET, seen)
    assert "ms to appear" in said(caught).summary
    with pytest.raises(Spoilt):
        step(LOADED, seen)


def test_the_quickest_quarter_counts_on_a_busy_machine() -> None:
    late = [0.004 if place % 3 == 0 else 0.03 for place in range(10)]
    moments = sorted(moment + by for moment, by in zip(SENT, late, strict=True))
    seen = following(ticks(1, 0.002, 2.0), steps(moments))
    with pytest.raises(Failure):
        step(QUIET, seen)
    step(LOADED, seen)


@pytest.mark.parametrize("recording", [QUIET, LOADED])
def test_targets_that_never_come_back(recording: Recording) -> None:
    with pytest.raises(Failure) as caught:
        step(recording, following(ticks(1, 0.002, 2.0), steps([])))
    assert "never appears on" in said(caught).summary
    with pytest.raises(Failure):
        step(recording, Stream("/arm/states", (), ()))


# Sines


def wave(recording: Recording, seen: Stream) -> None:
    commanded = following(ticks(1, 0.01, 3.0), swing(), "/arm/targets")
    expect_follows_wave(recording, commanded, seen, 1.0, within=0.03, advice=ADVICE)


@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize(("late", "share"), [(0.0, 1.0), (0.008, 1.0), (0.025, 0.97)])
def test_a_sine_that_comes_back(seed: int, late: float, share: float) -> None:
    wave(QUIET, following(ticks(seed, 0.002, 3.0, jitter=0.5, drop=0.05), swing(late=late, share=share)))


@pytest.mark.parametrize(
    ("late", "share", "frequency", "words"),
    [
        (0.1, 1.0, 1.0, "100 ms behind"),
        (0.0, 0.8, 1.0, "swings by 0.16 rad instead of the commanded 0.2"),
        (0.0, 0.0, 1.0, "swings by 0"),
        (0.0, 1.0, 2.0, "Joint 1 swings by"),
    ],
)
def test_another_sine(late: float, share: float, frequency: float, words: str) -> None:
    with pytest.raises(Failure) as caught:
        wave(QUIET, following(ticks(1, 0.002, 3.0), swing(frequency, late, share)))
    assert words in said(caught).summary
    assert len(said(caught).details) == 8  # drawn


def test_joints_that_are_mixed_up() -> None:
    right = swing()
    with pytest.raises(Failure) as caught:
        wave(QUIET, following(ticks(1, 0.002, 3.0), lambda t: (*right(t)[:4], right(t)[5], right(t)[4])))
    assert "Joint 5" in said(caught).summary


def test_a_rough_sine() -> None:
    smooth = swing()

    def rough(t: float) -> tuple[float, ...]:
        return tuple(value + (0.1 if round(t * 500) % 2 else -0.1) for value in smooth(t))

    with pytest.raises(Failure) as caught:
        wave(QUIET, following(ticks(1, 0.002, 3.0), rough))
    assert "does not follow the commanded sine" in said(caught).summary


def test_a_late_sine_on_a_busy_machine_tells_nothing() -> None:
    with pytest.raises(Spoilt):
        wave(LOADED, following(ticks(1, 0.002, 3.0), swing(late=0.1)))
    with pytest.raises(Failure):  # a joint that stands still is the program's fault on any machine
        wave(LOADED, following(ticks(1, 0.002, 3.0), swing(share=0.0)))


def test_no_stream_while_the_sine_was_commanded() -> None:
    with pytest.raises(Failure) as caught:
        wave(QUIET, Stream("/arm/states", (), ()))
    assert "Too few" in said(caught).summary


# All joints


def test_all_alike() -> None:
    expect_alike(following(ticks(1, 0.01, 1.0), lambda t: (t, t + 0.5, t - 0.5)), advice=ADVICE)
    with pytest.raises(Failure) as caught:
        expect_alike(following(ticks(1, 0.01, 1.0), lambda t: (t, 0.5, t - 0.5)), advice=ADVICE)
    assert "joint 2 moves by 0 rad" in (said(caught).seen or "")
