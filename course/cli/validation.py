"""What `validate` does with a course, and shows of it."""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from datetime import datetime, timezone
from pathlib import Path
from typing import TYPE_CHECKING

from course.cli.ending import ended_cleanly
from course.errors import ContentError, ExitCode

if TYPE_CHECKING:
    from course.content import Course, Exercise
    from course.report.validation.model import Case, Count, Note, Row
    from course.validate.account import Account, Counts, Summary
    from course.validate.model import Finding
    from course.validate.plan import Proof

_LINES_EVERY = 50  # proofs, where there is no bar


@dataclass(frozen=True)
class Asked:
    """What the command line asks for. wanted: ids or numbers of chapters; all exercises if there are none."""

    wanted: Sequence[str] = ()
    jobs: int | None = None
    repeat: int = 1
    junit: Path | None = None
    static: bool = False


@dataclass(frozen=True)
class Seen:
    """What is known: of the files, and of the proofs as far as they were run."""

    written: Sequence[Finding]
    account: Account | None = None
    proofs: Sequence[Proof] = ()
    began: datetime = field(default_factory=lambda: datetime.now(timezone.utc))

    @property
    def findings(self) -> list[Finding]:
        return [*self.written, *(self.account.findings() if self.account else ())]


def validate_course(course: Course, asked: Asked) -> ExitCode:
    """Look, run, show. KeyboardInterrupt passes through after all that is known was shown."""
    try:
        exercises = chosen(course, asked.wanted)
        seen = Seen(_written(course, exercises))
        account, proofs = (None, ()) if asked.static else _planned(course, exercises, asked.repeat)
    except ContentError:  # some file cannot be used at all: all of its kind are told, not the first one only
        return _shown(Seen(_written(course, tuple(course.readable_exercises()))), asked)
    seen = Seen(seen.written, account, proofs, seen.began)
    if account is None:
        return _shown(seen, asked)
    try:
        with ended_cleanly() as again:
            _run(course, exercises, seen, asked, again)
    except KeyboardInterrupt:
        _shown(seen, asked, stopped=True)
        raise
    return _shown(seen, asked)


def mutate_graders(course: Course, wanted: Sequence[str], jobs: int | None) -> ExitCode:
    """See `course.validate.mutation`."""
    from course.cli.mutation import mutate_exercises

    return mutate_exercises(course, chosen(course, wanted), jobs)


def chosen(course: Course, wanted: Sequence[str]) -> tuple[Exercise, ...]:
    """Raises UsageError for what does not exist, ContentError for what cannot be read."""
    from course.batch.plan import exercises_named

    return exercises_named(course, wanted) or course.exercises()


def _written(course: Course, exercises: Sequence[Exercise]) -> list[Finding]:
    from course.cli.typed import complaint
    from course.validate.texts import findings

    return findings(course, exercises, complaint)


def _planned(course: Course, exercises: Sequence[Exercise], turns: int) -> tuple[Account, tuple[Proof, ...]]:
    """What can be run: a chapter whose grader cannot even be loaded is told of already."""
    from course.validate.account import Account
    from course.validate.plan import gradable, proofs

    sound = gradable(exercises)
    every = proofs(sound)
    return Account(sound, every, turns), every


def _run(
    course: Course, exercises: Sequence[Exercise], seen: Seen, asked: Asked, again: Callable[[], None]
) -> None:
    from course.batch.run import default_jobs
    from course.report.console import error_console
    from course.report.tally import Tally, progress
    from course.validate.run import run

    assert seen.account is not None
    tally = Tally(len(seen.proofs) * asked.repeat)
    with progress(error_console()) as show:
        show(tally, None)
        jobs = asked.jobs or default_jobs()
        for proven in run(course.root, exercises, seen.proofs, jobs, asked.repeat):
            held = seen.account.add(proven)
            tally.count({True: "held", False: "broken", None: "not available here"}[held])
            told = held is False or tally.done % _LINES_EVERY == 0
            show(tally, str(proven.proof) if told else None)
            again()


def _shown(seen: Seen, asked: Asked, *, stopped: bool = False) -> ExitCode:
    from course.report.console import open_console
    from course.report.validation.table import render_end, render_notes, render_table

    console, rows = open_console(), _rows(seen.account)
    findings = seen.findings
    if rows:
        render_table(console, rows, again=seen.account.again if seen.account else 0)
    render_notes(console, [_note(finding, Path.cwd()) for finding in findings])
    render_end(console, len(findings), rows, stopped=stopped)
    _hand_over(seen, asked)
    if findings:
        return ExitCode.NOT_PASSED
    return ExitCode.MISSING_HERE if any(row.missing for row in rows) else ExitCode.PASSED


def _hand_over(seen: Seen, asked: Asked) -> None:
    """To those who called us: a file of JUnit, a step of GitHub Actions."""
    from course.report.gradebook.files import write
    from course.report.validation.machine import annotated, as_junit

    repository = Path(os.environ.get("GITHUB_WORKSPACE") or Path.cwd())
    if asked.junit:
        written = [_note(finding, repository) for finding in seen.written]
        write(asked.junit, as_junit("ros2course validate", seen.began, _cases(seen, repository), written))
    if os.environ.get("GITHUB_ACTIONS") == "true":
        for line in annotated([_note(finding, repository) for finding in seen.findings]):
            print(line)


def _note(finding: Finding, base: Path) -> Note:
    from course.report.validation.model import Note

    inside = finding.file.is_relative_to(base)
    file = finding.file.relative_to(base) if inside else finding.file
    return Note(str(file), finding.line, finding.what, finding.next_step, finding.exercise)


def _rows(account: Account | None) -> list[Row]:
    return [_row(summary) for summary in account.summaries()] if account else []


def _row(summary: Summary) -> Row:
    from course.report.validation.model import Row
    from course.validate.plan import Kind

    kinds = {kind: _count(counts) for kind, counts in summary.kinds.items()}
    return Row(
        summary.exercise,
        kinds[Kind.SOLUTION],
        kinds[Kind.ALTERNATIVE],
        kinds[Kind.STARTER],
        kinds[Kind.MISTAKE],
        summary.covered,
        summary.checks,
        summary.points,
        summary.seconds,
        summary.missing,
    )


def _count(counts: Counts) -> Count:
    from course.report.validation.model import Count

    return Count(counts.held, counts.done, counts.total)


def _cases(seen: Seen, repository: Path) -> list[Case]:
    from course.report.validation.model import Case

    if seen.account is None:
        return []
    found = []
    for proof in seen.proofs:
        each = seen.account.proven(proof)
        notes = [_note(finding, repository) for finding in seen.account.findings_of(proof)]
        seconds, name = sum(one.seconds for one in each), " ".join(str(proof).split()[1:])
        found.append(Case(proof.exercise, name, seconds, notes, seen.account.why_not(proof)))
    return found
