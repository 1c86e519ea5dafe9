"""`watch`: check at every save, in a terminal that shows the lesson and what came of it."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from course.cli.arguments import CurrentExercise
from course.cli.words import examples, typed

if TYPE_CHECKING:
    from course.cli.desk import Desk
    from course.content import Exercise
    from course.grading.result import Result
    from course.watch.model import Begun, HintText, LessonText, Listing, TaskText

EXAMPLES = examples(
    ("watch", "begin, or go on where you left off"),
    ("watch 18-publisher", "at this exercise"),
)


def watch(
    ctx: typer.Context,
    exercise: CurrentExercise = None,
    namespaces: Annotated[bool, typer.Option("--namespaces/--no-namespaces", help="As with `check`.")] = True,
) -> None:
    """Check at every save, and show what came of it.

    Leave it open in a terminal beside your editor. A save during a check
    begins it anew. Keys: n goes to the next exercise when this one is passed,
    h gives a hint, t shows the task or the lesson, r the last result, l lists
    all exercises, c checks now, q leaves. Your files are only read.
    """
    from course.cli.desk import open_desk
    from course.watch.run import watch as look_on
    from course.watch.terminal import require_terminal

    require_terminal()
    with open_desk(ctx) as desk:
        learner = AtDesk(desk)
        begun = learner.begin(desk.course.exercise(exercise)) if exercise else learner.next()
        if begun is None:
            _all_passed()
            return
        ended_by = look_on(learner, begun, desk.course.root, typed, namespaces=namespaces)
        if not ended_by:
            _goodbye(desk)
    raise typer.Exit(128 + ended_by if ended_by else 0)


class AtDesk:
    """What the other commands do, for `watch`; see `course.watch.model.Learner`."""

    def __init__(self, desk: Desk) -> None:
        self._desk = desk

    @property
    def home(self) -> Path:
        return self._desk.home.path

    def next(self) -> Begun | None:
        from course.cli.reading import next_exercise

        chosen = next_exercise(self._desk)
        return None if chosen is None else self.begin(chosen)

    def begin(self, exercise: Exercise) -> Begun:
        from course.cli.reading import unread
        from course.home import begin
        from course.watch.model import Begun

        new = begin(self._desk.home, exercise)
        self._desk.progress.set_current(exercise.id)
        news = list(unread(self._desk, self._desk.course.lessons(exercise)))
        return Begun(exercise, new, bool(news))

    def lesson(self, exercise: Exercise) -> LessonText:
        from course.watch.model import LessonText

        return LessonText(exercise, self._desk.course.lessons(exercise))

    def task(self, begun: Begun) -> TaskText:
        from course.cli.reading import not_passed_yet, questions_of
        from course.watch.model import TaskText

        exercise = begun.exercise
        return TaskText(
            exercise,
            self.home,
            self._desk.progress.state(exercise.id),
            begun.new,
            not_passed_yet(self._desk, exercise),
            questions_of(self._desk, exercise),
        )

    def hint(self, exercise: Exercise) -> HintText:
        from course.watch.model import HintText

        total = len(exercise.hints)
        if total == 0:
            return HintText(exercise, 0, 0)
        index = self._desk.progress.next_hint(exercise.id, total)
        return HintText(exercise, index + 1, total, exercise.hints[index])

    def listing(self) -> Listing:
        from course.cli.listing import heading_of, row_of
        from course.watch.model import Listing

        chapters = self._desk.course.chapters()
        exercises = (one for chapter in chapters for one in chapter.exercises)
        rows = tuple(row_of(exercise, self._desk.progress) for exercise in exercises)
        return Listing(rows, tuple(heading_of(chapter) for chapter in chapters))

    def is_passed(self, exercise: Exercise) -> bool:
        return self._desk.is_passed(exercise.id)

    def last_result(self, exercise: Exercise) -> Result | None:
        return self._desk.progress.last_result(exercise.id)

    def remember(self, exercise: Exercise, result: Result) -> Path | None:
        from course.cli.check import remember
        from course.cli.log import save_log
        from course.grading.result import Verdict, to_json

        remember(self._desk, exercise, result)
        if result.verdict is not Verdict.OUR_ERROR:
            return None
        return save_log(f"check-{exercise.id}", to_json(result, indent=2))

    def ask(self, exercise: Exercise) -> None:
        from course.cli.check import ask_questions, has_wrong_answers

        last = self.last_result(exercise)
        again = last is not None and has_wrong_answers(exercise, last)
        ask_questions(self._desk, exercise, quiet=False, again=again)


def _all_passed() -> None:
    from course.report.console import open_console, put, put_steps

    console = open_console()
    put(console, "You have passed every exercise of this course. Well done!", "bold green")
    put(console)
    put_steps(console, [(typed("list"), "to look back"), (typed("watch ID"), "to do one of them again")])


def _goodbye(desk: Desk) -> None:
    from course.report.console import open_console, put_steps

    name = desk.progress.current() or ""
    put_steps(
        open_console(), [(typed("watch"), f"to go on with {name}"), (typed("show"), "to read its task")]
    )
