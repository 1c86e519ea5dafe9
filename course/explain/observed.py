"""Explains a failure without a proven cause, from notes on a second run that is observed from inside.

The submission can write anything into these notes. So they only lead to advice, each place must be a line
that exists in the learner's files, and everything quoted is short and printable.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator

from course.evidence.recording import Recording
from course.evidence.sources import Sources
from course.explain.engine import Cause, Evidence, Symptom, explain
from course.explain.python_code import called_name, nodes
from course.explain.python_errors import EXCEPTIONS, learners_file
from course.model.events import Observed
from course.model.feedback import Location

# Begins advice on what to look at if no cause is proven. Such advice triggers the second run.
UNKNOWN = "The cause is not known. Things to check:"
# Not errors, but ways for a program to end silently.
_HARMLESS = re.compile(r"^[\w.]*\b(KeyboardInterrupt|ExternalShutdownException|SystemExit|RCLError)\b")
# Errors that even a correct line may raise, so a program may catch them, if it catches no others.
_EXPECTED = re.compile(r"^(?!TypeError|NameError|AttributeError|UnboundLocalError|rclpy)")
_EVERYTHING = ("Exception", "BaseException")
_MAKERS = ("create_timer", "create_publisher", "create_subscription", "create_service", "create_client")
# How `main` may wait after it has started other threads.
_WAITS = {"join", "wait", "sleep", "input", "pause"}
_WORKERS = ("Thread", "Timer", "start", "start_new_thread", "submit")
_LONGEST, _MOST, _MOST_ERRORS = 160, 500, 30


def unproven(
    recording: Recording, look_at: str, where: tuple[Location, ...] = (), *, ended: bool = False
) -> Cause:
    """What the notes say about the program; before the second run has made any, what to check.

    ended: whether the program ended by itself, so that a loop which never ran may be the cause.
    """
    cause = observed_cause(recording) or (_never_looped(recording) if ended else None)
    return cause or Cause(f"{UNKNOWN} {look_at}", where)


def observed_cause(recording: Recording) -> Cause | None:
    """The first of these in the notes: a hidden error, a dead thread, a halt, lines that did not run."""
    notes = [event for event in recording.events if isinstance(event, Observed)][:_MOST]
    seen = [_Note(note, recording) for note in notes]
    errors = [note for note in seen if note.event.what in ("caught", "died")][:_MOST_ERRORS]
    told = [_hidden(note) for note in errors if note.event.what == "caught"]
    told += [_died(note) for note in errors if note.event.what == "died"]
    halts = [note for note in seen if note.event.what in ("stood", "looped") and note.by]
    ran = _lines(seen)
    told += [_halted(note, ran) for note in halts[-1:]]
    return next(filter(None, told), None) or _not_run(ran, recording.sources)


class _Note:
    """One note, as far as it matches the learner's files. raised, by: None if they do not match."""

    def __init__(self, event: Observed, recording: Recording) -> None:
        self.event = event
        self.recording = recording
        self.raised = self._place(event.raised)
        self.by = self._place(event.by)

    @property
    def error(self) -> str:
        text = "".join(letter if letter.isprintable() else " " for letter in self.event.error[: 4 * _LONGEST])
        return " ".join(text.replace("`", "'").split())

    def _place(self, claimed: Location | None) -> Location | None:
        if claimed is None:
            return None
        file = learners_file(claimed.file, self.recording.packages, self.recording.sources)
        lines = self.recording.sources.files.get(file or "", "").count("\n") + 1
        return Location(file, claimed.line) if file and 0 < (claimed.line or 1) <= lines else None

    def within(self, *kinds: type[ast.AST]) -> ast.AST | None:
        """The innermost node of these kinds that contains the line `by`."""
        found = [
            node
            for file, node in nodes(self.recording.sources)
            if self.by and file == self.by.file and isinstance(node, kinds)
            if getattr(node, "lineno", 0) <= (self.by.line or 0) <= (getattr(node, "end_lineno", 0) or 0)
        ]
        return max(found, key=lambda node: getattr(node, "lineno", 0), default=None)

    def told(self) -> tuple[str, tuple[Location, ...]]:
        """The error, where it was raised, and what to do about it."""
        evidence = Evidence(sources=self.recording.sources, packages=self.recording.packages)
        known = explain(EXCEPTIONS[:-1], [Symptom(self.error, self.raised)], evidence)
        error = f"`{self.error[:_LONGEST]}`"
        if self.raised:
            of = "" if self.by and self.by.file == self.raised.file else f" of `{_name(self.raised)}`"
            error += f", raised on line {self.raised.line}{of}"
        places = (*(known.where if known else ()), *((self.raised,) if self.raised else ()))
        return f"{error}. {known.remedy if known else 'Correct that line.'}", tuple(dict.fromkeys(places))


def _hidden(note: _Note) -> Cause | None:
    handler = note.within(ast.ExceptHandler)
    if not (isinstance(handler, ast.ExceptHandler) and note.by and note.by.line == handler.lineno):
        return None
    names = re.findall(r"\w+$|\w+(?=[,)])", ast.unparse(handler.type)) if handler.type else _EVERYTHING
    asked_for = not set(names) & set(_EVERYTHING) and _EXPECTED.match(note.error)
    raised = (part for line in handler.body for part in ast.walk(line) if isinstance(part, ast.Raise))
    raises = any("SystemExit" not in ast.unparse(part) for part in raised)
    if raises or asked_for or not note.error or _HARMLESS.match(note.error):
        return None
    told, places = note.told()
    return Cause(f"Your `except` on line {note.by.line} hides this error: {told}", (*places, note.by)[:2])


def _died(note: _Note) -> Cause | None:
    if note.raised is None or not note.error or _HARMLESS.match(note.error):
        return None
    told, places = note.told()
    return Cause(f"A thread or task of your program ended with this error: {told}", places[:2])


def _halted(note: _Note, ran: dict[str, set[int]]) -> Cause | None:
    """Where the main thread got stuck; but `spin` and a loop in `main` may run forever."""
    called_back = note.event.error == "called back"
    line = note.within(ast.stmt)
    if note.by is None or line is None or not 1 <= note.event.seconds < 1000:
        return None
    waits = [called_name(call) for call in ast.walk(line) if isinstance(call, ast.Call)]
    if note.event.what == "looped":
        loop = note.within(ast.While, ast.For)
        if not called_back or not isinstance(loop, ast.While | ast.For):
            return None
        return Cause(
            f"The loop on line {loop.lineno} never ends: {note.event.seconds:.0f} s later, the callback "
            "was still in it. Until a callback returns, the node can do nothing else.",
            (Location(note.by.file, loop.lineno),),
        )
    if not called_back and (not waits or any("spin" in name for name in waits)):
        return None
    if not called_back and _WAITS.intersection(waits) and _may_wait(note, waits, ran):
        return None
    what = f"`{waits[0]}`" if waits else "it"
    after = (
        "It is in a callback: until that returns, the node can do nothing else."
        if called_back
        else "The lines after it did not run."
    )
    later = f"{note.event.seconds:.0f} s later"
    text = f"Line {note.by.line} holds up the program: {what} had not finished {later}."
    return Cause(f"{text} {after}", (note.by,))


def _may_wait(note: _Note, waits: list[str], ran: dict[str, set[int]]) -> bool:
    """Whether the line sleeps in a loop, or the program has started threads or spun before."""
    called = (
        called_name(call)
        for file, call in nodes(note.recording.sources)
        if isinstance(call, ast.Call) and _ran(call, ran.get(file, set()))
    )
    rests = "sleep" in waits and note.within(ast.While, ast.For) is not None
    return rests or any(name in _WORKERS or "spin" in name for name in called)


def _lines(seen: list[_Note]) -> dict[str, set[int]]:
    """For each file, the lines that ran."""
    ran: dict[str, set[int]] = {}
    for note in seen:
        if note.event.what == "ran" and note.by:
            ran.setdefault(note.by.file, set()).update(note.event.lines)
    return ran


def _not_run(ran: dict[str, set[int]], sources: Sources) -> Cause | None:
    """A `main` that nothing calls, or a line that creates something and was never reached."""
    mains = [(file, node) for file, node in _functions(sources, ran) if node.name == "main"]
    if mains and not any(_came_to(node.body, ran[file]) for file, node in mains):
        file, main = mains[0]
        return Cause("Nothing calls `main()`: none of its lines ran.", (Location(file, main.lineno),))
    for file, function in _functions(sources, ran):
        for line in function.body if _came_to(function.body, ran[file]) else []:
            for call in ast.walk(line):
                if isinstance(call, ast.Call) and called_name(call) in _MAKERS and not _ran(call, ran[file]):
                    text = f"The program never reaches line {call.lineno}, which calls "
                    return Cause(f"{text}`{called_name(call)}`.", (Location(file, call.lineno),))
    return None


def _never_looped(recording: Recording) -> Cause | None:
    """A `while` that the program reached, but whose body never ran."""
    notes = [event for event in recording.events if isinstance(event, Observed)][:_MOST]
    ran = _lines([_Note(note, recording) for note in notes])
    for file, loop in nodes(recording.sources):
        lines = ran.get(file, set())
        if isinstance(loop, ast.While) and loop.lineno in lines and not _came_to(loop.body, lines):
            text = f"The loop on line {loop.lineno} never ran: `{ast.unparse(loop.test)}` was false."
            return Cause(text, (Location(file, loop.lineno),))
    return None


def _functions(sources: Sources, ran: dict[str, set[int]]) -> Iterator[tuple[str, ast.FunctionDef]]:
    for file, node in nodes(sources):
        if file in ran and isinstance(node, ast.FunctionDef):
            yield file, node


def _came_to(body: list[ast.stmt], lines: set[int]) -> bool:
    return any(_ran(line, lines) for line in body)


def _ran(node: ast.stmt | ast.expr, lines: set[int]) -> bool:
    return any(number in lines for number in range(node.lineno, (node.end_lineno or node.lineno) + 1))


def _name(place: Location) -> str:
    return place.file.rpartition("/")[2]
