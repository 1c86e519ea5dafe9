"""`play`: the nodes of a mystery, running for the learner to explore."""

from __future__ import annotations

from typing import TYPE_CHECKING

import typer

from course.cli.arguments import CurrentExercise
from course.cli.words import examples, typed

if TYPE_CHECKING:
    from course.cli.desk import Desk
    from course.content import Exercise
    from course.home import CourseHome

EXAMPLES = examples(
    ("play", "the mystery you are at"),
    ("play 19-inspect-topics", "another one"),
)


def play(ctx: typer.Context, exercise: CurrentExercise = None) -> None:
    """Start the nodes of a mystery, for you to explore.

    They run until you press Ctrl+C here. Look at them from another terminal with
    the ROS tools. Every learner's mystery is another one.
    """
    from course.cli.desk import open_desk

    with open_desk(ctx) as desk:
        chosen = desk.exercise(exercise)
        if chosen.play is None:
            raise _no_mystery(desk, chosen)
        desk.progress.set_current(chosen.id)
        home = desk.home
    _lay_files(chosen, home)
    _play(chosen, home)


def _lay_files(exercise: Exercise, home: CourseHome) -> None:
    """As `next` does: whoever plays first has what the exercise speaks of, too."""
    from course.home import begin
    from course.report.console import open_console
    from course.report.lesson import render_new_files

    render_new_files(open_console(), home.path, begin(home, exercise))


def _play(exercise: Exercise, home: CourseHome) -> None:
    from contextlib import ExitStack, suppress

    from course.arena.acts import acts_file
    from course.arena.play import Playing, job_line, only_once
    from course.arena.play_module import seed_for
    from course.grading.playing import play_environment
    from course.home.storage import storing
    from course.report.activity import activity
    from course.report.console import error_console, open_console, put
    from course.rosenv import find_ros

    assert exercise.play is not None
    acts = acts_file(home.state, exercise.id)
    job = job_line(exercise.play, exercise.id, seed_for(exercise.id, home.seed()), acts)
    with storing(f"{exercise.id} cannot be played"), ExitStack() as stack:
        lock = stack.enter_context(only_once(home.state / "play" / f"{exercise.id}.lock", exercise.id))
        with activity(error_console(), f"starting {exercise.id}") as say:
            environment = play_environment(exercise, find_ros(), on_progress=say)
            playing = stack.enter_context(Playing(job, environment, lock))
        with suppress(KeyboardInterrupt):  # from the moment that it says how to end it
            _tell(exercise)
            playing.wait()
    put(open_console(), "\nThe nodes have ended.")


def _tell(exercise: Exercise) -> None:
    from course.report.console import open_console, put, put_prose, put_steps

    console = open_console()
    put(console, f"{exercise.id} is running. Ctrl+C ends it.", "bold")
    put_prose(console, exercise.summary)
    put(console)
    put(console, "Leave it running, and open another terminal for the rest.")
    steps = [
        (typed("shell"), "for a shell with ROS 2 ready, to explore in"),
        (typed(f"check {exercise.id}"), "to answer the questions"),
    ]
    put_steps(console, steps)


def _no_mystery(desk: Desk, exercise: Exercise) -> Exception:
    from course.errors import UsageError

    others = [one.id for one in desk.course.readable_exercises() if one.play is not None]
    advice = f"These have: {', '.join(others)}." if others else "No exercise of this course has."
    return UsageError(f"{exercise.id} has nothing to play.", advice)
