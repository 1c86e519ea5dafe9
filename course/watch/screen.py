"""One screenful of `watch`, as lines: the exercise, the text in the middle, the current activity, the keys.

Lines are cut to the terminal's width, so that the screen shows exactly the lines that are counted here.
"""

from __future__ import annotations

import io
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from functools import singledispatch

from rich.console import Console
from rich.text import Text

from course.model.result import CheckResult, Outcome, Verdict
from course.report import sanitize
from course.report.activity import FRAMES
from course.report.console import WIDEST, number, open_console, put, put_course_passed, put_prose
from course.report.exercise_text import (
    put_requires,
    render_after,
    render_exercise,
    render_hint,
    render_lesson,
    render_list,
    render_new_files,
    render_questions,
)
from course.report.problem import render_our_fault, render_problem
from course.report.verdict import HEADLINES, headline, render_checks, render_remarks, total_of
from course.watch.updates import (
    AllPassed,
    Body,
    HintText,
    LessonText,
    Listing,
    Look,
    ProblemText,
    ResultChange,
    ResultText,
    TaskText,
)

# What the learner must still do comes before what is done.
_ORDER = (Outcome.FAILED, Outcome.ERROR, Outcome.SKIPPED, Outcome.PASSED, Outcome.NOT_APPLICABLE)

Typed = Callable[[str], str]


@singledispatch
def render(body: Body, console: Console, typed: Typed) -> None:
    """Print it on the console. typed: turns one of our commands into the form to type on this machine."""
    raise TypeError(f"nothing tells how to show {body!r}")


@render.register
def _lesson(body: LessonText, console: Console, typed: Typed) -> None:
    for lesson in body.lessons:
        render_lesson(console, lesson.chapter, lesson.text)
    put(console, "Press t for the task.", "bold")


@render.register
def _task(body: TaskText, console: Console, typed: Typed) -> None:
    render_exercise(console, body.exercise, body.home, body.state)
    render_new_files(console, body.home, body.new)
    put_requires(console, body.needed)
    if body.questions:
        render_questions(console, body.questions)


@render.register
def _verdict(body: ResultText, console: Console, typed: Typed) -> None:
    result = body.result
    put(console, headline(result, body.previous))
    if result.verdict is Verdict.PASSED:
        put(console, "  Press n for the next exercise.", "bold")
    if body.change is not None:
        _put_change(console, body.change)
    put(console)
    render_checks(console, _most_urgent_first(result.checks), body.previous)
    render_remarks(console, result)
    if result.verdict is Verdict.OUR_ERROR:
        render_our_fault(console, body.log)
    if result.verdict is Verdict.PASSED and body.exercise.after:
        render_after(console, body.exercise.after)


@render.register
def _problem(body: ProblemText, console: Console, typed: Typed) -> None:
    render_problem(console, body.what, body.next_step)


@render.register
def _hint(body: HintText, console: Console, typed: Typed) -> None:
    if body.total == 0:
        put(console, f"There are no hints for {body.exercise.id}.")
        return
    render_hint(console, body.exercise.id, body.number, body.total, body.text)
    if body.number < body.total:
        put(console, "Press h for the next hint.")
    else:
        put(console, f"That was the last hint. `{typed(f'hint {body.exercise.id} --all')}` shows them all.")


@render.register
def _list(body: Listing, console: Console, typed: Typed) -> None:
    render_list(console, body.rows, body.chapters)


@render.register
def _all_passed(body: AllPassed, console: Console, typed: Typed) -> None:
    put_course_passed(console)
    put(console, f"Press q to leave. `{typed('next ID')}` goes back to one of them.")


def _most_urgent_first(checks: Iterable[CheckResult]) -> list[CheckResult]:
    return sorted(checks, key=lambda check: _ORDER.index(check.outcome))


def _put_change(console: Console, change: ResultChange) -> None:
    if change.is_nothing:
        put(console, "  Since the last check: nothing has changed.", "dim")
        return
    put(console, Text.assemble("  Since the last check: ", (gain(change), "bold")))
    for mark, style, titles in (("+", "green", change.fixed), ("-", "yellow", change.broken)):
        said = "passes now" if mark == "+" else "no longer passes"
        for title in titles:
            text = Text(f"{sanitize.paragraph(title)} {said}", style)
            put_prose(console, text, first=f"    {mark} ", rest=" " * 6)


def gain(change: ResultChange) -> str:
    """The points that were gained or lost: `3 points more`."""
    points = abs(change.points)
    unit = "point" if points == 1 else "points"
    if not points:
        return "the same points"
    return f"{number(points)} {unit} {'more' if change.points > 0 else 'fewer'}"


# Of a body, so that the screen stays quick even if a check says a lot.
MOST_LINES = 1000
_KEYS = "n next  h hint  t task  r result  l list  c check  space more  q quit"
_AROUND = 4  # lines that are not the body: the title, two rules and the activity between them, the keys
_NARROWEST = 20


@dataclass(frozen=True)
class Frame:
    """Lines with colors. following: the first line of the body's next screenful; 0 if there is none."""

    lines: tuple[str, ...]
    following: int


class Screen:
    """Draws screens. It remembers the last body, because drawing that takes longest."""

    def __init__(self, typed: Typed) -> None:
        self._typed = typed
        self._drawn: tuple[Body, int, list[Text]] | None = None

    def draw(self, look: Look, width: int, height: int, now: float) -> Frame:
        """At most `height` lines of at most `width` columns."""
        console = _console(min(max(width, _NARROWEST), WIDEST))
        body = self._body(look.body, console.width)
        shown, following = self._part(look, body, max(height - _AROUND, 1))
        rule = Text("-" * console.width, "dim")
        bottom = [rule, _going_on(look, now), Text(_KEYS, "cyan")]
        lines = [_title(look, console.width), *shown]
        lines += [Text()] * (height - len(bottom) - len(lines)) + bottom
        return Frame(tuple(_coded(console, line, width) for line in lines[:height]), following)

    def _body(self, body: Body, width: int) -> list[Text]:
        if self._drawn is None or self._drawn[0] is not body or self._drawn[1] != width:
            self._drawn = (body, width, _lines(body, _console(width), self._typed))
        return self._drawn[2]

    def _part(self, look: Look, body: list[Text], room: int) -> tuple[list[Text], int]:
        """The lines that fit, starting at the learner's line, and the line where the next part starts."""
        first = min(look.first or _beginning(look.body, body, room), max(len(body) - 1, 0))
        if len(body) - first <= room:
            return body[first:], 0
        last = first + max(room - 1, 1)
        more = f"... {len(body) - last} more lines: space shows them"
        if isinstance(look.body, ResultText):
            more += f", `{self._typed('check')}` shows all at once"
        return [*body[first:last], Text(more, "dim")], last


def _title(look: Look, width: int) -> Text:
    """The exercise on the left, and its last result on the right."""
    came = Text()
    if look.result is not None:
        word, style = HEADLINES[look.result.verdict]
        change = f" ({gain(look.change)})" if look.change and look.change.points else ""
        came = Text.assemble((word, style), f": {total_of(look.result)}{change}")
    name = Text.assemble((look.exercise.id, "bold"), "  ", sanitize.one_line(look.exercise.title))
    name.truncate(max(width - came.cell_len - 2, 10), overflow="ellipsis", pad=True)
    return Text.assemble(name, "  ", came)


def _going_on(look: Look, now: float) -> Text:
    remark = sanitize.one_line(look.remark)
    if not look.doing:
        return Text(remark)
    seconds = max(now - look.since, 0.0)
    frame = FRAMES[int(seconds) % len(FRAMES)]
    tail = f"  ({remark})" if remark else ""
    return Text.assemble((f"{frame} {sanitize.one_line(look.doing)}  {seconds:.0f} s", "bold"), tail)


def _beginning(body: Body, lines: list[Text], room: int) -> int:
    if not isinstance(body, Listing) or len(lines) <= room:
        return 0
    here = next((row for row, line in enumerate(lines) if line.plain.startswith(">")), 0)
    return max(min(here - room // 2, len(lines) - room), 0)


def _lines(body: Body, console: Console, typed: Typed) -> list[Text]:
    """The lines of the body. None is wider than the console."""
    end: list[Text] = []
    try:
        render(body, console, typed)
    except _Full:
        end = [Text(f"The rest is cut here. `{typed('check')}` shows all of it.", "bold")]
    written = _taken(console).rstrip("\n").split("\n")
    wrapped = (Text.from_ansi(line).wrap(console, console.width, tab_size=4) or [Text()] for line in written)
    return [line for lines in wrapped for line in lines] + end


def _coded(console: Console, line: Text, width: int) -> str:
    cut = line.copy()
    cut.truncate(min(width, console.width), overflow="ellipsis")
    console.print(cut, soft_wrap=True, end="")
    return _taken(console)


class _Full(Exception):
    """There are more lines than anybody reads in `watch`."""


class _Paper(io.StringIO):
    """A file that a console takes for a terminal, so that it writes colors."""

    def __init__(self) -> None:
        super().__init__()
        self._room = MOST_LINES

    def isatty(self) -> bool:
        return True

    def write(self, text: str) -> int:
        written = super().write(text)
        self._room -= text.count("\n")
        if self._room < 0:
            raise _Full
        return written


def _console(width: int) -> Console:
    return open_console(_Paper(), width=width)


def _taken(console: Console) -> str:
    assert isinstance(console.file, _Paper)
    written = console.file.getvalue()
    console.file.seek(0)
    console.file.truncate()
    return written
