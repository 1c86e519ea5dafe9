"""A process that judges the mutants of one exercise: `python -m course.validate.mutation.court DESCRIPTOR`.

It is told its work (`Case`) in a line of JSON on standard input, and writes a line for each mutant. The
recordings are read once; each mutant has a process of its own, forked from this one, so whatever it does
concerns nobody else. One that uses too much time or memory is ended by the kernel.
"""

from __future__ import annotations

import json
import multiprocessing
import os
import resource
import signal
import sys
from collections import deque
from collections.abc import Iterator
from dataclasses import dataclass
from multiprocessing.connection import Connection, wait
from multiprocessing.process import BaseProcess
from typing import TextIO

from course.arena.sandbox.linux import PR_SET_PDEATHSIG, process_control
from course.validate.mutation.bench import Bench
from course.validate.mutation.cases import Case, Heard, case_from_line, heard_to_line, problems_to_line
from course.validate.mutation.model import Fate

_MOST_MEMORY = 1 << 30
# Elapsed seconds for each second of a CPU: for one that waits for something that does not come.
_PATIENCE = 12
_FORK = multiprocessing.get_context("fork")


@dataclass(frozen=True)
class _Trial:
    index: int
    process: BaseProcess
    said: Connection


def main() -> int:
    process_control(PR_SET_PDEATHSIG, signal.SIGKILL)
    _, hard = resource.getrlimit(resource.RLIMIT_DATA)
    most = _MOST_MEMORY if hard == resource.RLIM_INFINITY else min(_MOST_MEMORY, hard)
    resource.setrlimit(resource.RLIMIT_DATA, (most, hard))
    sys.dont_write_bytecode = True  # a mutant is judged once
    with os.fdopen(int(sys.argv[1]), "w", buffering=1, encoding="utf-8") as answers:
        _hear(case_from_line(sys.stdin.readline()), answers)
    return 0


def _hear(case: Case, answers: TextIO) -> None:
    bench = Bench(case)
    answers.write(problems_to_line(bench.problems) + "\n")
    for heard in _all(case, bench):
        answers.write(heard_to_line(heard) + "\n")


def _all(case: Case, bench: Bench) -> Iterator[Heard]:
    waiting = deque(range(len(case.mutants)))
    running: dict[int, _Trial] = {}
    while waiting or running:
        while waiting and len(running) < case.jobs:
            index = waiting.popleft()
            trial = _begin(case, bench, index)
            running[trial.process.sentinel] = trial
        for sentinel in wait(list(running)):
            assert isinstance(sentinel, int)
            yield _end(running.pop(sentinel), case.seconds)


def _begin(case: Case, bench: Bench, index: int) -> _Trial:
    hears, says = _FORK.Pipe(duplex=False)
    process = _FORK.Process(target=_try, args=(case, bench, index, says))
    process.start()
    says.close()
    return _Trial(index, process, hears)


def _try(case: Case, bench: Bench, index: int, says: Connection) -> None:
    """In the forked process. A signal without a handler ends it, even inside a regular expression."""
    process_control(PR_SET_PDEATHSIG, signal.SIGKILL)
    for number in (signal.SIGPROF, signal.SIGALRM):
        signal.signal(number, signal.SIG_DFL)
    signal.setitimer(signal.ITIMER_PROF, case.seconds)
    signal.setitimer(signal.ITIMER_REAL, case.seconds * _PATIENCE)
    fate, by = bench.judge(case.mutants[index], index)
    says.send_bytes(json.dumps([fate.value, by]).encode())


def _end(trial: _Trial, seconds: float) -> Heard:
    with trial.said as said:
        trial.process.join()
        try:
            fate, by = json.loads(said.recv_bytes())
            return Heard(trial.index, Fate(fate), by)
        except EOFError:
            return _without_answer(trial, seconds)


def _without_answer(trial: _Trial, seconds: float) -> Heard:
    code = trial.process.exitcode
    if code in (-signal.SIGPROF, -signal.SIGALRM):
        return Heard(trial.index, Fate.ENDLESS, f"it did not come to an end within {seconds:g} s")
    return Heard(trial.index, Fate.BROKEN, f"the process that judged ended with {code}")


if __name__ == "__main__":
    raise SystemExit(main())
