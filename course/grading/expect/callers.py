"""What is expected of a node that calls a service again and again, and logs the answers."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from math import inf

from course.errors import OurFault
from course.evidence.recording import Recording
from course.evidence.service_view import ServiceCall
from course.evidence.topic_view import seconds
from course.feedback import Failure, Feedback
from course.grading.expect.programs import expect_running
from course.grading.explain.names import listed
from course.grading.explain.python_code import calls
from course.grading.explain.services import future_lost, no_wait, standstill
from course.grading.explain.timers import timer_cause, timer_places

# By the field's name, what must be in the log of one answer.
Texts = Callable[[ServiceCall], Mapping[str, str]]


def expect_waiting(recording: Recording, process: str, until: float) -> None:
    """The node logged something before the time `until`, when the service came."""
    if any(line.t < until for line in recording.log):
        return
    printed = [line.text for line in recording.process(process).lines if line.t < until]
    cause = no_wait(recording.sources)
    waiting = calls(recording.sources, "wait_for_service")
    raise Failure(
        Feedback(
            summary="While there is no service, the node says so with `print`, and not in its log."
            if printed
            else "While there is no service, the node says nothing.",
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
    """The node sent so many requests to the arena's server, which was there since the time `since`."""
    requests = recording.service(service).requests
    if len(requests) >= at_least:
        return
    expect_running(recording, process)
    cause = standstill(recording.sources) or timer_cause(recording.sources)
    once = "once" if len(requests) == 1 else f"{len(requests)} times"
    raise Failure(
        Feedback(
            summary=f"The node calls the service {once}, and then no more."
            if requests
            else "The service is there, but the node does not call it.",
            expected=f"a call every {seconds(period)}",
            seen=f"{len(requests)} calls in {recording.duration - since:.1f} s",
            where=cause.where if cause else timer_places(recording.sources),
            advice=cause.text
            if cause
            else "Check that the timer's callback comes to `call_async` each time: does a `return` or "
            "an `if` before it keep it from there?",
        )
    )


def expect_answers_logged(
    recording: Recording, process: str, answered: tuple[ServiceCall, ...], texts: Texts
) -> None:
    """All parts of each of these answers are in the log."""
    lost = [call for call in answered if _missing(recording, call, texts)]
    if lost:
        expect_running(recording, process)
        raise Failure(_not_logged(recording, process, lost, len(answered), texts))


def expect_patience(
    recording: Recording, process: str, service: str, resumed: float, period: float, texts: Texts
) -> None:
    """After a while without answers, from `resumed` on the node asked again and logged what it got.

    Raises OurFault when the scenario did not come so far.
    """
    expect_running(recording, process)
    if resumed == inf:
        raise OurFault("the scenario did not stop answering")
    later = [call for call in recording.service(service).requests if call.answered and call.asked > resumed]
    if any(not _missing(recording, call, texts) for call in later):
        return
    cause = standstill(recording.sources)
    waited = recording.duration - resumed
    raise Failure(
        Feedback(
            summary="One answer did not come, and the node never called again."
            if not later
            else "One answer did not come, and the node logs no later one.",
            expected=f"a call every {seconds(period)}, and its answer in the log",
            seen=f"{len(later)} calls in the {waited:.1f} s after the service answered again",
            where=cause.where
            if cause
            else tuple(call.where for call in calls(recording.sources, "done"))[:1],
            advice=cause.text
            if cause
            else "Do not wait forever for one answer. When it is time for the next call and the "
            "future is not `done()` yet: `cancel()` it, log that, and call again.",
        )
    )


def _missing(recording: Recording, call: ServiceCall, texts: Texts) -> list[str]:
    """Names of the parts that the log does not hold from the call on."""
    text = "\n".join(line.text for line in recording.log if line.t >= call.asked)
    return [name for name, part in texts(call).items() if part not in text]


def _not_logged(
    recording: Recording, process: str, lost: list[ServiceCall], every: int, texts: Texts
) -> Feedback:
    wanted, names = texts(lost[0]), _missing(recording, lost[0], texts)
    after = [line.text for line in recording.log if line.t > lost[0].asked]
    terminal = recording.process(process).text
    printed = [] if after else [text for text in terminal if wanted[names[0]] in text]
    cause = None if printed or len(names) < len(wanted) else future_lost(recording.sources)
    shown = printed or after
    made = calls(recording.sources, "print" if printed else "info")
    return Feedback(
        summary="The answers are shown by `print`: they are on the terminal, but not in the node's log."
        if printed
        else f"{len(lost)} of {every} answers are not in the log, or not all of them: "
        f"it lacks {listed(names)} of the first one.",
        expected=", ".join(f"{name}={part}" for name, part in wanted.items()),
        seen=shown[0][:120] if shown else "no message",
        where=cause.where if cause else tuple(call.where for call in made)[:2],
        advice=cause.text if cause else _advice(names, wanted, after, printed),
    )


def _advice(names: list[str], wanted: Mapping[str, str], after: list[str], printed: list[str]) -> str:
    if printed:
        return "Use the node's logger in place of `print`: `self.get_logger().info(...)`."
    if any("{" in text for text in after):
        return "The braces were logged as they are: put an `f` before the string, `f'...'`."
    if len(names) < len(wanted):
        return f"Log all of {', '.join(f'`{name}`' for name in wanted)}; `{names[0]}` is missing."
    return "Take `future.result()` once the future is `done()`, and log each field of the answer."
