"""Observes one of the learner's Python programs from inside, in the run that looks for a cause.

Python imports it before the program, as `sitecustomize`. It notes which errors an `except` in the learner's
files catches, which threads and tasks an error ended, where the program got stuck, and which lines ran.
Each note is a line of JSON, an event `Observed`. The program can forge such lines, so they only serve as
advice. `sys.settrace` works in all Python versions and, unlike import hooks, also sees scripts.
"""

from __future__ import annotations

import ast
import atexit
import json
import os
import sys
import threading
import time
import traceback
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from types import FrameType, TracebackType
from typing import Any, NamedTuple

# Limits: notes per program, characters of an error, lines reported as run.
MOST_NOTES, MOST_TEXT, MOST_LINES = 100, 400, 5000
_TICK = 0.2
_STOOD = 1.0
# Observation makes a callback many times slower.
_LOOPED = 10.0


class Handler(NamedTuple):
    """line: of the `except`. caught: the exceptions that it names, None for all. sure: it has matched."""

    line: int
    caught: tuple[str, ...] | None
    sure: bool


def handlers(text: str) -> Mapping[int, Handler]:
    """Handlers by the line that runs when an `except` has caught an error, usually its first line."""
    found = {}
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.ExceptHandler):
            first = node.body[0].lineno
            names = ast.unparse(node.type).strip("()").split(", ") if node.type else None
            caught = tuple(name.rpartition(".")[2] for name in names) if names else None
            found[first] = Handler(node.lineno, caught, first != node.lineno)
    return found


class _Stay:
    """How long something has been the same. Reported after `least` seconds, then less and less often."""

    def __init__(self, least: float) -> None:
        self._least = least
        self._place: tuple[Any, ...] = ()
        self._since = time.monotonic()
        self._told = 0.0

    def left(self, place: tuple[Any, ...]) -> tuple[Any, ...]:
        """Takes the current place. Returns the previous one, if it was reported and is now over."""
        if place == self._place:
            return ()
        before = self._place if self._told else ()
        self._place, self._since, self._told = place, time.monotonic(), 0.0
        return before

    @property
    def seconds(self) -> float:
        return time.monotonic() - self._since

    def is_long(self) -> bool:
        if self.seconds < max(self._least, 2 * self._told):
            return False
        self._told = self.seconds
        return True


class Observer:
    """roots, names: folders of the learner's files as this program knows them, and the files' names.

    folder: for the notes of this program.
    """

    def __init__(self, roots: Sequence[str], names: Sequence[str], folder: str) -> None:
        self._roots = tuple(f"{root}/" for root in roots)
        self._names = frozenset(names)
        self._folder = folder
        self._file: int | None = None
        self._noted: set[str] = set()
        self._ran: set[tuple[str, int]] = set()
        self._new: list[tuple[str, int]] = []
        self._steps = 0
        self._interrupted = False
        self._own: dict[str, bool] = {}
        self._handlers: dict[str, Mapping[int, Handler]] = {}
        self._main = threading.main_thread().ident or 0

    def begin(self) -> None:
        threading.Thread(target=self._watch, daemon=True).start()
        atexit.register(self._tell_lines)
        threading.excepthook = self._thread_hook(threading.excepthook)
        threading.settrace(self._called)
        sys.settrace(self._called)

    # ------------------------------------------------------------------------------- what is traced

    def _called(self, frame: FrameType, event: str, argument: Any) -> Callable[..., Any] | None:
        return self._step if self._is_own(frame.f_code.co_filename) else None

    def _step(self, frame: FrameType, event: str, argument: Any) -> Callable[..., Any]:
        self._steps += 1
        if event == "exception" and issubclass(argument[0], KeyboardInterrupt):
            self._interrupted = True
        if event == "line":
            file, line = frame.f_code.co_filename, frame.f_lineno
            if (file, line) not in self._ran and len(self._ran) < MOST_LINES:
                self._ran.add((file, line))
                self._new.append((file, line))
            handler = self._handlers_of(file).get(line)
            error = sys.exc_info()[1] if handler else None
            if handler and error and _takes(handler, error):
                self._note("caught", error, [file, handler.line])
        return self._step

    def _is_own(self, file: str) -> bool:
        known = self._own.get(file)
        if known is None:
            path = Path(file).absolute()
            inside = not file.startswith("<") and str(path).startswith(self._roots)
            known = self._own[file] = inside and path.name in self._names
        return known

    def _handlers_of(self, file: str) -> Mapping[int, Handler]:
        if file not in self._handlers:
            try:
                self._handlers[file] = handlers(Path(file).read_text(encoding="utf-8-sig"))
            except (OSError, ValueError, SyntaxError, RecursionError):
                self._handlers[file] = {}
        return self._handlers[file]

    def _thread_hook(self, before: Callable[[Any], Any]) -> Callable[[Any], Any]:
        def hook(died: Any) -> None:
            if died.exc_value is not None:
                self._note("died", died.exc_value, None)
            before(died)

        return hook

    # ------------------------------------------------------------------------------- what is watched

    def _watch(self) -> None:
        """Watches whether the main thread makes progress, and listens to asyncio once it is loaded."""
        tick, listens = threading.Event(), False
        here, halt = _Stay(_LOOPED), _Stay(_STOOD)
        while True:
            tick.wait(_TICK)
            if not listens and (base := sys.modules.get("asyncio.base_events")):
                listens = self._listen_to(base)
            self._tell_lines()
            frame, called_back, below = self._stack()
            over = {"stood": halt.left((frame, below, self._steps)), "looped": here.left((frame,))}
            for what, left in over.items():
                if left and not self._interrupted:
                    self._stay(what, left[0], called_back=False, seconds=0.0)  # it continued
            if frame and halt.is_long():
                self._stay("stood", frame, called_back, halt.seconds)
            elif frame and called_back and halt.seconds < _STOOD and here.is_long():
                self._stay("looped", frame, called_back, here.seconds)

    def _stay(self, what: str, frame: FrameType, called_back: bool, seconds: float) -> None:
        """seconds: 0 takes back an earlier note, so it is always written."""
        where = [frame.f_code.co_filename, frame.f_lineno]
        error = "called back" if called_back else ""
        self._write(what, error=error, by=where, seconds=seconds, counted=seconds > 0)

    def _stack(self) -> tuple[FrameType | None, bool, FrameType | None]:
        """The learner's innermost frame, whether foreign code called it back, and the frame it called."""
        below: FrameType | None = None
        frame = sys._current_frames().get(self._main)
        while frame and not self._is_own(frame.f_code.co_filename):
            below, frame = frame, frame.f_back
        if frame is None:
            return None, False, None
        outer, foreign = frame.f_back, False
        while outer and not (foreign and self._is_own(outer.f_code.co_filename)):
            foreign = foreign or not self._is_own(outer.f_code.co_filename)
            outer = outer.f_back
        return frame, outer is not None, below

    def _listen_to(self, base: Any) -> bool:
        """asyncio tells its loop's handler about failed tasks whose error nobody read."""
        before = getattr(getattr(base, "BaseEventLoop", None), "call_exception_handler", None)
        if before is None:  # it is still being imported
            return False

        def told(loop: Any, context: Any) -> None:
            if isinstance(error := context.get("exception"), BaseException):
                self._note("died", error, None)
            before(loop, context)

        base.BaseEventLoop.call_exception_handler = told
        return True

    # ------------------------------------------------------------------------------- what is noted

    def _note(self, what: str, error: BaseException, by: list[Any] | None) -> None:
        text = traceback.format_exception_only(type(error), error)[-1].strip()
        self._write(what, error=text[:MOST_TEXT], raised=self._place(error.__traceback__), by=by)

    def _place(self, trace: TracebackType | None) -> list[Any] | None:
        """The learner's innermost line."""
        found = None
        while trace:
            file = trace.tb_frame.f_code.co_filename
            found = [file, trace.tb_lineno] if self._is_own(file) else found
            trace = trace.tb_next
        return found

    def _tell_lines(self) -> None:
        new, self._new = self._new, []
        for file in {file for file, _ in new}:
            lines = sorted(line for where, line in new if where == file)
            self._write("ran", by=[file, None], lines=lines, counted=False)

    def _write(
        self,
        what: str,
        error: str = "",
        raised: list[Any] | None = None,
        by: list[Any] | None = None,
        seconds: float = 0.0,
        lines: list[int] | None = None,
        counted: bool = True,
    ) -> None:
        known = f"{what} {error} {raised} {by} {seconds}"
        if counted and (known in self._noted or len(self._noted) >= MOST_NOTES):
            return
        if counted:
            self._noted.add(known)
        places = {"raised": raised, "by": by}
        said = {name: {"file": at[0], "line": at[1]} for name, at in places.items() if at}
        note = {"kind": "Observed", "t": 0.0, "what": what, "error": error, "seconds": seconds, **said}
        text = json.dumps({**note, "lines": lines or []}) + "\n"
        if self._file is None:
            Path(self._folder).mkdir(parents=True, exist_ok=True)
            name = f"{self._folder}/{os.getpid()}.{time.monotonic_ns()}"
            self._file = os.open(name, os.O_WRONLY | os.O_CREAT | os.O_APPEND | os.O_CLOEXEC, 0o644)
        os.write(self._file, text.encode())


def _takes(handler: Handler, error: BaseException) -> bool:
    if handler.sure or handler.caught is None:
        return True
    return any(kind.__name__ in handler.caught for kind in type(error).__mro__)


def main() -> None:
    """What to watch is in a file beside this one."""
    told = json.loads(Path(__file__).with_name("observer.json").read_text(encoding="utf-8"))
    Observer(told["roots"], told["names"], told["folder"]).begin()


if __name__ == "sitecustomize":
    main()
