"""`check`: run what the learner wrote, and say what is right and what is not."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING, Annotated

import typer

from course.cli.arguments import CurrentExercise
from course.cli.ending import ended_cleanly
from course.cli.words import examples, typed
from course.errors import ExitCode, UsageError

if TYPE_CHECKING:
    from course.cli.desk import Desk
    from course.content import Exercise
    from course.grading.result import Result

EXAMPLES = examples(
    ("check", "check the exercise you are at"),
    ("check 18-publisher", "check another one"),
    ("check --timeline", "and draw what happened"),
    ("check --again", "answer anew what is not right in a quiz"),
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
            help="Keep your nodes apart from others by namespaces of the kernel, "
            "where there are any; else by a ROS domain of their own.",
        ),
    ] = True,
    again: Annotated[
        bool,
        typer.Option("--again", help="Ask again what is not right or not answered; all if all is right."),
    ] = False,
    timeline: Annotated[
        bool,
        typer.Option("--timeline", help="Draw what happened: on a time line, signals, who talks to whom."),
    ] = False,
) -> None:
    """Build and run what you wrote, and judge what it does.

    A quiz asks its questions first. Your files are only read. Ends with 0 when
    the exercise is passed, 1 when it is not, 3 when the course itself has a
    fault, 4 when this machine lacks something.
    """
    from course.cli.desk import open_desk

    if json and timeline:
        raise UsageError("--json prints the result and nothing else.", "Leave --timeline out, or --json.")
    with open_desk(ctx) as desk:
        chosen = desk.exercise(exercise)
        ask_questions(desk, chosen, quiet=json, again=again)
        result = _judged(desk, chosen, quiet=json, namespaces=namespaces)
        previous = desk.progress.last_result(chosen.id)
        if json:
            _print_json(result)
        else:
            _render(result, chosen, previous)
        if timeline:
            _draw(desk, chosen, result)
        remember(desk, chosen, result)
        if not json:
            _next_steps(desk, chosen, result)
    raise typer.Exit(exit_code(result))


def exit_code(result: Result) -> ExitCode:
    """What `check` ends with, as scripts rely on it."""
    from course.grading.result import Verdict

    return {
        Verdict.PASSED: ExitCode.PASSED,
        Verdict.NOT_PASSED: ExitCode.NOT_PASSED,
        Verdict.NOT_APPLICABLE: ExitCode.MISSING_HERE,
        Verdict.NOT_AVAILABLE: ExitCode.MISSING_HERE,
        Verdict.OUR_ERROR: ExitCode.OUR_FAULT,
    }[result.verdict]


def ask_questions(desk: Desk, exercise: Exercise, *, quiet: bool, again: bool) -> None:
    """Ask what is to be answered; only a person at a terminal is asked."""
    at_terminal = sys.stdin.isatty() and sys.stdout.isatty() and not quiet
    if again and not (exercise.questions and at_terminal):
        raise _cannot_ask(exercise)
    if exercise.questions and at_terminal:
        from course.cli.ask import Asking
        from course.grading.mystery.load import questions_for
        from course.grading.quiz.order import as_seen
        from course.report.console import open_console

        seed = desk.home.seed()
        questions = as_seen(questions_for(exercise, seed), exercise.id, seed)
        Asking(open_console(), desk.home, exercise, questions).run(again=again)


def _cannot_ask(exercise: Exercise) -> UsageError:
    from course.content import answers_file

    if not exercise.questions:
        return UsageError(f"{exercise.id} has no questions that could be asked again.")
    advice = f"Answer in a terminal, or change {answers_file(exercise.id)} in your course home."
    return UsageError("Questions can only be asked in a terminal.", advice)


def _judged(desk: Desk, exercise: Exercise, *, quiet: bool, namespaces: bool) -> Result:
    from course.cli.recorded import recording_file
    from course.grading.check import check_exercise
    from course.grading.load import runs_programs
    from course.report.activity import activity
    from course.report.console import error_console, put
    from course.rosenv import find_ros

    console = error_console()
    try:
        with ended_cleanly(), activity(console, f"checking {exercise.id}", quiet=quiet) as say:
            return check_exercise(
                exercise,
                desk.home.path,
                ros=find_ros() if runs_programs(exercise) else None,
                on_progress=say,
                namespaces=namespaces,
                evidence=recording_file(desk.home, exercise.id),
                seed=desk.home.seed() if exercise.questions or exercise.play else None,
            )
    except KeyboardInterrupt:
        put(console, "Stopped. This attempt does not count.")
        raise


def _print_json(result: Result) -> None:
    from course.grading.result import to_json

    print(to_json(result, indent=2))


def _render(result: Result, exercise: Exercise, previous: Result | None) -> None:
    from course.grading.result import Verdict, to_json
    from course.report.console import open_console
    from course.report.lesson import render_after
    from course.report.problem import render_our_fault
    from course.report.terminal import render_result

    console = open_console()
    render_result(console, result, exercise, previous)
    if result.verdict is Verdict.OUR_ERROR:
        from course.cli.log import save_log

        render_our_fault(console, save_log(f"check-{exercise.id}", to_json(result, indent=2)))
    if result.verdict is Verdict.PASSED and exercise.after:
        render_after(console, exercise.after)


def _draw(desk: Desk, exercise: Exercise, result: Result) -> None:
    from course.cli.recorded import recorded
    from course.report.console import open_console, put, put_prose
    from course.report.drawn.album import belongs, render_pictures

    found = recorded(desk.home, exercise.id)
    console = open_console()
    put(console)
    if found and belongs(result, found.recording):
        render_pictures(console, found.recording, result)
    else:
        put_prose(console, "There is nothing to draw: this check has no recording.")


def remember(desk: Desk, exercise: Exercise, result: Result) -> None:
    desk.progress.record(result)
    if desk.progress.current() is None or not desk.is_passed(exercise.id):
        desk.progress.set_current(exercise.id)


def _next_steps(desk: Desk, exercise: Exercise, result: Result) -> None:
    from course.report.console import open_console, put, put_steps

    console = open_console()
    put(console)
    put_steps(console, _steps(desk, exercise, result))


def _steps(desk: Desk, exercise: Exercise, result: Result) -> list[tuple[str, str]]:
    from course.grading.result import Verdict

    name = "" if desk.progress.current() == exercise.id else f" {exercise.id}"
    if result.verdict is Verdict.PASSED:
        compare = (typed(f"solution{name}"), "to compare yours with ours")
        return [(typed("next"), "for the next exercise"), compare]
    again = (typed(f"check{name}"), "to check again")
    if result.verdict is not Verdict.NOT_PASSED:
        return [(typed("doctor"), "to see what this machine has"), again]
    if has_wrong_answers(exercise, result):
        again = (typed(f"check{name} --again"), "to answer again what is not right yet")
    if desk.progress.hints_shown(exercise.id) < len(exercise.hints):
        return [(typed(f"hint{name}"), "for a hint"), again]
    if not exercise.hints:
        return [again]
    return [(typed(f"hint{name} --all"), "to read the hints again"), again]


def has_wrong_answers(exercise: Exercise, result: Result) -> bool:
    """Whether it is answers that are not right, and not only what a grader checks beside them."""
    asked = {question.id for question in exercise.questions}
    return any(check.id in asked and not check.earned for check in result.checks)
