"""`watch` on a real pseudo-terminal, as a learner has it: saving, keys, resizing, every way to end it."""

from __future__ import annotations

import os
import re
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from course.progress import Progress
from tests.watch.conftest import KEYS
from tests.watch.pretended import LIGHT

if TYPE_CHECKING:
    from tests.watch.conftest import Seat

pytestmark = pytest.mark.slow


def reached(condition: Callable[[], bool]) -> None:
    """Wait for it without looking at the terminal."""
    deadline = time.monotonic() + 60
    while not condition():
        assert time.monotonic() < deadline
        time.sleep(0.05)


def test_from_the_lesson_over_saves_to_the_next_exercise(seat: Seat) -> None:
    seat.sit_down()
    seat.see("Chapter 4: Lanterns", "brightness")
    seat.child.send("t")
    seat.see("04-light: Light it", "Write full()")
    seat.save("dark")
    seat.see("Not passed yet: 0 of 4 points", "no  It shines", "It is dark.")
    seat.save("half")
    seat.see("2 of 4 points (2 points more)", "+ It stands passes now")
    seat.save("bright")
    seat.see("Passed: 4 of 4", "It shines.", "Press n for the next exercise.")
    seat.child.send("n")
    seat.see("04-dim: Dim it")
    seat.quit()
    with Progress.open(seat.home / ".ros2course") as progress:
        assert progress.state("04-light") == "passed"
        assert progress.attempts("04-light") == 3, "starters that were laid are no saves"
        assert progress.current() == "04-dim"
    assert [call.split()[1] for call in seat.calls()] == ["dark", "half", "bright"]


def test_every_key_does_what_the_last_line_says(seat: Seat) -> None:
    seat.sit_down()
    seat.child.send("h")
    seat.see("Hint 1 of 3", "A lantern that is lit is not dark.")
    seat.child.send("hh")
    seat.see("Hint 3 of 3", "That was the last hint.")
    seat.child.send("l")
    seat.see("> ..", "04-dim", "0 of 2 passed.")
    seat.child.send("n")
    seat.see("04-light is not passed yet")
    seat.child.send("r")
    seat.see("It has not been checked yet")
    seat.save("dark")
    seat.see("0 of 4 points")
    seat.child.send("t")
    seat.see("Write full()")
    seat.child.send("t")
    seat.see("brightness")
    seat.child.send("r")
    seat.see("no  It shines")
    seat.child.send("\x1b[A\x1bOPxz")
    seat.child.send("c")
    seat.see("nothing has changed")
    assert len(seat.calls()) == 2
    seat.quit()


def test_a_save_during_a_check_begins_it_anew(seat: Seat) -> None:
    seat.sit_down()
    seat.save("waits 1")
    seat.see("looking at the waits 1 lantern")
    seat.save("waits 2")
    seat.see("looking at the waits 2 lantern", "checking again")
    seat.save("bright")
    seat.see("Passed: 4 of 4")
    told = ["began waits 1", "ended waits 1", "began waits 2", "ended waits 2", "began bright"]
    assert seat.calls() == told, "each has ended before the next began"
    seat.quit()
    with Progress.open(seat.home / ".ros2course") as progress:
        assert progress.attempts("04-light") == 1


def test_a_thousand_saves_are_few_checks(seat: Seat) -> None:
    seat.sit_down()
    for _ in range(1000):
        seat.save("dark")
    seat.save("bright")
    seat.see("Passed: 4 of 4")
    assert len(seat.calls()) < 300
    seat.quit()


@pytest.mark.parametrize(
    ("number", "code"), [(signal.SIGINT, 130), (signal.SIGTERM, 143), (signal.SIGHUP, 129)]
)
@pytest.mark.parametrize("checking", [False, True])
def test_a_signal_ends_it_in_order(seat: Seat, number: int, code: int, checking: bool) -> None:
    seat.sit_down()
    if checking:
        seat.save("waits")
        seat.see("looking at the waits lantern")
    if number == signal.SIGINT:
        seat.child.sendintr()
    else:
        seat.program().send_signal(number)
    assert seat.ended() == code
    assert seat.calls() == (["began waits", "ended waits"] if checking else [])
    assert seat.errors() == ""


def test_q_in_the_middle_of_a_check(seat: Seat) -> None:
    seat.sit_down()
    seat.save("waits")
    seat.see("looking at the waits lantern")
    seat.quit()
    assert seat.calls() == ["began waits", "ended waits"]


def test_killed_it_leaves_no_check_behind(seat: Seat) -> None:
    seat.sit_down()
    seat.save("waits")
    seat.see("looking at the waits lantern")
    seat.program().kill()
    seat.wait(lambda: seat.calls() == ["began waits", "ended waits"], "the end of the check")


def test_a_terminal_that_goes_away(seat: Seat) -> None:
    seat.sit_down()
    seat.save("waits")
    seat.see("looking at the waits lantern")
    program = seat.program()
    os.close(seat.child.child_fd)
    program.wait(60)
    assert seat.calls() == ["began waits", "ended waits"]


def test_ctrl_z_and_back(seat: Seat) -> None:
    seat.spawn(["bash", "--norc", "--noprofile", "-i"])
    seat.see("prompt>")
    seat.child.sendline(seat.command())
    seat.see("Chapter 4", KEYS)
    seat.child.send("\x1a")
    seat.see("Stopped")
    seat.is_given_back()
    seat.child.sendline("stty -a")
    seat.see(" icanon ", " echo ")
    seat.save("bright")
    seat.child.sendline("clear; fg")
    seat.see("Passed: 4 of 4", KEYS)
    seat.child.send("q")
    seat.see("Type next:", "prompt>")
    seat.child.sendline("clear; stty -a")
    seat.see(" icanon ", " echo ")
    seat.is_given_back()


def test_ctrl_s_does_not_stop_it(seat: Seat) -> None:
    seat.sit_down()
    seat.child.send("\x13")
    seat.save("bright")
    seat.see("Passed: 4 of 4")
    seat.quit()


def test_a_terminal_that_takes_nothing_holds_up_nothing(seat: Seat) -> None:
    seat.sit_down()
    program = seat.program()
    seat.child.setwinsize(2000, 200)  # a screenful is more than a pseudo-terminal holds; nobody reads it
    seat.save("flood")
    reached(lambda: seat.calls() == ["began flood"])
    seat.child.send("tlt")
    seat.save("waits")
    reached(lambda: seat.calls() == ["began flood", "began waits"])
    program.terminate()
    program.wait(60)
    assert seat.calls()[-1] == "ended waits"


def test_a_quiz_is_asked_on_the_terminal(seat: Seat) -> None:
    seat.course = Path(__file__).parents[1] / "fixtures/quiz_course"
    (seat.home / "answers").mkdir()
    seat.sit_down("05-quiz")
    seat.see("press c to answer its questions")
    seat.child.send("c")
    for number in range(1, 6):
        seat.see(f"Question {number} of 5")
        seat.is_given_back()
        seat.child.send("\r")  # left for later
    seat.see("Not passed yet: 0 of 4 points", KEYS)
    seat.save("written: in an editor", "answers/05-quiz.yaml")
    seat.see("nothing has changed")
    assert seat.calls() == ["began dark"] * 2
    seat.quit()


def test_resizing_draws_anew(seat: Seat) -> None:
    seat.sit_down()
    seat.resize(30, 60)
    seat.wait(lambda: KEYS not in seat.screen.display[23] and "n next" in seat.screen.display[29], "30x60")
    seat.resize(6, 30)
    seat.wait(lambda: "n next" in seat.screen.display[5] and "04-light" in seat.screen.display[0], "6x30")
    seat.resize(24, 80)
    seat.wait(lambda: KEYS in seat.screen.display[23] and "Lanterns" in seat.screen.display[1], "24x80")
    seat.quit()


def test_a_flood_is_cut_to_what_the_screen_holds(seat: Seat) -> None:
    seat.sit_down()
    seat.save("flood")
    seat.see("Not passed yet: 0 of 400", "more lines: space shows them", "check` shows all at once")
    first = seat.text()
    seat.child.send(" ")
    seat.wait(lambda: seat.text() != first, "the next screenful")
    seat.child.send("h")
    seat.see("Hint 1 of 3")
    seat.quit()


def test_what_has_no_verdict_is_told_and_the_next_save_is_checked(seat: Seat) -> None:
    seat.sit_down()
    seat.save("lacks")
    seat.see("Error: There is no lamp oil on this machine.", "Next: Buy some.")
    seat.save("breaks")
    seat.see("The course itself has an error", "RuntimeError: the wick", "does not count")
    seat.save("falls")
    seat.see("ended without a verdict", "out of oil")
    seat.save("half")
    seat.see("2 of 4 points")
    seat.quit()


@pytest.mark.parametrize("gone", ["", ".ros2course/home.json"], ids=["moved away", "no home any more"])
def test_a_home_that_goes_away(seat: Seat, gone: str) -> None:
    seat.sit_down()
    seat.save("waits")
    seat.see("looking at the waits lantern")
    (seat.home / gone).rename(seat.folder / "elsewhere")
    assert seat.ended() == 2
    assert seat.calls() == ["began waits", "ended waits"]
    assert re.sub(r"\s+", " ", seat.errors()).startswith("Error: The course home is gone:")
    assert "ros2course init" in seat.errors()


def test_without_a_home(seat: Seat) -> None:
    seat.home.rename(seat.folder / "elsewhere")
    seat.spawn(["/bin/sh", "-c", f"{seat.command()}; echo code $?"])
    seat.see("does not exist", "ros2course init", "code 2")


def test_an_exercise_that_is_not_there(seat: Seat) -> None:
    seat.spawn(["/bin/sh", "-c", f"{seat.command('99-nothing')}; echo code $?"])
    seat.see("code 2")
    assert b"\x1b[?1049h" not in seat.raw


@pytest.mark.parametrize("terminal", ["dumb", ""])
def test_a_terminal_that_cannot_be_drawn_on(seat: Seat, terminal: str) -> None:
    seat.spawn(["/bin/sh", "-c", f"{seat.command()}; echo code $?"], {"TERM": terminal})
    seat.see("ros2course check", "code 2")
    assert b"\x1b[?1049h" not in seat.raw


def test_off_a_terminal(seat: Seat) -> None:
    done = subprocess.run(
        [sys.executable, "-m", "course", "watch"],
        capture_output=True,
        text=True,
        stdin=subprocess.DEVNULL,
        env={**os.environ, "ROS2COURSE_HOME": str(seat.home), "COLUMNS": "80"},
        timeout=60,
        check=False,
    )
    assert done.returncode == 2
    assert "this is not a terminal" in done.stderr and "ros2course check" in done.stderr


def test_all_passed(seat: Seat) -> None:
    seat.sit_down()
    seat.save("bright")
    seat.see("Passed: 4 of 4")
    seat.child.send("n")
    seat.see("04-dim: Dim it")
    seat.save("anything", LIGHT.replace("light.py", "dim.py"))
    seat.see("Passed: 4 of 4")
    seat.child.send("n")
    seat.see("You have passed every exercise")
    seat.quit()
