"""What a learner is told of a build that was stopped, or that left what must not be there."""

from __future__ import annotations

from course.arena.sandbox.limits import BUILD
from course.arena.sandbox.watchdog import CPU, DISK, MEMORY, PROCESSES
from course.build.digest import Case
from course.build.outcome import BuildFailure
from course.build.process import Ended, Ending
from course.build.sealing import Flaw
from course.build.usage import FILES, MOST_FILES

_MB = 1024 * 1024
_LIMITS = {
    MEMORY: f"took more than {BUILD.memory // _MB} MB of memory",
    PROCESSES: f"started more than {BUILD.processes} processes and threads",
    CPU: f"used more than {BUILD.cpu:g} s of computing time",
    DISK: f"wrote more than {BUILD.scratch // _MB} MB of files",
    FILES: f"made more than {MOST_FILES} files, or folders far too deep in one another",
}
_FLAWS = {
    "link": "installs a link that leads out of the package",
    "kind": "installs what is neither a file nor a folder",
    "size": "installs far too many files, or folders far too deep in one another",
}


def stopped(case: Case, ended: Ended, time_limit: float) -> BuildFailure:
    name, lines = case.package.name, case.lines[-3:]
    file = case.place(_ran(case))
    if ended.ending is Ending.TOO_LONG:
        summary = f"Building `{name}` took longer than {time_limit:g} seconds and was stopped."
        advice = "Does setup.py or CMakeLists.txt loop without end, or wait for someone to type?"
        return case.failure("time-limit", summary, where=[file], advice=advice, details=lines)
    if ended.limit is not None:
        summary = f"Building `{name}` {_LIMITS[ended.limit]} and was stopped."
        advice = "Look for what does that in setup.py or CMakeLists.txt: building a package takes little."
        return case.failure(f"{ended.limit}-limit", summary, where=[file], advice=advice, details=lines)
    summary = f"Building `{name}` printed without end and was stopped."
    advice = "Look for what prints in a loop in setup.py or CMakeLists.txt."
    return case.failure("output-limit", summary, where=[file], advice=advice, details=lines)


def flawed(case: Case, flaw: Flaw) -> BuildFailure:
    summary = f"Building `{case.package.name}` {_FLAWS[flaw.why]}: `{flaw.name}`."
    advice = "Install files of the package itself: `data_files` in setup.py, `install` in CMakeLists.txt."
    return case.failure(f"installed-{flaw.why}", summary, where=[case.place(_ran(case))], advice=advice)


def _ran(case: Case) -> str:
    return "setup.py" if case.text("setup.py") else "CMakeLists.txt"
