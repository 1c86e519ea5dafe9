"""What is expected of a stream of numbers, such as a robot's joints: its pace, and what it follows.

How late the grading machine itself was counts where the scenario noted it (`arena.lateness()`). What a
machine with too much to do may have caused is never a Failure: the recording is then made once more.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from statistics import median

from course.evidence.following import Answer, alike, answers, same
from course.evidence.pacing import Pacing, pacing_of
from course.evidence.recording import Recording
from course.evidence.stream import Row, Stream
from course.evidence.waves import Wave, fit_wave
from course.feedback import Failure, Feedback, Location, Pace, Spoilt
from course.grading.explain.sketch import sketch

_TOO_LOADED = "this machine had too much to do to measure milliseconds."
# Of the amplitude: how far a sine may be off its own fit, and off what it should be.
_ROUGH, _AMPLITUDE = 0.15, 0.05
# An even pace is one whose jitter is below this fraction of its period.
_EVEN = 0.1


def expect_rate(
    recording: Recording,
    stream: Stream,
    rate: float,
    *,
    tolerance: float = 0.05,
    advice: str,
    where: tuple[Location, ...] = (),
) -> Pacing:
    """It came `rate` times per second on average, within the fraction `tolerance`. Its pacing is returned.

    On a machine that held programs up, every other message may be late, or missing, if the median of the
    intervals is right.
    """
    recording.paces.append(Pace(stream.name, (1 - tolerance) / rate, (1 + tolerance) / rate))
    pacing = pacing_of(stream.times)
    if pacing is None:
        raise Failure(
            Feedback(
                summary=f"Only {len(stream)} messages came on `{stream.name}`, too few to tell how often.",
                expected=f"{rate:.0f} per second",
                seen=f"{len(stream)} in all",
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
            raise Spoilt(_TOO_LOADED)
    if stream.lost:
        raise Spoilt("messages were lost on the grader's side.")
    raise Failure(
        Feedback(
            summary=f"On `{stream.name}` {pacing.rate:.0f} messages per second come, not {rate:.0f}.",
            expected=f"{rate:.0f} per second, one every {1000 / rate:.3g} ms",
            seen=f"{pacing.rate:.1f} per second, one every {pacing.period * 1000:.3g} ms by the median",
            where=where,
            advice=advice,
            details=pacing.words,
        )
    )


def expect_width(stream: Stream, joints: int, *, advice: str, where: tuple[Location, ...] = ()) -> None:
    """Every row has so many numbers, and there is a row."""
    if stream.widths == (joints,):
        return
    seen = " or ".join(map(str, stream.widths)) or "no message at all"
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
    """These are the wanted numbers, within a millionth; names degrees in place of rad."""
    if _near(seen, wanted):
        return
    turned = any(wanted) and _near(seen, [math.degrees(value) for value in wanted])
    raise Failure(
        Feedback(
            summary=f"The {what} on `{name}` are in degrees; they should be in rad."
            if turned
            else f"The {what} on `{name}` are other ones.",
            expected=told(wanted),
            seen=told(seen),
            where=where,
            advice="`deg2rad` turns degrees into rad." if turned else advice,
        )
    )


def _near(seen: Sequence[float], wanted: Sequence[float]) -> bool:
    return same(tuple(seen), tuple(wanted))


def expect_steps(
    recording: Recording, commands: Stream, stream: Stream, *, within: float, advice: str,
    where: tuple[Location, ...] = (),
) -> float:  # fmt: skip
    """Each commanded row comes back in the stream, after `within` s by the median, which is returned."""
    found = answers(commands, stream)
    came = sorted(one.latency for one in found if one.latency is not None)
    lost = [one for one in found if one.latency is None]
    busy = bool(found) and recording.is_overloaded(found[0].sent, found[-1].sent)
    if 2 * len(lost) > len(found) or (lost and not busy):
        one = lost[0]
        raise Failure(
            Feedback(
                summary=f"A target that was commanded never comes back on `{stream.name}`.",
                expected=told(one.target),
                seen=told(one.last) if one.last is not None else "no message after it",
                where=where,
                advice=advice,
                details=_drawn(commands, stream, _farthest(one)),
            )
        )
    latency = median(came)
    # The quickest quarter is what the program needs when it is let go on.
    if latency <= within or (busy and came[len(came) // 4] <= within):
        return latency
    if busy:
        raise Spoilt(_TOO_LOADED)
    raise Failure(
        Feedback(
            summary=f"A target needs {latency * 1000:.0f} ms until it is seen on `{stream.name}`.",
            expected=f"at most {within * 1000:.0f} ms, by the median",
            seen=f"{latency * 1000:.1f} ms; from {came[0] * 1000:.1f} to {came[-1] * 1000:.1f} ms",
            where=where,
            advice=advice,
        )
    )


def _farthest(one: Answer) -> int:
    """The joint that is farthest from where it should be."""
    off = [abs(a - b) for a, b in zip(one.target, one.last or (), strict=False)]
    return off.index(max(off)) if off else 0


def _drawn(commands: Stream, stream: Stream, joint: int) -> tuple[str, ...]:
    """From the first to the last command."""
    return sketch(commands, stream.between(commands.times[0], commands.times[-1]), joint)


def expect_follows_wave(
    recording: Recording, commands: Stream, stream: Stream, frequency: float, *, within: float, advice: str,
    where: tuple[Location, ...] = (),
) -> None:  # fmt: skip
    """Each joint makes the commanded sine (Hz), its amplitude within 5 %, and `within` s behind at most."""
    for joint in range(len(commands.rows[0])):
        asked = fit_wave(commands.times, commands.column(joint), frequency)
        made = fit_wave(stream.times, stream.column(joint), frequency)
        if asked is None or made is None:
            raise Failure(
                Feedback(
                    summary=f"Too few messages came on `{stream.name}` while targets were sent.",
                    expected="a stream that goes on",
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
        raise Spoilt(_TOO_LOADED)
    if not same:
        how = f"swings by {made.amplitude:.3g} rad; {asked.amplitude:.3g} were commanded."
    elif not smooth:
        how = "moves, but not along the commanded sine."
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
    """All joints make the same moves."""
    if alike(stream):
        return
    spans = [max(stream.column(joint)) - min(stream.column(joint)) for joint in range(stream.widths[0])]
    least = spans.index(min(spans))
    raise Failure(
        Feedback(
            summary="The joints do not all make the same moves.",
            expected="the same swing for each joint",
            seen=f"joint {least + 1} moves by {spans[least]:.3g} rad, another by {max(spans):.3g} rad",
            where=where,
            advice=advice,
        )
    )


def told(row: Sequence[float]) -> str:
    """Numbers for people: `[0, 1.57, -3.14]`."""
    return f"[{', '.join(f'{value:.4g}' for value in row)}]"


def first_row(stream: Stream) -> Row:
    """The first row; empty where nothing came."""
    return stream.rows[0] if stream.rows else ()
