"""`validate --mutate`: weakens a course's graders, and shows the result."""

from __future__ import annotations

import os
from collections.abc import Sequence
from pathlib import Path

from course.cli.signals import ended_cleanly
from course.content import Course, Exercise
from course.errors import ExitCode
from course.report.activity import Tally, progress
from course.report.console import error_console, open_console
from course.report.validation import Note, annotated
from course_mutation.model import Fate, Mutation, Step
from course_mutation.mutants import findings
from course_mutation.report import render_mutation, shown
from course_mutation.run import mutate


def mutate_exercises(course: Course, exercises: Sequence[Exercise], jobs: int | None) -> ExitCode:
    """Weaken their graders, and show which changes no mistake notices."""
    mutation = _mutated(course, exercises, jobs)
    render_mutation(open_console(), mutation)
    if os.environ.get("GITHUB_ACTIONS") == "true":
        for line in annotated(_notes(mutation)):
            print(line)
    return ExitCode.PASSED if mutation.sound else ExitCode.NOT_PASSED


def _mutated(course: Course, exercises: Sequence[Exercise], jobs: int | None) -> Mutation:
    with ended_cleanly() as again, progress(error_console()) as show:
        tally = Tally(0)

        def told(step: Step) -> None:
            nonlocal tally
            if step.done == 0:
                tally = Tally(step.total)
                show(tally, f"{step.exercise}: {step.stage}")
            else:
                tally.count(step.judged.fate.value if step.judged else "recorded")
                show(tally, _line(step))
            again()

        return mutate(course, exercises, jobs=jobs, on_progress=told)


def _line(step: Step) -> str | None:
    """Without a progress bar: survivors as they appear, and how each part ended."""
    if step.judged and step.judged.fate is Fate.SURVIVED:
        mutant = step.judged.mutant
        return f"{mutant.file.name}:{mutant.line} survived, {mutant.change.operator.value}"
    return f"{step.exercise}: {step.stage}" if step.done == step.total else None


def _notes(mutation: Mutation) -> list[Note]:
    """For GitHub Actions: survivors at the grader's lines."""
    root = Path(os.environ.get("GITHUB_WORKSPACE") or Path.cwd())
    return [
        Note(shown(finding.file, root), finding.line, finding.what, finding.next_step, finding.exercise)
        for finding in findings(mutation)
    ]
