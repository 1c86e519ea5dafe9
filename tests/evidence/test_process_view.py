"""What a recording tells of one program."""

from __future__ import annotations

import signal

import pytest

from course.evidence.process_view import ProcessView
from course.model.events import (
    Event,
    ExecutableMissing,
    Marked,
    OutputCut,
    OutputLine,
    ProcessExited,
    ProcessStarted,
    SignalSent,
)

PLAIN = """\
Traceback (most recent call last):
  File "/lib/talker.py", line 3, in main
    {}["x"]
    ~~^^^^^
KeyError: 'x'"""

CHAINED = f"""\
{PLAIN}

The above exception was the direct cause of the following exception:

Traceback (most recent call last):
  File "/lib/talker.py", line 5, in main
    raise ValueError("no x") from error
ValueError: no x"""

INDENTED = """\
Traceback (most recent call last):
  File "/lib/talker.py", line 3, in main
    Node("the talker")
InvalidNodeNameException: Invalid node name: node name must not contain characters other than ...:
  'the talker'
      ^"""

SYNTAX = """\
Traceback (most recent call last):
  File "/lib/talker", line 33, in <module>
    sys.exit(main())
  File "/lib/talker.py", line 11
    def main()
              ^
SyntaxError: expected ':'"""


def view(*events: Event, text: str = "", t: float = 1.0) -> ProcessView:
    lines = (OutputLine(t, "talker", line) for line in text.splitlines())
    return ProcessView.of("talker", (*events, *lines))


def test_only_its_own_events_count() -> None:
    found = ProcessView.of(
        "talker",
        (
            Marked(0.0, "talker"),
            ExecutableMissing(0.0, "talker", "talk", "talker", ()),
            ProcessStarted(0.1, "listener", ("l",)),
            ProcessStarted(0.2, "talker", ("t",)),
            OutputLine(0.3, "talker", "one"),
            OutputLine(0.3, "listener", "other"),
            OutputCut(0.4, "talker", 5),
            OutputCut(0.5, "talker", 7),
            OutputCut(0.5, "listener", 100),
            SignalSent(0.6, "listener", signal.SIGINT),
            ProcessExited(0.7, "talker", 0, None),
        ),
    )
    assert found.started == ProcessStarted(0.2, "talker", ("t",))
    assert found.text == ("one",)
    assert found.dropped == 12
    assert found.signals == ()
    assert found.lifetime == pytest.approx(0.5)


def test_a_program_that_never_ran() -> None:
    found = view()
    assert (found.started, found.exited, found.ended_by_itself, found.lifetime) == (None, None, None, None)
    assert (found.interrupted_at, found.traceback(), found.dropped) == (None, (), 0)


@pytest.mark.parametrize(("sent", "itself"), [(None, True), (2.0, False), (2.5, False), (3.0, True)])
def test_it_ended_by_itself_when_no_signal_came_before(sent: float | None, itself: bool) -> None:
    end = ProcessExited(2.5, "talker", 1, None)
    signals = [SignalSent(sent, "talker", signal.SIGINT)] if sent else []
    assert view(end, *signals).ended_by_itself == (end if itself else None)


def test_the_first_interrupt_counts() -> None:
    sent = [(1.0, signal.SIGTERM), (2.0, signal.SIGINT), (3.0, signal.SIGINT), (4.0, signal.SIGKILL)]
    assert view(*(SignalSent(t, "talker", number) for t, number in sent)).interrupted_at == 2.0


# tracebacks


@pytest.mark.parametrize("text", [PLAIN, INDENTED, SYNTAX], ids=["plain", "indented message", "syntax"])
def test_a_traceback_is_found_among_other_lines(text: str) -> None:
    around = f"starting\n{text}\nstopping\n  indented"
    assert view(text=around).traceback() == tuple(text.splitlines())


def test_of_chained_tracebacks_the_last_one_counts() -> None:
    assert view(text=CHAINED).traceback()[-1] == "ValueError: no x"
    assert len(view(text=CHAINED).traceback()) == 4


def test_of_several_tracebacks_the_last_one_counts() -> None:
    assert view(text=f"{PLAIN}\nagain\n{SYNTAX}").traceback() == tuple(SYNTAX.splitlines())


def test_no_traceback() -> None:
    assert view(text="one\ntwo").traceback() == ()


def test_a_traceback_that_breaks_off() -> None:
    cut = PLAIN.splitlines()[:3]
    assert view(text="\n".join(cut)).traceback() == tuple(cut)


def test_of_a_long_message_a_few_lines_are_kept() -> None:
    text = PLAIN + "\n" + "\n".join(f"  {n}" for n in range(100))
    assert len(view(text=text).traceback()) == 5 + 4


def test_only_what_was_printed_after_a_time_counts() -> None:
    early = [OutputLine(1.0, "talker", line) for line in PLAIN.splitlines()]
    assert view(*early).traceback(after=1.0) != ()
    assert view(*early).traceback(after=1.1) == ()
    assert view(*early, text=SYNTAX, t=2.0).traceback(after=1.5) == tuple(SYNTAX.splitlines())


@pytest.mark.parametrize("kind", ["SyntaxError: expected ':'", "IndentationError: unexpected indent"])
def test_a_script_that_python_cannot_read_has_no_traceback_line(kind: str) -> None:
    lines = ("hello", '  File "~/a.py", line 3', "    while True", "              ^", kind)
    view = ProcessView.of("p", tuple(OutputLine(n / 10, "p", text) for n, text in enumerate(lines)))
    assert view.traceback() == lines[1:]
    assert ProcessView.of("p", (OutputLine(0.0, "p", kind),)).traceback() == ()
