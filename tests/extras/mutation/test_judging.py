"""The fate of mutants: each judges recordings, in processes that may never end."""

from __future__ import annotations

import psutil
import pytest

from course_mutation.model import Fate, Judged
from course_mutation.mutants import mutants
from course_mutation.run import judged
from tests.processes import words_of

from .conftest import Workshop

LONG = """\
@light.check("long", "it shines long")
def long(recording):
    if recording.duration < 5.0:
        raise Failure(Feedback(f"It shone {recording.duration:g} s."))
"""

# One of its mutants never ends.
ENDLESS = """\
@light.check("ends", "it ends")
def ends(recording):
    count = 0
    while not count:
        count += recording.duration > 1
"""


@pytest.mark.slow
def test_a_check_that_nobody_fails(workshop: Workshop) -> None:
    line = workshop.grader(LONG)
    workshop.right(6)
    problems, found = workshop.judged()
    assert problems == ()
    fates = {after: one.fate for after, one in found.items()}
    assert fates == {
        "return": Fate.SURVIVED,
        "if recording.duration >= 5.0:": Fate.KILLED,
        "if recording.duration < 10:": Fate.KILLED,
        "if recording.duration < 2.5:": Fate.SURVIVED,
    }
    survivor = found["return"].mutant
    assert (survivor.line, survivor.checks) == (line + 2, ("long",))
    assert survivor.before.startswith("if recording.duration < 5.0:")
    assert found["if recording.duration < 10:"].by == "solution: `long` failed: It shone 6 s."


@pytest.mark.slow
def test_a_mistake_kills(workshop: Workshop) -> None:
    workshop.grader(LONG)
    workshop.right(6)
    workshop.mistake("dark", 1, "long", "shone 1 s")
    _, found = workshop.judged()
    assert found["return"].fate is Fate.KILLED
    assert found["return"].by == "mistake dark: `long` does not catch it: the check passed"
    assert found["if recording.duration < 2.5:"].fate is Fate.SURVIVED
    workshop.mistake("short", 3, "long")
    _, found = workshop.judged()
    assert found["if recording.duration < 2.5:"].by.startswith("mistake short")


@pytest.mark.slow
def test_first_is_asked_who_should_notice(workshop: Workshop) -> None:
    workshop.grader(LONG.replace("5.0", "len('abcde')"))
    workshop.right(6)
    workshop.mistake("dark", 1, "long")
    _, found = workshop.judged()
    assert found["if recording.duration >= len('abcde'):"].by.startswith("mistake dark")


@pytest.mark.slow
def test_endless_and_broken(workshop: Workshop) -> None:
    workshop.grader(
        """\
@light.check("ends", "it ends")
def ends(recording):
    count = 0
    while count != 3:
        count += 1

@light.check("known", "it is known")
def known(recording):
    if isinstance(recording, Failure) and recording.nothing:
        pass

def is_sane():
    return 1 < 2

@light.check("sane", "it is sane")
def sane(recording):
    is_sane()

if not is_sane():
    raise RuntimeError("this is no grader")
"""
    )
    workshop.right(6)
    _, found = workshop.judged(seconds=1)
    endless = found["while count == 3:"]
    assert endless.fate is Fate.SURVIVED  # it ends at once, and nothing checks the count
    broken = found["if (isinstance(recording, Failure) or recording.nothing):"]
    assert broken.fate is Fate.BROKEN
    assert "AttributeError" in broken.by
    unfit = found["return 1 >= 2"]
    assert unfit.fate is Fate.BROKEN
    assert "this is no grader" in unfit.by


@pytest.mark.slow
def test_one_that_does_not_end(workshop: Workshop) -> None:
    workshop.grader(ENDLESS)
    workshop.right(6)
    _, found = workshop.judged(seconds=0.5)
    assert found["count += recording.duration <= 1"].fate is Fate.ENDLESS
    assert found["while count:"].fate is Fate.SURVIVED


@pytest.mark.slow
def test_proofs_that_do_not_hold_are_told_and_not_asked(workshop: Workshop) -> None:
    workshop.grader(LONG)
    workshop.right(6)
    workshop.mistake("dark", 9, "long")
    problems, found = workshop.judged()
    assert problems == ("04-light mistake dark: `long` does not catch it: the check passed",)
    assert found["return"].fate is Fate.SURVIVED


@pytest.mark.slow
def test_what_a_mystery_and_probes_lie_beside(workshop: Workshop) -> None:
    (workshop.root / "graders/beside.py").write_text("LEAST = 5\n")
    (workshop.root / "graders/probes").mkdir()
    (workshop.root / "graders/probes/probe.py").write_text("pass\n")
    workshop.grader(
        """\
from pathlib import Path
from beside import LEAST
HERE = Path(__file__).resolve()
assert HERE.with_name("probes").joinpath("probe.py").is_file()
assert (HERE.parents[1] / "chapters/04-lanterns").is_dir()

"""
        + LONG.replace("5.0", "LEAST")
    )
    workshop.right(6)
    workshop.mistake("dark", 1, "long")
    problems, found = workshop.judged()
    assert problems == ()
    assert {one.fate for one in found.values()} == {Fate.KILLED}


@pytest.mark.slow
def test_a_grader_that_is_written_meanwhile(workshop: Workshop) -> None:
    workshop.grader(LONG)
    workshop.right(6)
    course = workshop.course
    exercise = course.exercise("04-light")
    every = mutants(exercise)
    workshop.grader("this is no Python")
    problems, *found = judged(course, exercise, every, workshop.recorded, 2)
    assert problems == ()
    assert {one.fate for one in found if isinstance(one, Judged)} == {Fate.KILLED, Fate.SURVIVED}


@pytest.mark.slow
def test_who_stops_early_leaves_no_process(workshop: Workshop) -> None:
    workshop.grader(ENDLESS)
    workshop.right(6)
    course = workshop.course
    exercise = course.exercise("04-light")
    answers = judged(course, exercise, mutants(exercise), workshop.recorded, 2)
    next(answers)
    children = psutil.Process().children()
    (worker,) = (child for child in children if "course_mutation.worker" in words_of(child))
    # Its mutants come and go, so look again while all are stopped.
    worker.suspend()
    ours = [worker, *worker.children(recursive=True)]
    answers.close()
    _gone, alive = psutil.wait_procs(ours, timeout=30)
    assert alive == []
