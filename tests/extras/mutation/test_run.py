"""Mutation from the command to its end, with real gradings of an exercise that needs no ROS."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from course.content import open_course
from course_mutation.model import Change, Fate, Judged, Mutant, Mutation, OfExercise, Operator, Step
from course_mutation.mutants import findings
from course_mutation.run import known_elsewhere, mutate

LESSON = """\
chapter: 4
title: Lanterns
summary: Light a lantern.
exercises:
  - id: 04-light
    title: Light it
    summary: Write how bright a lantern is.
    files: [light.txt]
    hints: [A lantern that is lit is not dark., It is a number., Write `100`.]
"""
GRADER = """\
from course.api import Failure, Feedback, Grader

light = Grader("04-light", builds=None, ros=False)


@light.check("is_bright", "it is bright")
def is_bright(recording):
    number = int(recording.home.file("light.txt").text)
    if number < 100:
        raise Failure(Feedback(f"It shines with {number}, not 100."))
"""
MISTAKES = """\
mistakes:
  - id: too-dark
    exercise: 04-light
    summary: The lantern is hardly lit.
    edits: [{file: light.txt, replace: '100', with: '10'}]
    caught_by: is_bright
    says: ["10", "100"]
"""
DIMMED = """\
  - id: dimmed
    exercise: 04-light
    summary: The lantern is dimmed.
    edits: [{file: light.txt, replace: '100', with: '70'}]
    caught_by: is_bright
    says: ["70", "100"]
"""


@pytest.fixture
def lanterns(small_course: Path) -> Path:
    chapter, solution = small_course / "chapters/04-lanterns", small_course / "solutions/04-lanterns"
    shutil.rmtree(solution)
    shutil.rmtree(chapter / "starter")
    (chapter / "04-dim.md").unlink()
    solution.mkdir()
    (solution / "light.txt").write_text("100\n")
    (chapter / "lesson.yaml").write_text(LESSON)
    (chapter / "mistakes.yaml").write_text(MISTAKES)
    (small_course / "graders/ch04_lanterns.py").write_text(GRADER)
    return small_course


def of(course: Path, steps: list[Step] | None = None) -> OfExercise:
    opened = open_course(course)
    told = steps.append if steps is not None else lambda step: None
    mutation = mutate(opened, opened.exercises(), jobs=2, on_progress=told)
    [found] = mutation.exercises
    assert mutation.sound is not bool(found.survivors or found.problems)
    return found


@pytest.mark.slow
def test_a_missing_mistake(lanterns: Path) -> None:
    steps: list[Step] = []
    found = of(lanterns, steps)
    assert found.problems == ()
    assert (found.recorded, found.kept) == (2, 0)
    assert [one.mutant.after for one in found.survivors] == ["if number < 50:"]
    assert found.count(Fate.KILLED) == len(found.judged) - 1
    recording = [(step.done, step.total) for step in steps if step.stage == "recording"]
    assert recording == [(0, 2), (1, 2), (2, 2)]
    judged = [step.judged for step in steps if step.judged]
    assert sorted(judged, key=str) == sorted(found.judged, key=str)
    with (lanterns / "chapters/04-lanterns/mistakes.yaml").open("a") as file:
        file.write(DIMMED)
    added = of(lanterns)
    assert (added.recorded, added.kept, added.survivors) == (1, 2, ())


@pytest.mark.slow
def test_the_command(lanterns: Path) -> None:
    command = [sys.executable, "-m", "course", "--course", str(lanterns), "validate", "--mutate", "04-light"]
    actions = {**os.environ, "GITHUB_ACTIONS": "true", "GITHUB_WORKSPACE": str(lanterns)}
    done = subprocess.run(command, capture_output=True, text=True, env=actions, check=False, timeout=300)
    assert done.returncode == 1, done.stderr
    line = GRADER.splitlines().index("    if number < 100:") + 1
    assert f"  {line:>4}  04-light, `is_bright`: a bound made wider" in done.stdout
    assert "add one that is between 50 and 100 here" in done.stdout
    assert f"::error title=04-light,file=graders/ch04_lanterns.py,line={line}::" in done.stdout
    assert "recording" in done.stderr


def test_a_grader_that_cannot_be_read(lanterns: Path) -> None:
    (lanterns / "graders/ch04_lanterns.py").write_text("def (:\n")
    [problem] = of(lanterns).problems
    assert problem.startswith("the grader of 04-light cannot be read: ")


def judged(exercise: str, fate: Fate, start: int = 7) -> Judged:
    change = Change(Operator.NOT, start, start + 4, b"")
    mutant = Mutant(exercise, Path("/graders/x.py"), 3, "helper", ("a", "b"), change, "if not a:", "if a:")
    return Judged(mutant, fate, "" if fate is Fate.SURVIVED else "solution")


def test_what_another_exercise_notices() -> None:
    first = OfExercise("01-a", (judged("01-a", Fate.SURVIVED), judged("01-a", Fate.SURVIVED, 90)))
    second = OfExercise("01-b", (judged("01-b", Fate.BROKEN),))
    known, same = known_elsewhere([first, second])
    assert [(one.fate, one.by) for one in known.judged] == [
        (Fate.KILLED, "noticed in 01-b"),
        (Fate.SURVIVED, ""),
    ]
    assert same == second


def test_what_a_survivor_asks_for() -> None:
    every = Mutation((OfExercise("01-a", (judged("01-a", Fate.SURVIVED), judged("01-a", Fate.KILLED, 9))),))
    [finding] = findings(every)
    assert (finding.line, finding.exercise) == (3, "01-a")
    assert finding.what == "no mistake notices `not` removed: `if not a:` → `if a:`"
    assert finding.next_step == "no mistake of `a` or `b` depends on this `not`: add one, or remove it"
