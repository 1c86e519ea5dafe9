"""Expectations of a node that logs how often something happened."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence

from course.api import (
    Arena,
    Cause,
    Failure,
    Feedback,
    LogLine,
    Process,
    Recording,
    Sources,
    calls,
    slips,
    text_places,
)

_SHOWN = 3
_NUMBERS = 5
_LATE = 8  # a thread may have to wait before it logs, while others continue to count
_DIGITS = 18  # Python refuses to convert numbers with thousands of digits


def await_counted(arena: Arena, node: Process | None, text: str, count: int, *, seconds: float) -> None:
    """Wait until the node has logged or printed `text` `count` times. Other output does not count.

    seconds: the longest wait after the first time.
    """
    if not node or not arena.until(lambda: arena.ros.graph.nodes, timeout=15, while_running=node):
        return
    if arena.until(lambda: arena.logged(text) or arena.printed(text), timeout=6, while_running=node):
        arena.until(
            lambda: arena.logged(text) >= count or arena.printed(text) > count + 1,
            timeout=seconds,
            while_running=node,
        )
    # What a quick node printed may reach the log a moment later.
    arena.until(lambda: arena.logged(text) >= count, timeout=1, while_running=node)


def expect_counted(recording: Recording, process: str, total: int, *, what: str) -> None:
    """Expect the log to count from 1 to `total`, with each number in its own message.

    The words around the numbers do not matter. what: what is counted, such as `calls`.
    """
    reached = highest_count(recording.log)
    if reached >= total:
        return
    printed = [line.text for line in recording.process(process).lines if has_number(line.text, 1)]
    if not recording.log and printed:
        raise Failure(_printed(recording, printed[0]))
    raise Failure(_wrong(recording, reached, total, what))


def expect_counting(
    lines: Sequence[LogLine],
    pattern: re.Pattern[str],
    *,
    sources: Sources,
    terminal: Sequence[str],
    first: str,
    begin: str,
    step: str,
    cause: Cause | None = None,
) -> None:
    """Expect 0, 1, 2 and so on as the numbers in these lines: group 1 of `pattern`.

    terminal: the node's output. It is enough if this counts: /rosout may lose messages of a node that floods.
    first: the expected first line. begin, step: advice if the first number, or a later one, is wrong.
    cause: why a later one is wrong, if the code proves it.
    """
    numbers = _numbers((line.text for line in lines), pattern)
    where = text_places(sources, re.split(r"\d", first)[0])[:_SHOWN]
    if _go_up_by_one(numbers) or _go_up_by_one(_numbers(terminal, pattern)):
        return
    if numbers[0] != 0:
        said = lines[0].text
        summary = f"The first message is `{said[:60]}`, not `{first}`."
        raise Failure(Feedback(summary=summary, expected=first, seen=said, where=where, advice=begin))
    seen = ", ".join(map(str, numbers[:_NUMBERS]))
    raise Failure(
        Feedback(
            summary=f"The count does not go up by one: {seen}.",
            expected=", ".join(map(str, range(_NUMBERS))),
            seen=seen,
            where=cause.where if cause else where,
            advice=cause.text if cause else step,
            details=tuple(line.text for line in lines[:_SHOWN]),
        )
    )


def _numbers(texts: Iterable[str], pattern: re.Pattern[str]) -> list[int]:
    matches = (pattern.search(text) for text in texts)
    return [int(found[1][:_DIGITS]) for found in matches if found]


def _go_up_by_one(numbers: list[int]) -> bool:
    return bool(numbers) and numbers == list(range(len(numbers)))


def highest_count(lines: tuple[LogLine, ...]) -> int:
    """The highest number to which these messages count, starting from 1.

    A message may come up to _LATE messages after one with a higher number.
    """
    count = 0
    unused: list[str] = []
    for line in lines:
        unused = [*unused[-_LATE:], line.text]
        while found := next((text for text in unused if has_number(text, count + 1)), None):
            unused.remove(found)
            count += 1
    return count


def has_number(text: str, number: int) -> bool:
    """Whether the text contains this number, also as `3rd` or `No.3`, but not in 3.5, 13 or ember3."""
    return bool(re.search(rf"(?<!\w)(?<!\d\.)(?<!-){number}(?:st|nd|rd|th)?(?!\w|\.\d)", text))


def _printed(recording: Recording, text: str) -> Feedback:
    return Feedback(
        summary="The count comes from `print`: it is in the terminal, but not in the node's log.",
        expected="a message in the node's log",
        seen=f"only in the terminal: {text[:120]}",
        where=tuple(call.where for call in calls(recording.sources, "print"))[:1],
        advice="Use the node's logger instead of `print`: `self.get_logger().info(...)`.",
    )


def _wrong(recording: Recording, reached: int, total: int, what: str) -> Feedback:
    lines = tuple(line.text for line in recording.log)
    from_zero = reached == total - 1 and any(has_number(text, 0) for text in lines)
    if not lines:
        summary = f"There were {total} {what}, and the node logged nothing."
    elif from_zero:
        summary = f"The count begins with 0, so after {total} {what} it is only at {reached}."
    else:
        summary = (
            f"There were {total} {what}, and the log does not count them: no message contains {reached + 1}."
        )
    advice = "Keep the count in the node: set it to 0 in `__init__`, add 1 in each callback, then log it."
    if any("{" in text for text in lines):
        advice = "The braces were logged as is. Put an `f` before the string: `f'...'`."
    logged = tuple(call.where for call in calls(recording.sources, "info"))
    cause = slips.compared(recording.sources) or Cause(advice, logged[:1])
    return Feedback(
        summary=summary,
        expected=f"messages with 1, 2, 3 and so on to {total}",
        seen=lines[0][:120] if lines else "no message",
        where=cause.where,
        advice=cause.text,
        details=lines[:_SHOWN],
    )
