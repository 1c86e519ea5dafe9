"""Runs alongside the learner's programs: a probe of ours that imports their code and asks questions.

Arguments: the descriptor for answers, the file with the probe's code, the course home. The probe's code can
call `ask(question, function)`; each answer is one line of JSON with the fields of
`course.evidence.process_view.ProbeAnswer`. An exception ends only its question, not the probe.
"""

from __future__ import annotations

import json
import os
import sys
import traceback
from collections.abc import Callable
from pathlib import Path
from typing import Any

MAX_TEXT = 100_000
MAX_TROUBLE = 4000
MAX_DEPTH = 6
MAX_ITEMS = 1000


class Probe:
    """The probe's side of the pipe `descriptor`. home: the folder of the learner's files."""

    def __init__(self, descriptor: int, home: Path) -> None:
        self._descriptor = descriptor
        self._home = home.resolve()

    def ask(self, question: str, function: Callable[[], Any]) -> Any:
        """Call `function` and report what it returns or raises. Returns its value, or None."""
        try:
            value = function()
        except BaseException as error:  # noqa: BLE001 - SystemExit too: their code may raise anything
            self.report({"question": question, **self._trouble(error)})
            return None
        self.report({"question": question, "value": plain(value), "type": type(value).__name__})
        return value

    def run(self, function: Callable[[], None]) -> None:
        """Run the probe's own code; only an exception from it is reported, usually from an import."""
        try:
            function()
        except BaseException as error:  # noqa: BLE001 - as above
            self.report({"question": "", **self._trouble(error)})

    def report(self, data: Any) -> None:
        line = json.dumps(data, ensure_ascii=False) + "\n"
        rest = line.encode(errors="replace")  # replaces lone surrogates
        while rest:
            rest = rest[os.write(self._descriptor, rest) :]

    def _trouble(self, error: BaseException) -> dict[str, Any]:
        """The line that names the exception, and the learner's line that led to it."""
        text = "".join(traceback.format_exception_only(type(error), error)).strip()
        steps = traceback.walk_tb(error.__traceback__)
        places: list[tuple[str, int | None]] = [(frame.f_code.co_filename, line) for frame, line in steps]
        if isinstance(error, SyntaxError) and error.filename:
            places.append((error.filename, error.lineno))
            text = f"{type(error).__name__}: {error.msg}"
        found: dict[str, Any] = {"error": text[-MAX_TROUBLE:]}
        ours = [place for place in places if not place[0].startswith(("<", sys.prefix, sys.base_prefix))]
        for file, line in reversed(ours):
            path = Path(file).resolve()
            if path.is_relative_to(self._home):
                return {**found, "file": str(path.relative_to(self._home)), "line": line}
        return {**found, "file": ours[-1][0], "line": ours[-1][1]} if ours else found


def cut(text: str) -> str:
    return text if len(text) <= MAX_TEXT else f"{text[:MAX_TEXT]} [text cut after {MAX_TEXT:,} characters]"


def plain(value: Any, depth: int = 0) -> Any:
    """The value as JSON data if possible, else as its `repr`."""
    if value is None or type(value) in (bool, int, float):
        return value
    if type(value) is str:
        return cut(value)
    if depth < MAX_DEPTH and type(value) in (list, tuple):
        return [plain(item, depth + 1) for item in value[:MAX_ITEMS]]
    if depth < MAX_DEPTH and type(value) is dict:
        return {str(key): plain(item, depth + 1) for key, item in list(value.items())[:MAX_ITEMS]}
    try:
        return cut(repr(value))
    except Exception as error:  # noqa: BLE001 - the learner's own __repr__
        return f"<{type(value).__name__} whose repr raises {type(error).__name__}>"


def main() -> None:
    probe, file = Probe(int(sys.argv[1]), Path(sys.argv[3])), Path(sys.argv[2])
    # As for a script, modules in the folder where it runs are found first.
    sys.path[0] = str(Path.cwd())
    sys.argv = [str(file)]
    probe.report("started")
    code = compile(file.read_text(encoding="utf-8"), str(file), "exec")
    probe.run(lambda: exec(code, {"__name__": "__probe__", "ask": probe.ask}))
    probe.report("done")


if __name__ == "__main__":
    main()
