"""`validate`: prove that a course does what it claims."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from datetime import datetime, timezone
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer
from typer.exceptions import TyperException

from course.batch.batch_plan import exercises_named
from course.batch.run import default_jobs
from course.cli.app import app
from course.cli.extras import extra
from course.cli.options import options_of
from course.cli.session import GradingJobs, complete_exercise, course_of
from course.cli.signals import ended_cleanly
from course.cli.usage import examples
from course.errors import ContentError, ExitCode, UsageError
from course.files import write_pieces
from course.report.activity import Tally, progress
from course.report.console import error_console, open_console
from course.report.validation import (
    Note,
    ProofCase,
    annotated,
    as_junit,
    render_end,
    render_notes,
    render_table,
)
from course.spelling import did_you_mean
from course.validate.proof_results import ProofResults
from course.validate.proofs import Proof, gradable, proofs
from course.validate.schedule import run
from course.validate.static.rules import findings

if TYPE_CHECKING:
    from course.content import Course, Exercise
    from course.validate import Finding


_LINES_EVERY = 50  # proofs for each line, where there is no progress bar


@dataclass(frozen=True)
class ProofRequest:
    """What the command line asks for. wanted: ids or numbers of chapters; all exercises if there are none."""

    wanted: Sequence[str] = ()
    jobs: int | None = None
    repeat: int = 1
    junit: Path | None = None
    static: bool = False


@dataclass(frozen=True)
class Seen:
    """What is known so far about the files, and about the proofs."""

    written: Sequence[Finding]
    account: ProofResults | None = None
    proofs: Sequence[Proof] = ()
    began: datetime = field(default_factory=lambda: datetime.now(timezone.utc))

    @property
    def findings(self) -> list[Finding]:
        return [*self.written, *(self.account.findings() if self.account else ())]


def validate_course(course: Course, asked: ProofRequest) -> ExitCode:
    """Read, run and show. KeyboardInterrupt passes through after the findings so far were shown."""
    try:
        exercises = chosen(course, asked.wanted)
        seen = Seen(_written(course, exercises))
        account, proofs = (None, ()) if asked.static else _planned(course, exercises, asked.repeat)
    except ContentError:  # a file cannot be used at all: report all such files, not only the first one
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
    """Weaken the graders, and show which changes no mistake notices."""
    code: ExitCode = extra("mutation").mutate_exercises(course, chosen(course, wanted), jobs)
    return code


def chosen(course: Course, wanted: Sequence[str]) -> tuple[Exercise, ...]:
    """Raises UsageError for what does not exist, ContentError for what cannot be read."""
    return exercises_named(course, wanted) or course.exercises()


def _written(course: Course, exercises: Sequence[Exercise]) -> list[Finding]:
    return findings(course, exercises, complaint)


def _planned(
    course: Course, exercises: Sequence[Exercise], turns: int
) -> tuple[ProofResults, tuple[Proof, ...]]:
    """The proofs that can be run; reports chapters whose graders cannot be loaded."""
    sound = gradable(exercises)
    every = proofs(sound)
    return ProofResults(sound, every, turns), every


def _run(
    course: Course, exercises: Sequence[Exercise], seen: Seen, asked: ProofRequest, again: Callable[[], None]
) -> None:
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


def _shown(seen: Seen, asked: ProofRequest, *, stopped: bool = False) -> ExitCode:
    console, rows = open_console(), seen.account.rows() if seen.account else []
    findings = seen.findings
    if rows:
        render_table(console, rows, again=seen.account.again if seen.account else 0)
    render_notes(console, [_note(finding, Path.cwd()) for finding in findings])
    render_end(console, len(findings), rows, stopped=stopped)
    _hand_over(seen, asked)
    if findings:
        return ExitCode.NOT_PASSED
    return ExitCode.MISSING_HERE if any(row.missing for row in rows) else ExitCode.PASSED


def _hand_over(seen: Seen, asked: ProofRequest) -> None:
    """Pass the findings on: to a JUnit file, or a step of GitHub Actions."""
    repository = Path(os.environ.get("GITHUB_WORKSPACE") or Path.cwd())
    if asked.junit:
        written = [_note(finding, repository) for finding in seen.written]
        report = as_junit("ros2course validate", seen.began, _cases(seen, repository), written)
        write_pieces(asked.junit, report)
    if os.environ.get("GITHUB_ACTIONS") == "true":
        for line in annotated([_note(finding, repository) for finding in seen.findings]):
            print(line)


def _note(finding: Finding, base: Path) -> Note:
    inside = finding.file.is_relative_to(base)
    file = finding.file.relative_to(base) if inside else finding.file
    return Note(str(file), finding.line, finding.what, finding.next_step, finding.exercise)


def _cases(seen: Seen, repository: Path) -> list[ProofCase]:
    if seen.account is None:
        return []
    found = []
    for proof in seen.proofs:
        each = seen.account.proven(proof)
        notes = [_note(finding, repository) for finding in seen.account.findings_of(proof)]
        seconds, name = sum(one.seconds for one in each), " ".join(str(proof).split()[1:])
        found.append(ProofCase(proof.exercise, name, seconds, notes, seen.account.why_not(proof)))
    return found


def complaint(words: Sequence[str]) -> str | None:
    """What is wrong with the words after `ros2course`, in the command line's words; None if nothing is."""
    group = _group()
    whole = group.context_class(group, info_name=group.name, **group.context_settings)
    return _said_of(group, whole, words)


def _said_of(command: Any, context: Any, words: Sequence[str]) -> str | None:
    """The same for one command, or for a group of commands."""
    said, rest = _parsed(command, context, words)
    if said or not rest:
        return said
    below: Mapping[str, Any] = getattr(command, "commands", {})
    if not below:
        return f"unexpected argument `{rest[0]}`"
    if rest[0] not in below:
        return _unknown(rest[0], list(below))
    inner = getattr(below[rest[0]], "loaded", below[rest[0]])
    return _said_of(inner, inner.context_class(inner, info_name=inner.name, parent=context), rest[1:])


@cache
def _group() -> Any:
    return typer.main.get_command(app)


def _parsed(command: Any, context: Any, words: Sequence[str]) -> tuple[str | None, list[str]]:
    """The errors in its options and arguments, and the remaining words."""
    try:
        given, rest, _order = command.make_parser(context).parse_args(list(words))
    except TyperException as error:
        return str(error), []
    missing = [one.name for one in command.params if one.required and given.get(one.name) in (None, ())]
    asks_for_help = bool(given.get("help"))
    return (f"`{missing[0]}` is missing" if missing and not asks_for_help else None), rest


def _unknown(name: str, known: Sequence[str]) -> str:
    return f"there is no command `{name}`{did_you_mean(name, known)}"


EXAMPLES = examples(
    ("validate", "the whole course"),
    ("validate 18-publisher", "one exercise, while writing it"),
    ("validate 18 --repeat 20", "a chapter, to find flaky checks"),
    ("validate --static", "only read the files, in seconds"),
    ("validate --course my-course/", "another course"),
)


def validate(
    ctx: typer.Context,
    exercises: Annotated[
        list[str] | None,
        typer.Argument(
            metavar="[ID...]",
            help="Exercises, or chapter numbers; by default, all.",
            autocompletion=complete_exercise,
            show_default=False,
        ),
    ] = None,
    static: Annotated[bool, typer.Option("--static", help="Only read the files; grade nothing.")] = False,
    jobs: GradingJobs = None,
    repeat: Annotated[
        int,
        typer.Option(
            "--repeat", metavar="K", min=1, help="Run everything K times, and report verdicts that change."
        ),
    ] = 1,
    junit: Annotated[
        Path | None, typer.Option("--junit", metavar="FILE", help="Also write JUnit XML to this file.")
    ] = None,
    mutate: Annotated[
        bool, typer.Option("--mutate", help="Weaken the graders, and report changes that no mistake reveals.")
    ] = False,
) -> None:
    """Prove that a course does what it claims.

    Reads all files, then grades what the course itself supplies. Solutions and
    alternatives must earn all points, and starters must not pass. Each known
    mistake must be caught by its check, with the expected words. The exit code
    is 0 if no problem was found, 1 if one was, and 4 if this machine cannot
    grade some exercise.
    """
    if mutate and (static or repeat > 1 or junit):
        raise UsageError("--mutate does not go with --static, --repeat, or --junit.", "Run them separately.")
    course, wanted = course_of(options_of(ctx)), exercises or []
    if mutate:
        raise typer.Exit(mutate_graders(course, wanted, jobs))
    asked = ProofRequest(wanted, jobs, repeat, junit.absolute() if junit else None, static)
    raise typer.Exit(validate_course(course, asked))
