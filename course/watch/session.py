"""What happens after a save, a key, or a message from a check. Uses no terminal and no processes."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable, Sequence
from pathlib import Path, PurePosixPath
from typing import TYPE_CHECKING

from course.content import Exercise
from course.content.layout import answers_file
from course.model import replace
from course.model.result import Result, Verdict
from course.watch import updates
from course.watch.saves import concerning
from course.watch.updates import (
    AllPassed,
    Begun,
    Checked,
    Key,
    Learner,
    Look,
    Message,
    Said,
    Saved,
    what_changed,
)

if TYPE_CHECKING:
    from course.watch.checks import Checks


class OwnFiles:
    """Remembers the files that we wrote; if one looks different later, somebody saved it."""

    def __init__(self, home: Path) -> None:
        self._home = home
        self._known: dict[str, tuple[int, int]] = {}
        self._folders: set[str] = set()

    def wrote(self, files: Iterable[str]) -> None:
        """Call after writing `files`, which are relative to the home. Missing ones are ignored."""
        for file in files:
            if (stamp := self._stamp(file)) is not None:
                self._known[file] = stamp
                self._folders.update(str(folder) for folder in Path(file).parents)

    def without(self, files: Iterable[str]) -> tuple[str, ...]:
        """The files that somebody else wrote."""
        return tuple(file for file in files if not self._is_own(file))

    def _is_own(self, file: str) -> bool:
        if file in self._folders:
            return (self._home / file).is_dir()
        return file in self._known and self._known[file] == self._stamp(file)

    def _stamp(self, file: str) -> tuple[int, int] | None:
        try:
            found = (self._home / file).lstat()
        except OSError:
            return None
        return found.st_mtime_ns, found.st_size


STARTING = "starting the check"
_ANEW = "; checking again"


class Session:
    """One run of `watch`. look: what the screen shows now. over: whether a key ended it.

    page: returns the first line of the next screenful, for a learner who wants to read on. ask: asks the
    questions of a quiz, and returns False if the learner went back.
    """

    def __init__(
        self,
        learner: Learner,
        checking: Checks,
        begun: Begun,
        page: Callable[[], int],
        ask: Callable[[Exercise], bool],
        clock: Callable[[], float] = time.monotonic,
    ) -> None:
        self._learner = learner
        self._checking = checking
        self._page = page
        self._ask = ask
        self._clock = clock
        self._own = OwnFiles(learner.home)
        self._number = 0
        self.over = False
        self.look: Look = self._opened(begun)

    def hear(self, event: updates.Event) -> None:
        """Handle any event except signals and ticks."""
        if isinstance(event, Saved):
            self._saved(event.files)
        elif isinstance(event, Key):
            self._pressed(event.name)
        elif isinstance(event, Said | updates.SoFar | Checked | updates.Stuck):
            self._told(event)

    def leave(self) -> None:
        """Call off a running check, because `watch` ends for whatever reason."""
        self._checking.stop()
        if self.look.doing:
            self.look = replace(self.look, doing="stopping the check", since=self._clock())

    # ------------------------------------------------------------------------------------------ saves

    def _saved(self, files: Sequence[str]) -> None:
        concerned = self._own.without(concerning(self.look.exercise, files))
        if not concerned:
            return
        more = f" and {len(concerned) - 1} more" if len(concerned) > 1 else ""
        again = _ANEW if self.look.doing else ""
        self._check(f"saved: {PurePosixPath(concerned[0]).name}{more}{again}")

    def _check(self, remark: str) -> None:
        self._number = self._checking.start(self.look.exercise)
        self.look = replace(self.look, doing=STARTING, since=self._clock(), remark=remark)

    # ---------------------------------------------------------------------------------- what a check says

    def _told(self, message: Message) -> None:
        if message.number != self._number or not self.look.doing:
            return  # from a check that was called off
        if isinstance(message, Said):
            self.look = replace(self.look, doing=message.text)
        elif isinstance(message, updates.SoFar):
            before = self._learner.last_result(self.look.exercise)
            body = updates.ResultText(self.look.exercise, message.result, before, None)
            self.look = replace(self.look, body=body, first=None)
        elif isinstance(message, Checked):
            self._finished(message.result)
        else:
            self._came_to(updates.ProblemText(message.what, message.next_step))

    def _finished(self, result: Result) -> None:
        exercise = self.look.exercise
        before = self._learner.last_result(exercise)
        log = self._learner.remember(exercise, result)
        counts = result.verdict in (Verdict.PASSED, Verdict.NOT_PASSED)
        change = what_changed(before, result) if counts else None
        self.look = replace(self.look, result=result, change=change)
        self._came_to(updates.ResultText(exercise, result, before, change, log))

    def _came_to(self, body: updates.Body) -> None:
        remark = self.look.remark.removesuffix(_ANEW)
        self.look = replace(self.look, doing="", body=body, remark=remark, first=None)

    # ------------------------------------------------------------------------------------------- keys

    def _pressed(self, key: str) -> None:
        actions: dict[str, Callable[[], None]] = {
            "n": self._go_on,
            "h": lambda: self._show(self._learner.hint(self.look.exercise)),
            "l": lambda: self._show(self._learner.listing()),
            "t": self._turn_text,
            "r": self._show_result,
            "c": self._check_now,
            " ": self._read_on,
            "q": self._quit,
        }
        action = actions.get(key.lower())
        if action is not None:
            action()

    def _go_on(self) -> None:
        """Like `next`: go to the next exercise, but only if this one is passed, so that none is skipped."""
        exercise = self.look.exercise
        if not self._learner.is_passed(exercise):
            self.look = replace(self.look, remark=f"{exercise.id} is not passed yet; n goes on when it is.")
            return
        self._checking.stop()
        begun = self._learner.next()
        if begun is None:
            self.look = replace(self.look, doing="", body=AllPassed(), remark="", first=None)
        else:
            self.look = self._opened(begun)

    def _turn_text(self) -> None:
        """Show the task or, if the task is already shown, the lesson."""
        exercise = self.look.exercise
        if isinstance(self.look.body, updates.TaskText):
            self._show(self._learner.lesson(exercise))
        else:
            self._show(self._learner.task(Begun(exercise)))

    def _show_result(self) -> None:
        look = self.look
        if look.result is None:
            self.look = replace(look, remark="It has not been checked yet: save a file, or press c.")
        else:
            self._show(updates.ResultText(look.exercise, look.result, None, look.change))

    def _check_now(self) -> None:
        exercise = self.look.exercise
        wanted = self._ask(exercise) if exercise.questions else True
        self._own.wrote([answers_file(exercise.id)])  # these new answers are not a save
        if wanted:
            self._check("")

    def _read_on(self) -> None:
        self.look = replace(self.look, first=self._page())

    def _quit(self) -> None:
        self.over = True

    def _show(self, body: updates.Body) -> None:
        self.look = replace(self.look, body=body, remark="", first=None)

    def _opened(self, begun: Begun) -> Look:
        """The first screen of an exercise: its part of the lesson, if that is still unread, else its task."""
        self._number = 0
        exercise = begun.exercise
        self._own.wrote(str(file.relative_to(self._learner.home)) for file in begun.new)
        body = self._learner.lesson(exercise) if begun.to_read else self._learner.task(begun)
        return Look(exercise, body, self._learner.last_result(exercise), remark=_how_to_begin(exercise))


def _how_to_begin(exercise: Exercise) -> str:
    return "press c to answer its questions" if exercise.questions else "waiting for you to save a file"
