"""Expectations of a node that calls a service again and again, and logs the answers."""

from __future__ import annotations

import ast
from collections.abc import Callable, Mapping
from math import inf

from course.api import (
    Cause,
    Failure,
    Feedback,
    Location,
    OurFault,
    Recording,
    ServiceCall,
    Sources,
    calls,
    cause_of_silence,
    expect_running,
    listed,
    seconds,
    slips,
    trees,
)

# For each field, what the log of an answer must contain.
Texts = Callable[[ServiceCall], Mapping[str, str]]


def expect_waiting(recording: Recording, process: str, until: float) -> None:
    """Expect that the node logged something before the service appeared, at the time `until`."""
    if unasked := slips.uncalled(recording.sources, "wait_for_service"):
        summary = "The node does not wait for the service: it calls a service that may not exist."
        raise Failure(Feedback(summary=summary, where=unasked.where, advice=unasked.text))
    if any(line.t < until for line in recording.log):
        return
    printed = [line.text for line in recording.process(process).lines if line.t < until]
    cause = no_wait(recording.sources) or slips.inverted_wait(recording.sources)
    waiting = calls(recording.sources, "wait_for_service")
    raise Failure(
        Feedback(
            summary="While there is no service, the node says so with `print`, not in its log."
            if printed
            else "While there is no service, the node logs nothing.",
            expected="a log message, such as `Waiting for the service.`",
            seen=printed[0][:120] if printed else "no message",
            where=cause.where if cause else tuple(call.where for call in waiting)[:1],
            advice=cause.text
            if cause
            else "Log it before each `wait_for_service`, in a loop: `while not "
            "self.client.wait_for_service(timeout_sec=1.0):`.",
        )
    )


def expect_calls(
    recording: Recording, process: str, service: str, *, at_least: int, period: float, since: float
) -> None:
    """Expect this many requests to the arena's server, which appeared at the time `since`."""
    requests = recording.service(service).requests
    if len(requests) >= at_least:
        return
    expect_running(recording, process)
    cause = slips.standstill(recording.sources) or cause_of_silence(
        recording,
        process,
        slips.inverted_wait,
        look_at="does the timer's callback reach `call_async` each time, with no `return` and no `if` before "
        "it?",
    )
    once = "once" if len(requests) == 1 else f"{len(requests)} times"
    raise Failure(
        Feedback(
            summary=f"The node calls the service {once}, and then never again."
            if requests
            else "The service exists, but the node does not call it.",
            expected=f"a call every {seconds(period)}",
            seen=f"{len(requests)} calls in {recording.duration - since:.1f} s",
            where=cause.where,
            advice=cause.text,
        )
    )


def expect_answers_logged(
    recording: Recording, process: str, answered: tuple[ServiceCall, ...], texts: Texts
) -> None:
    """Expect all parts of each of these answers in the log."""
    lost = [call for call in answered if _missing(recording, call, texts)]
    if lost:
        expect_running(recording, process)
        raise Failure(_not_logged(recording, process, lost, len(answered), texts))


def expect_patience(
    recording: Recording, process: str, service: str, resumed: float, period: float, texts: Texts
) -> None:
    """Expect new calls after a pause without answers, and the answers from `resumed` on in the log.

    Raises OurFault if the scenario did not get that far.
    """
    expect_running(recording, process)
    if resumed == inf:
        raise OurFault("the scenario did not stop answering")
    later = [call for call in recording.service(service).requests if call.answered and call.asked > resumed]
    if any(not _missing(recording, call, texts) for call in later):
        return
    cause = slips.standstill(recording.sources)
    waited = recording.duration - resumed
    raise Failure(
        Feedback(
            summary="One answer did not arrive, and the node never called again."
            if not later
            else "One answer did not arrive, and the node logs no later one.",
            expected=f"a call every {seconds(period)}, and its answer in the log",
            seen=f"{len(later)} calls in the {waited:.1f} s after the service answered again",
            where=cause.where
            if cause
            else tuple(call.where for call in calls(recording.sources, "done"))[:1],
            advice=cause.text
            if cause
            else (
                "Do not wait forever for one answer. If the future is not `done()` when it is time "
                "for the next call, `cancel()` it, log that, and call again."
            ),
        )
    )


def _missing(recording: Recording, call: ServiceCall, texts: Texts) -> list[str]:
    """The names of the parts that the log does not contain after the call."""
    text = "\n".join(line.text for line in recording.log if line.t >= call.asked)
    return [name for name, part in texts(call).items() if part not in text]


def _not_logged(
    recording: Recording, process: str, lost: list[ServiceCall], every: int, texts: Texts
) -> Feedback:
    wanted, names = texts(lost[0]), _missing(recording, lost[0], texts)
    after = [line.text for line in recording.log if line.t > lost[0].asked]
    terminal = recording.process(process).text
    printed = [] if after else [text for text in terminal if wanted[names[0]] in text]
    cause = None if printed or len(names) < len(wanted) else _unanswered(recording.sources)
    shown = printed or after
    made = calls(recording.sources, "print" if printed else "info")
    return Feedback(
        summary="The node prints the answers with `print`, so they are not in its log."
        if printed
        else f"{len(lost)} of {every} answers are not completely in the log: "
        f"{listed(names)} of the first one {'is' if len(names) == 1 else 'are'} missing.",
        expected=", ".join(f"{name}={part}" for name, part in wanted.items()),
        seen=shown[0][:120] if shown else "no message",
        where=cause.where if cause else tuple(call.where for call in made)[:2],
        advice=cause.text if cause else _advice(names, wanted, after, printed),
    )


def _advice(names: list[str], wanted: Mapping[str, str], after: list[str], printed: list[str]) -> str:
    if printed:
        return "Use the node's logger instead of `print`: `self.get_logger().info(...)`."
    if any("{" in text for text in after):
        return "The braces were logged as is. Put an `f` before the string: `f'...'`."
    if len(names) < len(wanted):
        return f"Log all of {', '.join(f'`{name}`' for name in wanted)}; `{names[0]}` is missing."
    return "Read `future.result()` once the future is `done()`, and log each field of the answer."


def _unanswered(sources: Sources) -> Cause | None:
    grouped = any("callback_group" in text for text in sources.files.values())
    alone = not grouped or not calls(sources, "MultiThreadedExecutor")
    found = slips.first(sources, future_lost, slips.asked_at_once, slips.one_thread)
    return found or (slips.standstill(sources) if alone else None)


def future_lost(sources: Sources) -> Cause | None:
    """A `call_async` whose future is not kept."""
    for file, tree in trees(sources):
        for node in ast.walk(tree):
            value = node.value if isinstance(node, ast.Expr) else None
            if isinstance(value, ast.Call) and getattr(value.func, "attr", "") == "call_async":
                return Cause(
                    "`call_async` returns a future, and this line throws it away. Keep it, and "
                    "name a method to receive the answer: "
                    "`future.add_done_callback(self.answered)`.",
                    (Location(file, value.lineno),),
                )
    return None


def no_wait(sources: Sources) -> Cause | None:
    """A client that never asks whether its service is there."""
    if calls(sources, "wait_for_service") or calls(sources, "service_is_ready"):
        return None
    return Cause(
        "Nothing waits for the service. Before the first call, log a message in a loop: "
        "`while not self.client.wait_for_service(timeout_sec=1.0):`.",
        tuple(call.where for call in calls(sources, "create_client"))[:1],
    )
