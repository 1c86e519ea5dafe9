"""Expectations of a stream of numbers, such as a robot's joints: its rate, and how it follows commands.

They take the delays of the grading machine into account, if the scenario measured them (`arena.lateness()`).
Anything that an overloaded machine may have caused is never a Failure: the recording is repeated instead.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from statistics import median

from course.api import Failure, Feedback, Location, Recording, Spoilt, Stream, TooBusy, ask_for, replace
from lib.following import Answer, alike, answers, same, sketch
from lib.pacing import Pacing, pacing_of
from lib.waves import Wave, fit_wave

_TOO_LOADED = "This machine was too busy to measure milliseconds."
# Fractions of the amplitude: how far a sine may be from its own fit, and from the commanded one.
_ROUGH, _AMPLITUDE = 0.15, 0.05
# An even pace is one whose jitter is below this fraction of its period.
_EVEN = 0.1
_FEW = 3


def expect_rate(
    recording: Recording,
    stream: Stream,
    rate: float,
    *,
    tolerance: float = 0.05,
    advice: str,
    where: tuple[Location, ...] = (),
) -> Pacing:
    """Expect `rate` messages per second on average, within the fraction `tolerance`; return its pacing.

    If the machine delayed programs, the median interval is enough: messages may be late or missing.
    """
    ask_for(stream.name, (1 - tolerance) / rate, (1 + tolerance) / rate)
    pacing = pacing_of(stream.times)
    if pacing is None:
        raise Failure(
            Feedback(
                summary=f"Only {len(stream)} messages arrived on `{stream.name}`, too few to measure a rate.",
                expected=f"{rate:.0f} per second",
                seen=f"{len(stream)} messages in total",
                where=where,
                advice=advice,
            )
        )
    if abs(pacing.rate / rate - 1) <= tolerance:
        return pacing
    if pacing.rate < rate and recording.is_overloaded(stream.times[0], stream.times[-1]):
        if abs(pacing.period * rate - 1) <= tolerance:
            return pacing
        if pacing.jitter > _EVEN * pacing.period:
            raise TooBusy(_TOO_LOADED)
    if stream.lost:
        raise Spoilt(f"Messages on `{stream.name}` were lost on their way to the grader.")
    raise Failure(
        Feedback(
            summary=f"`{stream.name}` has {pacing.rate:.0f} messages per second, not {rate:.0f}.",
            expected=f"{rate:.0f} per second, one every {1000 / rate:.3g} ms",
            seen=f"{pacing.rate:.1f} per second, one every {pacing.period * 1000:.3g} ms (median)",
            where=where,
            advice=advice,
            details=pacing.words,
        )
    )


def expect_width(stream: Stream, joints: int, *, advice: str, where: tuple[Location, ...] = ()) -> None:
    """Expect at least one row, and this many numbers in every row."""
    if stream.widths == (joints,):
        return
    seen = " or ".join(map(str, stream.widths[:_FEW])) or "no messages"
    raise Failure(
        Feedback(
            summary=f"The messages on `{stream.name}` should have {joints} joints.",
            expected=f"{joints} numbers in each",
            seen=seen,
            where=where,
            advice=advice,
        )
    )


def expect_values(
    name: str, seen: Sequence[float], wanted: Sequence[float], *, what: str, advice: str,
    where: tuple[Location, ...] = (),
) -> None:  # fmt: skip
    """Expect these numbers, within a millionth. The feedback recognizes degrees instead of radians."""
    if _near(seen, wanted):
        return
    turned = any(wanted) and _near(seen, [math.degrees(value) for value in wanted])
    raise Failure(
        Feedback(
            summary=f"The {what} on `{name}` are in degrees, but they must be in radians."
            if turned
            else f"The {what} on `{name}` are wrong.",
            expected=told(wanted),
            seen=told(seen),
            where=where,
            advice="Convert degrees to radians, for example with `deg2rad`." if turned else advice,
        )
    )


def _near(seen: Sequence[float], wanted: Sequence[float]) -> bool:
    return same(tuple(seen), tuple(wanted))


def expect_steps(
    recording: Recording, commands: Stream, stream: Stream, *, within: float, advice: str,
    where: tuple[Location, ...] = (),
) -> float:  # fmt: skip
    """Expect each commanded row in the stream, with a median delay up to `within` s; return the delay."""
    found = answers(commands, stream)
    came = sorted(one.latency for one in found if one.latency is not None)
    lost = [one for one in found if one.latency is None]
    busy = bool(found) and recording.is_overloaded(found[0].sent, found[-1].sent)
    if 2 * len(lost) > len(found) or (lost and not busy):
        one = lost[0]
        raise Failure(
            Feedback(
                summary=f"A commanded target never appears on `{stream.name}`.",
                expected=told(one.target),
                seen=told(one.last) if one.last is not None else "no message after the target",
                where=where,
                advice=advice,
                details=_drawn(commands, stream, _farthest(one)),
            )
        )
    latency = median(came)
    # The fastest quarter shows what the program needs when nothing holds it up.
    if latency <= within or (busy and came[len(came) // 4] <= within):
        return latency
    if busy:
        raise TooBusy(_TOO_LOADED)
    raise Failure(
        Feedback(
            summary=f"A target takes {latency * 1000:.0f} ms to appear on `{stream.name}`.",
            expected=f"at most {within * 1000:.0f} ms (median)",
            seen=f"{latency * 1000:.1f} ms (from {came[0] * 1000:.1f} to {came[-1] * 1000:.1f} ms)",
            where=where,
            advice=advice,
        )
    )


def _farthest(one: Answer) -> int:
    """The joint with the largest error."""
    off = [abs(a - b) for a, b in zip(one.target, one.last or (), strict=False)]
    return off.index(max(off)) if off else 0


def _drawn(commands: Stream, stream: Stream, joint: int) -> tuple[str, ...]:
    """From the first to the last command."""
    return sketch(commands, stream.between(commands.times[0], commands.times[-1]), joint)


def expect_follows_wave(
    recording: Recording, commands: Stream, stream: Stream, frequency: float, *, within: float, advice: str,
    where: tuple[Location, ...] = (),
) -> None:  # fmt: skip
    """Expect the commanded sine (Hz) in each joint: its amplitude within 5 %, and at most `within` s late."""
    for joint in range(len(commands.rows[0])):
        asked = fit_wave(commands.times, commands.column(joint), frequency)
        made = fit_wave(stream.times, stream.column(joint), frequency)
        if asked is None or made is None:
            raise Failure(
                Feedback(
                    summary=f"Too few messages arrived on `{stream.name}` while the check sent targets.",
                    expected="a steady stream of messages",
                    seen=f"{len(stream)} messages",
                    advice=advice,
                )
            )
        try:
            _expect_wave(recording, stream, joint, asked, made, within, advice, where)
        except Failure as failure:
            drawn = _drawn(commands, stream, joint)
            raise Failure(replace(failure.feedback, details=drawn)) from None


def _expect_wave(
    recording: Recording, stream: Stream, joint: int, asked: Wave, made: Wave, within: float, advice: str,
    where: tuple[Location, ...],
) -> None:  # fmt: skip
    behind = made.behind(asked)
    same = abs(made.amplitude - asked.amplitude) <= _AMPLITUDE * asked.amplitude
    smooth = made.rest <= _ROUGH * asked.amplitude
    if same and smooth and abs(behind) <= within:
        return
    if recording.is_overloaded(stream.times[0], stream.times[-1]) and made.amplitude > asked.amplitude / 2:
        raise TooBusy(_TOO_LOADED)
    if not same:
        how = f"swings by {made.amplitude:.3g} rad instead of the commanded {asked.amplitude:.3g} rad."
    elif not smooth:
        how = "moves, but does not follow the commanded sine."
    else:
        how = f"is {behind * 1000:.0f} ms behind the commanded sine."
    raise Failure(
        Feedback(
            summary=f"Joint {joint + 1} {how}",
            expected=f"an amplitude of {asked.amplitude:.3g} rad, at most {within * 1000:.0f} ms behind",
            seen=f"{made.amplitude:.3g} rad, {behind * 1000:.0f} ms behind, {made.rest:.2g} rad off a sine",
            where=where,
            advice=advice,
        )
    )


def expect_alike(stream: Stream, *, advice: str, where: tuple[Location, ...] = ()) -> None:
    """Expect the same motion from all joints."""
    if alike(stream):
        return
    spans = [max(stream.column(joint)) - min(stream.column(joint)) for joint in range(stream.widths[0])]
    least = spans.index(min(spans))
    raise Failure(
        Feedback(
            summary="The joints do not all move the same way.",
            expected="the same swing for each joint",
            seen=f"joint {least + 1} moves by {spans[least]:.3g} rad, another by {max(spans):.3g} rad",
            where=where,
            advice=advice,
        )
    )


def told(row: Sequence[float]) -> str:
    """Numbers for people: `[0, 1.57, -3.14]`."""
    return f"[{', '.join(f'{value:.4g}' for value in row)}]"
