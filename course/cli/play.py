"""`play`: the nodes of a mystery, running for the learner to explore."""

from __future__ import annotations

from contextlib import ExitStack, suppress
from typing import TYPE_CHECKING

import typer

from course.arena.mystery_module import MysteryJob, log_file, seed_for
from course.arena.mystery_nodes import mystery_nodes, only_once
from course.cli.session import CourseSession, CurrentExercise, open_session
from course.cli.usage import examples, typed
from course.errors import UsageError
from course.grading.reference import play_environment
from course.home import CourseHome, begin
from course.home.storage import storing
from course.report.activity import activity
from course.report.console import error_console, open_console, put, put_prose, put_steps
from course.report.exercise_text import render_new_files
from course.rosenv import find_ros

if TYPE_CHECKING:
    from course.content import Exercise

EXAMPLES = examples(
    ("play", "your current mystery"),
    ("play 19-inspect-topics", "another one"),
)


def play(ctx: typer.Context, exercise: CurrentExercise = None) -> None:
    """Start the nodes of a mystery, for you to explore.

    They run until you press Ctrl+C here. Look at them from another terminal with
    the ROS tools. The mystery is different for each learner.
    """
    with open_session(ctx) as session:
        chosen = session.exercise(exercise)
        if chosen.play is None:
            raise _no_mystery(session, chosen)
        session.progress.set_current(chosen.id)
        home = session.home
    _lay_files(chosen, home)
    _play(chosen, home)


def _lay_files(exercise: Exercise, home: CourseHome) -> None:
    """Put the exercise's files in place, as `next` does, for learners who play first."""
    render_new_files(open_console(), home.path, begin(home, exercise))


def _play(exercise: Exercise, home: CourseHome) -> None:
    assert exercise.play is not None
    log = log_file(home.state, exercise.id)
    job = MysteryJob(str(exercise.play), exercise.id, seed_for(exercise.id, home.seed()), str(log))
    with storing(f"{exercise.id} cannot be played"), ExitStack() as stack:
        lock = stack.enter_context(only_once(home.state / "play" / f"{exercise.id}.lock", exercise.id))
        with activity(error_console(), f"starting {exercise.id}") as say:
            environment = play_environment(exercise, find_ros(), stack, on_progress=say)
            nodes = stack.enter_context(mystery_nodes(job, environment, lock))
        with suppress(KeyboardInterrupt):  # from the moment it says how to end it
            _tell(exercise)
            nodes.wait()
    put(open_console(), "\nThe nodes have ended.")


def _tell(exercise: Exercise) -> None:
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


def _no_mystery(session: CourseSession, exercise: Exercise) -> Exception:
    others = [one.id for one in session.course.readable_exercises() if one.play is not None]
    advice = f"You can play: {', '.join(others)}." if others else "This course has no mysteries."
    return UsageError(f"{exercise.id} has nothing to play.", advice)
