"""What `validate --mutate` does with a course's graders, and shows of it."""

from __future__ import annotations

import os
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from course.cli.ending import ended_cleanly
from course.errors import ExitCode

if TYPE_CHECKING:
    from course.content import Course, Exercise
    from course.report.validation.mutants import MutantsRow, Survivor
    from course.validate.mutation.model import Judged, Mutation, OfExercise, Step


def mutate_exercises(course: Course, exercises: Sequence[Exercise], jobs: int | None) -> ExitCode:
    """Weaken their graders, and show which changes no mistake notices."""
    mutation = _mutated(course, exercises, jobs)
    _show(mutation)
    _hand_over(mutation)
    return ExitCode.PASSED if mutation.sound else ExitCode.NOT_PASSED


def _mutated(course: Course, exercises: Sequence[Exercise], jobs: int | None) -> Mutation:
    from course.report.console import error_console
    from course.report.tally import Tally, progress
    from course.validate.mutation.run import mutate

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
    """Where there is no bar: survivors as they come, and how each part ended."""
    from course.validate.mutation.model import Fate

    if step.judged and step.judged.fate is Fate.SURVIVED:
        mutant = step.judged.mutant
        return f"{mutant.file.name}:{mutant.line} survived, {mutant.change.operator.value}"
    return f"{step.exercise}: {step.stage}" if step.done == step.total else None


def _show(mutation: Mutation) -> None:
    from course.report.console import open_console
    from course.report.validation.mutants import render_mutants

    survivors = [_survivor(one) for exercise in mutation.exercises for one in exercise.survivors]
    render_mutants(open_console(), [_row(one) for one in mutation.exercises], survivors)


def _row(one: OfExercise) -> MutantsRow:
    from course.report.validation.mutants import MutantsRow
    from course.validate.mutation.model import Fate

    return MutantsRow(
        exercise=one.exercise,
        killed=one.count(Fate.KILLED),
        broken=one.count(Fate.BROKEN),
        endless=one.count(Fate.ENDLESS),
        survived=one.count(Fate.SURVIVED),
        recorded=one.recorded,
        kept=one.kept,
        recording=one.recording,
        judging=one.judging,
        problems=one.problems,
    )


def _survivor(one: Judged) -> Survivor:
    from course.report.validation.mutants import Survivor
    from course.validate.mutation.suggest import suggestion

    mutant = one.mutant
    return Survivor(
        file=_shown(mutant.file, Path.cwd()),
        line=mutant.line,
        exercise=mutant.exercise,
        checks=mutant.checks,
        what=mutant.change.operator.value,
        before=mutant.before,
        after=mutant.after,
        next_step=suggestion(mutant),
    )


def _hand_over(mutation: Mutation) -> None:
    """To a step of GitHub Actions: survivors on the grader's lines."""
    from course.report.validation.machine import annotated
    from course.report.validation.model import Note
    from course.validate.mutation.suggest import findings

    if os.environ.get("GITHUB_ACTIONS") != "true":
        return
    root = Path(os.environ.get("GITHUB_WORKSPACE") or Path.cwd())
    notes = [
        Note(_shown(one.file, root), one.line, one.what, one.next_step, one.exercise)
        for one in findings(mutation)
    ]
    for line in annotated(notes):
        print(line)


def _shown(file: Path, base: Path) -> str:
    return str(file.relative_to(base) if file.is_relative_to(base) else file)
