"""The advice from the notes of a second run, any of which the submission may have written."""

from __future__ import annotations

import pytest

import course.explain.observed as observed
from course.evidence.packages import BuiltPackage, BuiltPackages
from course.evidence.recording import Recording
from course.evidence.sources import Sources
from course.explain.engine import Cause, failed_with
from course.explain.observed import UNKNOWN, observed_cause, unproven
from course.model.events import Observed
from course.model.feedback import Feedback, Location
from course.model.result import CheckResult, Outcome

FILE = "ws/src/talk/talk/talker.py"
INSTALLED = "/store/talk/lib/python3.11/site-packages/talk/talker.py"
TEXT = """\
class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.timer = self.create_timer(0.5, self.tick)

    def tick(self):
        while not self.future.done():
            pass
        self.say('no' + 1)

def main():
    try:
        input('Start?')
        rclpy.spin(Talker())
    except ValueError:
        pass
    except Exception as e:
        print(e)
"""
ERROR = 'TypeError: can only concatenate str (not "int") to str'


def at(line: int | None, file: str = INSTALLED) -> Location:
    return Location(file, line)


def cause_of(*notes: Observed, text: str = TEXT) -> Cause | None:
    packages = BuiltPackages((BuiltPackage("talk", "ws/src/talk", "/store/talk"),))
    return observed_cause(Recording("x", notes, sources=Sources({FILE: text}), packages=packages))


def caught(raised: Location | None, by: Location, error: str = ERROR) -> Observed:
    return Observed(0.0, "caught", error, raised, by)


def ran(*lines: int) -> Observed:
    return Observed(0.0, "ran", by=at(None), lines=lines)


def test_a_hidden_error() -> None:
    found = cause_of(ran(9, 12), caught(at(9), at(17)))
    assert found is not None
    assert found.text == (
        f"Your `except` on line 17 hides this error: `{ERROR}`, raised on line 9. "
        "This line adds a number to a string: use an f-string."
    )
    assert found.where == (Location(FILE, 9), Location(FILE, 17))


@pytest.mark.parametrize(
    "note",
    [
        caught(at(14), at(17), "KeyboardInterrupt"),
        caught(at(14), at(17), "rclpy.executors.ExternalShutdownException"),
        caught(at(13), at(15), "ValueError: what it is for"),
        caught(at(9), at(16)),  # no `except`
        caught(at(9), at(9999)),
        caught(at(9), at(17, "/etc/passwd")),
        caught(at(9), at(17, "/home/somebody/talk/talker.py")),
        caught(at(9), at(-17)),
        caught(at(9), at(17), ""),
        Observed(0.0, "died", ERROR, at(3, "/somebody/else.py")),
        Observed(0.0, "stood", by=at(14), seconds=5),  # it spins
        Observed(0.0, "stood", by=at(13), seconds=1e300),
        Observed(0.0, "stood", by=at(13), seconds=-3),
        Observed(0.0, "looped", by=at(13), seconds=3),  # in main
    ],
    ids=str,
)
def test_what_is_harmless_or_does_not_fit_says_nothing(note: Observed) -> None:
    assert cause_of(ran(1, 3, 4, 13), note) is None


def test_a_forged_error_is_short_and_printable() -> None:
    hostile = "TypeError: \x1b[2J`rm -rf`\n\u202eesrever\x00 " + "x" * 100_000
    found = cause_of(caught(at(9, "/home/somebody/secret.py"), at(17), hostile))
    assert found is not None and found.where == (Location(FILE, 17),)
    assert found.text.isprintable() and len(found.text) < 400
    assert "somebody" not in found.text and "rm -rf`" not in found.text.replace("'rm -rf'", "")


def test_very_many_notes() -> None:
    notes = [caught(at(9), at(16), f"TypeError: {number}") for number in range(100_000)]
    assert cause_of(*notes) is None


def test_a_thread_that_died() -> None:
    found = cause_of(Observed(0.0, "died", ERROR, at(9)))
    assert found and found.text.startswith(
        "A thread or task of your program ended with this error: `TypeError:"
    )


def test_a_halt_before_spin() -> None:
    found = cause_of(Observed(0.0, "stood", by=at(13), seconds=4.2))
    assert found == Cause(
        "Line 13 holds up the program: `input` had not finished 4 s later. The lines after it did not run.",
        (Location(FILE, 13),),
    )


def test_a_halt_that_was_over() -> None:
    halt = Observed(0.0, "stood", by=at(13), seconds=4.2)
    assert cause_of(ran(1, 3, 4, 13), halt, Observed(0.0, "stood", by=at(14))) is None


def test_a_loop_in_a_callback() -> None:
    found = cause_of(Observed(0.0, "looped", "called back", by=at(8), seconds=3))
    assert found and found.text.startswith("The loop on line 7 never ends: after 3 s")
    assert found.where == (Location(FILE, 7),)


def test_a_callback_that_returned_in_the_end() -> None:
    loop = Observed(0.0, "looped", "called back", by=at(8), seconds=12)
    assert cause_of(ran(1, 3, 4, 13), loop, Observed(0.0, "looped", by=at(8))) is None


WAITS = """\
def main():
    {begins}
    {waits}

class Talker(Node):
    def work(self):
        pass
"""
THREADED = "thread = threading.Thread(target=work)"


@pytest.mark.parametrize(
    ("begins", "waits"),
    [
        (THREADED, "thread.join()"),
        (THREADED, "self.done.wait()"),
        (THREADED, "while not thread.done: time.sleep(2)"),
        (THREADED, "input()"),
        (THREADED, "signal.pause()"),
        ("rclpy.spin_until_future_complete(node, future)", "input('Again?')"),
        ("publish()", "while rclpy.ok(): time.sleep(2)"),
    ],
)
def test_main_may_wait_where_others_work(begins: str, waits: str) -> None:
    text = WAITS.format(begins=begins, waits=waits)
    assert cause_of(ran(1, 2, 3), Observed(0.0, "stood", by=at(3), seconds=4), text=text) is None
    called = cause_of(ran(1, 2, 3), Observed(0.0, "stood", "called back", by=at(3), seconds=4), text=text)
    assert called and called.text.startswith("Line 3 holds up the program")


@pytest.mark.parametrize(
    ("begins", "waits"),
    [
        ("node = Talker()", "thread.join()"),
        ("node = Talker()", "time.sleep(60)"),
        (THREADED, "client.wait_for_service()"),
    ],
)
def test_main_waits_and_nobody_works(begins: str, waits: str) -> None:
    text = WAITS.format(begins=begins, waits=waits)
    found = cause_of(ran(1, 2, 3), Observed(0.0, "stood", by=at(3), seconds=4), text=text)
    assert found and found.text.startswith("Line 3 holds up the program")


def test_main_waits_before_it_spins() -> None:
    text = WAITS.format(begins="if False: rclpy.spin(node)", waits="input()").replace(
        ": rcl", ":\n        rcl"
    )
    found = cause_of(ran(1, 2, 4), Observed(0.0, "stood", by=at(4), seconds=4), text=text)
    assert found and found.text.startswith("Line 4 holds up the program")


def test_only_the_last_halt_is_looked_into(monkeypatch: pytest.MonkeyPatch) -> None:
    looked: list[object] = []
    monkeypatch.setattr(observed, "_halted", lambda note, *more: looked.append(note.event))
    halts = [Observed(0.0, "stood", by=at(13), seconds=seconds) for seconds in range(2, 300)]
    assert cause_of(ran(1, 3, 4, 13), *halts) is None
    assert looked == halts[-1:]


def test_main_that_nobody_calls() -> None:
    found = cause_of(ran(1, 2, 6, 11))
    assert found == Cause("Nothing calls `main()`: none of its lines ran.", (Location(FILE, 11),))


def test_a_line_that_is_not_come_to() -> None:
    found = cause_of(ran(1, 2, 3, 6, 11, 12, 13, 14))
    assert found and found.text == "The program never reaches line 4, which calls `create_timer`."


def test_a_loop_that_never_ran() -> None:
    packages = BuiltPackages((BuiltPackage("talk", "ws/src/talk", "/store/talk"),))
    text = "def work():\n    while rclpy.ok:\n        work()\n"
    for lines, told in (((1, 2), "The loop on line 2 never ran"), ((1, 2, 3), UNKNOWN), ((1,), UNKNOWN)):
        notes = (ran(*lines),)
        recording = Recording("x", notes, sources=Sources({FILE: text}), packages=packages)
        assert unproven(recording, "the loop?", ended=True).text.startswith(told)
        assert unproven(recording, "the loop?").text.startswith(UNKNOWN)


def test_only_files_of_this_program() -> None:
    """The recording's sources are those of the program that a check is about."""
    recording = Recording("x", (caught(at(9), at(17)),), sources=Sources({}))
    assert unproven(recording, "the timer?") == Cause(f"{UNKNOWN} the timer?")


def test_what_asks_for_a_second_run() -> None:
    def check(outcome: Outcome, advice: str | None) -> CheckResult:
        return CheckResult("rate", "rate", 1, outcome, feedback=Feedback("x", advice=advice))

    assert failed_with(check(Outcome.FAILED, f"{UNKNOWN} the timer?"), UNKNOWN)
    assert not failed_with(check(Outcome.FAILED, "Write `0.5`."), UNKNOWN)
    assert not failed_with(check(Outcome.FAILED, None), UNKNOWN)
    assert not failed_with(check(Outcome.ERROR, f"{UNKNOWN} the timer?"), UNKNOWN)
    assert not failed_with(CheckResult("rate", "rate", 1, Outcome.PASSED), UNKNOWN)
