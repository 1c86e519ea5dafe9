"""`check`: run what the learner wrote, and say what is right and what is not."""

from __future__ import annotations

import sys
from typing import Annotated

import typer

from course.cli.evidence import recorded, recording_file
from course.cli.log import save_log
from course.cli.options import options_of
from course.cli.quiz import Asking, keep_first_answers, left_open, questions_of
from course.cli.session import CourseSession, CurrentExercise, open_session
from course.cli.signals import ended_cleanly
from course.cli.usage import examples, typed
from course.content import Exercise, answers_file
from course.errors import ExitCode, UsageError
from course.grading.check import Request, check_exercise
from course.grading.load import runs_programs
from course.grading.supervisor import ForkServer
from course.model.result import Doubt, Result, Verdict, to_json
from course.report.activity import activity
from course.report.console import error_console, open_console, put, put_prose, put_steps
from course.report.exercise_text import render_after
from course.report.pictures.recording_text import belongs, render_pictures
from course.report.problem import render_our_fault
from course.report.verdict import render_result, render_so_far
from course.rosenv import find_ros

EXAMPLES = examples(
    ("check", "check your current exercise"),
    ("check 18-publisher", "check another one"),
    ("check --timeline", "and draw what happened"),
    ("check --again", "try the wrong answers of a quiz again"),
    ("check --json", "the result for a program to read"),
)


def check(
    ctx: typer.Context,
    exercise: CurrentExercise = None,
    json: Annotated[bool, typer.Option("--json", help="Print the result as JSON, and nothing else.")] = False,
    namespaces: Annotated[
        bool,
        typer.Option(
            "--namespaces/--no-namespaces",
            help="Keep your nodes apart from others: with kernel namespaces, or with a separate ROS "
            "domain where there are none.",
        ),
    ] = True,
    again: Annotated[
        bool,
        typer.Option(
            "--again", help="Ask only what you got wrong or left open; if all is right, ask everything."
        ),
    ] = False,
    timeline: Annotated[
        bool,
        typer.Option("--timeline", help="Draw what happened: a timeline, signals, and who talks to whom."),
    ] = False,
) -> None:
    """Build and run what you wrote, and judge what it does.

    A quiz asks its questions first; a second try earns half the points. Your
    files are not changed. The exit code is 0 if the exercise is passed, 1 if it
    is not, 3 if the course itself has an error, and 4 if this machine lacks
    something.
    """
    if json and timeline:
        raise UsageError("--json prints the result and nothing else.", "Leave out --timeline or --json.")
    with open_session(ctx) as session:
        chosen = session.exercise(exercise)
        early = options_of(ctx).fork_server
        runs = runs_programs(chosen)
        if early is not None and not runs:
            early.close()  # nothing is recorded for a quiz
        ask_questions(session, chosen, quiet=json, again=again)
        result = _judged(session, chosen, early, runs=runs, quiet=json, namespaces=namespaces)
        previous = session.progress.last_result(chosen.id)
        if json:
            _print_json(result)
        else:
            _render(result, chosen, previous)
        if timeline:
            _draw(session, chosen, result)
        remember(session, chosen, result)
        if not json:
            _next_steps(session, chosen, result)
    raise typer.Exit(exit_code(result))


def exit_code(result: Result) -> ExitCode:
    """The exit code of `check`, on which scripts rely."""
    return {
        Verdict.PASSED: ExitCode.PASSED,
        Verdict.NOT_PASSED: ExitCode.NOT_PASSED,
        Verdict.NOT_APPLICABLE: ExitCode.MISSING_HERE,
        Verdict.NOT_AVAILABLE: ExitCode.MISSING_HERE,
        Verdict.OUR_ERROR: ExitCode.OUR_FAULT,
    }[result.verdict]


def ask_questions(session: CourseSession, exercise: Exercise, *, quiet: bool, again: bool) -> None:
    """Ask the open questions, but only if a person is at the terminal."""
    at_terminal = sys.stdin.isatty() and sys.stdout.isatty() and not quiet
    if again and not (exercise.questions and at_terminal):
        raise _cannot_ask(exercise)
    if exercise.questions and at_terminal:
        questions = questions_of(session, exercise)
        Asking(open_console(), session.home, exercise, questions).run(again=again)


def _cannot_ask(exercise: Exercise) -> UsageError:
    if not exercise.questions:
        return UsageError(f"{exercise.id} has no questions that can be asked again.")
    advice = f"Answer in a terminal, or change {answers_file(exercise.id)} in your course home."
    return UsageError("Questions can only be asked in a terminal.", advice)


def _judged(
    session: CourseSession,
    exercise: Exercise,
    fork_server: ForkServer | None,
    *,
    runs: bool,
    quiet: bool,
    namespaces: bool,
) -> Result:
    console = error_console()
    certain: list[Result] = []

    def so_far(result: Result) -> None:
        certain.append(result)
        if not quiet:
            render_so_far(console, result)

    try:
        with ended_cleanly(), activity(console, f"checking {exercise.id}", quiet=quiet) as say:
            request = Request(
                exercise,
                session.home.path,
                ros=find_ros() if runs else None,
                on_progress=say,
                namespaces=namespaces,
                evidence=recording_file(session.home, exercise.id),
                seed=session.home.seed() if exercise.questions or exercise.play else None,
                so_far=so_far,
            )
            return check_exercise(request, fork_server)
    except KeyboardInterrupt:
        if certain:
            remember(session, exercise, certain[-1])
        put(console, f"Stopped. {'The result so far counts' if certain else 'This attempt does not count'}.")
        raise


def _print_json(result: Result) -> None:
    print(to_json(result, indent=2))


def _render(result: Result, exercise: Exercise, previous: Result | None) -> None:
    console = open_console()
    render_result(console, result, exercise, previous)
    if result.verdict is Verdict.OUR_ERROR and result.doubt is not Doubt.BUSY:
        render_our_fault(console, save_log(f"check-{exercise.id}", to_json(result, indent=2)))
    if result.verdict is Verdict.PASSED and exercise.after:
        render_after(console, exercise.after)


def _draw(session: CourseSession, exercise: Exercise, result: Result) -> None:
    found = recorded(session.home, exercise.id)
    console = open_console()
    put(console)
    if found and belongs(result, found.recording):
        render_pictures(console, found.recording, result)
    else:
        put_prose(console, "There is nothing to draw: this check has no recording.")


def remember(session: CourseSession, exercise: Exercise, result: Result) -> None:
    session.progress.record(result)
    if exercise.questions and result.verdict in (Verdict.PASSED, Verdict.NOT_PASSED):
        keep_first_answers(session.home, exercise, questions_of(session, exercise))
    if session.progress.current() is None or not session.is_passed(exercise.id):
        session.progress.set_current(exercise.id)


def _next_steps(session: CourseSession, exercise: Exercise, result: Result) -> None:
    console = open_console()
    put(console)
    put_steps(console, _steps(session, exercise, result))


def _steps(session: CourseSession, exercise: Exercise, result: Result) -> list[tuple[str, str]]:
    name = "" if session.progress.current() == exercise.id else f" {exercise.id}"
    if result.verdict is Verdict.PASSED:
        compare = (typed(f"solution{name}"), "to compare yours with ours")
        return [(typed("next"), "for the next exercise"), compare]
    again = (typed(f"check{name}"), "to check again")
    if result.verdict is not Verdict.NOT_PASSED:
        return [(typed("doctor"), "to see what this machine has"), again]
    if (wrong := wrong_answers(exercise, result)) and wrong == left_open(session.home, exercise):
        again = (typed(f"check{name}"), "to answer what you left open")
    elif wrong:
        again = (typed(f"check{name} --again"), "to try the wrong answers again, for half the points")
    if session.progress.hints_shown(exercise.id) < len(exercise.hints):
        return [(typed(f"hint{name}"), "for a hint"), again]
    if not exercise.hints:
        return [again]
    return [(typed(f"hint{name} --all"), "to read the hints again"), again]


def wrong_answers(exercise: Exercise, result: Result) -> int:
    """How many answers are wrong or missing; checks of a grader do not count."""
    asked = {question.id for question in exercise.questions}
    return sum(check.id in asked and not check.earned for check in result.checks)
