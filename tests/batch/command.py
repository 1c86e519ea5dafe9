"""The real command, in separate processes, and what it left behind."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path

import psutil

from course.batch.results import Results
from course.evidence.mcap_file import load
from course.model.result import Outcome, Verdict

REPO = Path(__file__).parents[2]
_GROUPS = Path("/sys/fs/cgroup")
_ENDING = 30.0

# The verdict, and the ids of all failed checks, by person and exercise.
Verdicts = dict[tuple[str, str], tuple[Verdict, frozenset[str]]]


@dataclass(frozen=True)
class Command:
    """`grade FOLDER --out OUT`. temporary: its private TMPDIR. cache: of builds, may be shared."""

    folder: Path
    out: Path
    temporary: Path
    words: tuple[str, ...] = ()
    before: tuple[str, ...] = ()
    cache: Path | None = None

    def start(self) -> subprocess.Popen[str]:
        self.temporary.mkdir(exist_ok=True)
        cache = {"ROS2COURSE_CACHE": str(self.cache)} if self.cache else {}
        program = [sys.executable, "-m", "course", *self.before, "grade"]
        return subprocess.Popen(
            [*program, str(self.folder), "--out", str(self.out), *self.words],
            cwd=REPO,
            env={**os.environ, **cache, **self._environment()},
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            start_new_session=True,
        )

    def _environment(self) -> dict[str, str]:
        return {
            "TMPDIR": str(self.temporary),
            "PYTHONPATH": str(REPO),
            "COLUMNS": "130",
            "NO_COLOR": "1",
            "ROS2COURSE_LAUNCHER": "./ros2course",
        }

    def run(self) -> tuple[int, str]:
        """The exit code and all output."""
        with self.start() as process:
            said = process.communicate()[0]
        return process.returncode, said

    def until_judged(self, tries: int = 3) -> str:
        """Repeat the command while something could not be judged, for example on a busy machine."""
        for _ in range(tries):
            code, said = self.run()
            if code != 3:
                break
        assert code == 0, said
        return said


def below(process: subprocess.Popen[str]) -> list[psutil.Process]:
    """The process itself, and all that it has started."""
    try:
        top = psutil.Process(process.pid)
        top.create_time()  # psutil keeps it; once the process has ended, it cannot be asked
        return [top, *top.children(recursive=True)]
    except psutil.NoSuchProcess:
        return []


def outliving(processes: list[psutil.Process]) -> list[str]:
    """The processes that do not end."""
    left = psutil.wait_procs(processes, timeout=_ENDING)[1]
    # Another process may have the number of one that has ended.
    there = (process for process in left if process.is_running())
    return [str(process) for process in there if process.status() != psutil.STATUS_ZOMBIE]


def groups_of(processes: Iterable[psutil.Process]) -> list[str]:
    """Control groups that these processes have made. Others may have the numbers of those that have ended."""
    ticks = os.sysconf("SC_CLK_TCK")
    names = tuple(
        f"ros2course-{each.pid}-{round((each.create_time() - psutil.boot_time()) * ticks)}-"
        for each in processes
    )
    # Not `glob`: others' groups come and go meanwhile.
    found = [Path(path) for path, *_ in os.walk(_GROUPS) if Path(path).name.startswith(names)]
    return [str(path) for path in found if path.exists()]


def verdicts(out: Path) -> Verdicts:
    with Results.open(out, create=False) as results:
        return {
            (one.person, stored.unit.exercise): (
                stored.result.verdict,
                frozenset(each.id for each in stored.result.checks if each.outcome is Outcome.FAILED),
            )
            for one in results.submissions()
            for stored in results.gradings(one.person)
        }


def graded(process: subprocess.Popen[str], count: int, of: int) -> list[str]:
    """The people in the next `count` lines about gradings; all if there are fewer."""
    found: list[str] = []
    assert process.stdout is not None
    while len(found) < count and (line := process.stdout.readline()):
        if f" of {of}, " in line:
            found.append(line.split()[0])
    return found


def half_written(out: Path) -> Iterator[str]:
    """Files that only a killed process can have left, and unreadable recordings."""
    yield from (str(path) for path in out.rglob(".*"))
    yield from (str(path) for path in (out / "work").rglob("*"))
    with Results.open(out, create=False) as results:
        noted = {
            stored.evidence
            for one in results.submissions()
            for stored in results.gradings(one.person)
            if stored.evidence
        }
    there = {str(path.relative_to(out)) for path in (out / "evidence").rglob("*.mcap")}
    yield from (f"{name} is noted or there, and not both" for name in noted ^ there)
    for name in there:
        load(out / name)
