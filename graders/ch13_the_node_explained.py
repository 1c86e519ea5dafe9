"""Graders of chapter 13: three nodes to repair, and questions about the parts of a node."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from itertools import pairwise
from statistics import median

from course.api import (
    Arena,
    Failure,
    Feedback,
    Grader,
    LogLine,
    Process,
    Recording,
    about,
    cause_of_silence,
    expect_clean_interrupt,
    expect_logged,
    expect_node,
    expect_period,
    expect_running,
    listed,
    text_places,
    timer_places,
)

PACKAGE = "python_package_with_broken_nodes"
HEARTBEAT, COUNTDOWN, SCANNER = "heartbeat", "countdown", "scanner"
NODES = (HEARTBEAT, COUNTDOWN, SCANNER)
BEAT, CLEAR, LASER = "Still alive.", "The way is clear.", "The laser is off."
COUNTED = ("3", "2", "1", "Lift-off!")
PERIOD = 0.5
ENOUGH = 5

repair = Grader("13-repair")


@repair.scenario
def all_three_at_once(arena: Arena) -> None:
    """Record five lines, which make four intervals; the countdown logs its four lines meanwhile."""
    asked = arena.ros.parameters(f"/{COUNTDOWN}")
    programs = {node: arena.run(PACKAGE, program(node)) for node in NODES}
    started = [found for found in programs.values() if found]
    arena.until(lambda: len(arena.ros.graph.nodes) >= sum(p.running for p in started), timeout=15)
    for node, text, count in ((HEARTBEAT, BEAT, ENOUGH), (SCANNER, CLEAR, ENOUGH), (COUNTDOWN, "L", 1)):
        # The pace counts from the first line on, which comes late on a busy machine.
        if arena.until(partial(heard, arena, programs[node], text, 1), timeout=6):
            arena.until(partial(heard, arena, programs[node], text, count), timeout=4)
    countdown = programs[COUNTDOWN]
    # Another word would come a period after the last one.
    arena.until(partial(heard, arena, countdown, "L", 2), timeout=2 * PERIOD)
    # A node that still answers is running. One that ends after its last word may take a while.
    if countdown and asked.available:
        answer = asked.list()
        arena.until(lambda: answer.done or not countdown.running, timeout=6)
    for process in started:
        arena.interrupt(process)


def program(node: str) -> str:
    return f"{node}_node"


def heard(arena: Arena, process: Process | None, text: str, count: int) -> bool:
    """Whether we expect nothing more from this program."""
    return process is None or not process.running or arena.logged(text) >= count


def only(recording: Recording, node: str) -> Recording:
    return about(recording, PACKAGE, program(node), node)


def with_text(recording: Recording, text: str) -> tuple[LogLine, ...]:
    return tuple(line for line in recording.log if text in line.text)


@repair.check("heartbeat_runs", "heartbeat_node starts and keeps running")
def heartbeat_runs(recording: Recording) -> None:
    expect_running(only(recording, HEARTBEAT), program(HEARTBEAT))


@repair.check("countdown_runs", "countdown_node starts and keeps running")
def countdown_runs(recording: Recording) -> None:
    expect_running(only(recording, COUNTDOWN), program(COUNTDOWN))


@repair.check("scanner_runs", "scanner_node starts and keeps running")
def scanner_runs(recording: Recording) -> None:
    expect_running(only(recording, SCANNER), program(SCANNER))


@repair.check("names", "the nodes have the names given in the task", needs=[f"{node}_runs" for node in NODES])
def names(recording: Recording) -> None:
    for node in NODES:
        expect_node(recording, f"/{node}")


@repair.check("heartbeat_beats", f"heartbeat logs `{BEAT}` every 0.5 s", needs=("heartbeat_runs", "names"))
def heartbeat_beats(recording: Recording) -> None:
    expect_every_half_second(only(recording, HEARTBEAT), HEARTBEAT, BEAT)


@repair.check("scanner_reports", f"scanner logs `{CLEAR}` every 0.5 s", needs="names")
def scanner_reports(recording: Recording) -> None:
    expect_every_half_second(only(recording, SCANNER), SCANNER, CLEAR)


def expect_every_half_second(recording: Recording, node: str, text: str) -> None:
    lines = with_text(recording, text)
    expect_logged(recording, program(node), lines, text, text)
    times = tuple(line.t for line in lines)
    expect_period(times, PERIOD, what=f"lines of {node}", program=recording)


@repair.check("countdown_counts", "countdown logs 3, 2, 1, Lift-off!", needs=("countdown_runs", "names"))
def countdown_counts(recording: Recording) -> None:
    recording = only(recording, COUNTDOWN)
    said = tuple(line.text.strip() for line in recording.log)
    if said != COUNTED:
        raise Failure(miscounted(recording, said))
    times = spoken_at(recording)
    gaps = [later - earlier for earlier, later in pairwise(times)]
    if not PERIOD / 2 <= median(gaps) <= 2 * PERIOD or has_two_at_once(gaps):
        raise Failure(
            Feedback(
                summary="The countdown does not log one word every half second.",
                expected=f"one every {PERIOD} s",
                seen=", ".join(f"{gap:.2f} s" for gap in gaps),
                where=timer_places(recording.sources),
                advice="Only the timer should call `count_down`. Leave its period at 0.5 seconds.",
            )
        )


def has_two_at_once(gaps: Sequence[float]) -> bool:
    """Whether two words come at once, which makes the whole countdown a period shorter.

    A word that is only late, close to the next one, does not change the total time.
    """
    return min(gaps) < PERIOD / 10 and sum(gaps) < (len(gaps) - 0.5) * PERIOD


def spoken_at(recording: Recording) -> tuple[float, ...]:
    """When each word appeared: on the terminal, if possible.

    If a node logs before the other nodes have found it, `/rosout` delivers those lines all at once.
    """
    lines = recording.process(program(COUNTDOWN)).lines
    ends = tuple(f": {word}" for word in COUNTED)
    printed = tuple(line.t for line in lines if line.text.strip().endswith(ends))
    return printed if len(printed) == len(COUNTED) else tuple(line.t for line in recording.log)


def miscounted(recording: Recording, said: tuple[str, ...]) -> Feedback:
    if not said:
        expect_logged(recording, program(COUNTDOWN), (), COUNTED[0], COUNTED[-1])  # knows the usual causes
    cause = cause_of_silence(
        recording,
        program(COUNTDOWN),
        look_at="does the rest of the file still do what its docstring says? Only one thing was wrong.",
    )
    return Feedback(
        summary=f"The countdown logs {listed(said[:6])}.",
        expected=", ".join(COUNTED),
        seen=", ".join(said[:6]),
        where=cause.where,
        advice=cause.text,
    )


@repair.check("interrupt", "Ctrl+C ends all three cleanly", needs=[f"{node}_runs" for node in NODES])
def interrupt(recording: Recording) -> None:
    for node in NODES:
        expect_clean_interrupt(only(recording, node), program(node))


@repair.check("laser", f"scanner prints `{LASER}` when it is interrupted", needs="scanner_runs")
def laser(recording: Recording) -> None:
    view = recording.process(program(SCANNER))
    asked = view.interrupted_at
    before = [line.text for line in view.lines if LASER in line.text and asked and line.t < asked]
    after = [line.text for line in view.lines if LASER in line.text and asked and line.t >= asked]
    if after and not before:
        return
    own = only(recording, SCANNER).sources
    places = text_places(own, "switch_off_the_laser()") or text_places(own, LASER)
    advice = "After the `except` block, call `switch_off_the_laser()`."
    if not before:
        try:
            expect_clean_interrupt(only(recording, SCANNER), program(SCANNER))
        except Failure as failure:  # it ends the program too early, so it is the cause
            places, advice = failure.feedback.where, failure.feedback.advice or advice
    raise Failure(
        Feedback(
            summary="The scanner switches off its laser before Ctrl+C."
            if before
            else "After Ctrl+C, the laser stays on, because the program ends before switching it off.",
            expected=f"{LASER} after Ctrl+C, and not before",
            seen=f"{LASER} before Ctrl+C" if before else f"{view.text[-1][:120]}" if view.text else "nothing",
            where=places[:2],
            advice=advice,
        )
    )
