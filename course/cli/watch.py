"""`watch`: check on every save, in a terminal that shows the lesson and the results."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from course.cli.check import ask_questions, remember, wrong_answers
from course.cli.listing import heading_of, row_of
from course.cli.log import save_log
from course.cli.quiz import questions_of
from course.cli.session import (
    CourseSession,
    CurrentExercise,
    next_exercise,
    not_passed_yet,
    open_session,
    unread,
)
from course.cli.usage import examples, typed
from course.home import begin
from course.model.result import Result, Verdict, to_json
from course.report.console import open_console, put_course_passed, put_steps
from course.watch.loop import watch as look_on
from course.watch.terminal import require_terminal
from course.watch.updates import Begun, HintText, LessonText, Listing, TaskText

if TYPE_CHECKING:
    from course.content import Exercise

EXAMPLES = examples(
    ("watch", "begin, or continue where you left off"),
    ("watch 18-publisher", "start at this exercise"),
)


def watch(
    ctx: typer.Context,
    exercise: CurrentExercise = None,
    namespaces: Annotated[bool, typer.Option("--namespaces/--no-namespaces", help="As with `check`.")] = True,
) -> None:
    """Check on every save, and show the results.

    Leave it open in a terminal next to your editor. Saving during a check
    restarts it. Your files are only read.

    Keys: n goes to the next exercise when this one is passed, and h gives a
    hint. t shows the task or the lesson, r the last result, and l all
    exercises. c checks now, and q leaves.
    """
    require_terminal()
    with open_session(ctx) as session:
        learner = SessionLearner(session)
        begun = learner.begin(session.course.exercise(exercise)) if exercise else learner.next()
        if begun is None:
            _all_passed()
            return
        ended_by = look_on(learner, begun, session.course.root, typed, namespaces=namespaces)
        if not ended_by:
            _goodbye(session)
    raise typer.Exit(128 + ended_by if ended_by else 0)


class SessionLearner:
    """What the other commands do, for `watch`; see `course.watch.updates.Learner`."""

    def __init__(self, session: CourseSession) -> None:
        self._session = session

    @property
    def home(self) -> Path:
        return self._session.home.path

    def next(self) -> Begun | None:
        chosen = next_exercise(self._session)
        return None if chosen is None else self.begin(chosen)

    def begin(self, exercise: Exercise) -> Begun:
        new = begin(self._session.home, exercise)
        self._session.progress.set_current(exercise.id)
        news = list(unread(self._session, self._session.course.lessons(exercise)))
        return Begun(exercise, new, bool(news))

    def lesson(self, exercise: Exercise) -> LessonText:
        return LessonText(exercise, self._session.course.lessons(exercise))

    def task(self, begun: Begun) -> TaskText:
        exercise = begun.exercise
        return TaskText(
            exercise,
            self.home,
            self._session.progress.state(exercise.id),
            begun.new,
            not_passed_yet(self._session, exercise),
            questions_of(self._session, exercise),
        )

    def hint(self, exercise: Exercise) -> HintText:
        total = len(exercise.hints)
        if total == 0:
            return HintText(exercise, 0, 0)
        index = self._session.progress.next_hint(exercise.id, total)
        return HintText(exercise, index + 1, total, exercise.hints[index])

    def listing(self) -> Listing:
        chapters = self._session.course.chapters()
        exercises = (one for chapter in chapters for one in chapter.exercises)
        rows = tuple(row_of(exercise, self._session.progress) for exercise in exercises)
        return Listing(rows, tuple(heading_of(chapter) for chapter in chapters))

    def is_passed(self, exercise: Exercise) -> bool:
        return self._session.is_passed(exercise.id)

    def last_result(self, exercise: Exercise) -> Result | None:
        return self._session.progress.last_result(exercise.id)

    def remember(self, exercise: Exercise, result: Result) -> Path | None:
        remember(self._session, exercise, result)
        if result.verdict is not Verdict.OUR_ERROR:
            return None
        return save_log(f"check-{exercise.id}", to_json(result, indent=2))

    def ask(self, exercise: Exercise) -> None:
        last = self.last_result(exercise)
        again = last is not None and wrong_answers(exercise, last) > 0
        ask_questions(self._session, exercise, quiet=False, again=again)


def _all_passed() -> None:
    console = open_console()
    put_course_passed(console)
    put_steps(console, [(typed("list"), "to look back"), (typed("watch ID"), "to do one of them again")])


def _goodbye(session: CourseSession) -> None:
    name = session.progress.current() or ""
    put_steps(
        open_console(), [(typed("watch"), f"to go on with {name}"), (typed("show"), "to read its task")]
    )
