"""A process that judges the mutants of one exercise: `python -m course_mutation.worker DESCRIPTOR`.

It reads its work (`Case`) as a line of JSON on standard input, and writes a line for each mutant. It loads
the recordings once. Each mutant runs in a separate process, forked from this one, so it cannot affect
others. The kernel ends a mutant that uses too much time or memory.
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
from itertools import chain
from multiprocessing.connection import Connection, wait
from multiprocessing.process import BaseProcess
from typing import BinaryIO

from course.child import end_with_parent
from course.model import codec
from course_mutation.judging import Judge
from course_mutation.model import Case, Ended, Fate

_MOST_MEMORY = 1 << 30
# Elapsed seconds for each second of CPU time, for a mutant that waits forever.
_PATIENCE = 12
_FORK = multiprocessing.get_context("fork")


@dataclass(frozen=True)
class _Running:
    index: int
    process: BaseProcess
    said: Connection


def main() -> int:
    end_with_parent()
    _, hard = resource.getrlimit(resource.RLIMIT_DATA)
    most = _MOST_MEMORY if hard == resource.RLIM_INFINITY else min(_MOST_MEMORY, hard)
    resource.setrlimit(resource.RLIMIT_DATA, (most, hard))
    sys.dont_write_bytecode = True  # a mutant is judged once
    with os.fdopen(int(sys.argv[1]), "wb") as answers:
        _answer(codec.from_json(sys.stdin.buffer.readline(), Case, "the case"), answers)
    return 0


def _answer(case: Case, answers: BinaryIO) -> None:
    judge = Judge(case)
    for answer in chain([judge.problems], _all(case, judge)):
        answers.write(codec.to_json(answer) + b"\n")
        answers.flush()


def _all(case: Case, judge: Judge) -> Iterator[Ended]:
    waiting = deque(range(len(case.mutants)))
    running: dict[int, _Running] = {}
    while waiting or running:
        while waiting and len(running) < case.jobs:
            index = waiting.popleft()
            trial = _begin(case, judge, index)
            running[trial.process.sentinel] = trial
        for sentinel in wait(list(running)):
            assert isinstance(sentinel, int)
            yield _end(running.pop(sentinel), case.seconds)


def _begin(case: Case, judge: Judge, index: int) -> _Running:
    hears, says = _FORK.Pipe(duplex=False)
    process = _FORK.Process(target=_try, args=(case, judge, index, says))
    process.start()
    says.close()
    return _Running(index, process, hears)


def _try(case: Case, judge: Judge, index: int, says: Connection) -> None:
    """In the forked process. A signal without a handler ends it, even inside a regular expression."""
    end_with_parent()
    for number in (signal.SIGPROF, signal.SIGALRM):
        signal.signal(number, signal.SIG_DFL)
    signal.setitimer(signal.ITIMER_PROF, case.seconds)
    signal.setitimer(signal.ITIMER_REAL, case.seconds * _PATIENCE)
    fate, by = judge.judge(case.mutants[index], index)
    says.send_bytes(json.dumps([fate.value, by]).encode())


def _end(trial: _Running, seconds: float) -> Ended:
    with trial.said as said:
        trial.process.join()
        try:
            fate, by = json.loads(said.recv_bytes())
            return Ended(trial.index, Fate(fate), by)
        except EOFError:
            return _without_answer(trial, seconds)


def _without_answer(trial: _Running, seconds: float) -> Ended:
    code = trial.process.exitcode
    if code in (-signal.SIGPROF, -signal.SIGALRM):
        return Ended(trial.index, Fate.ENDLESS, f"it did not end within {seconds:g} s")
    return Ended(trial.index, Fate.BROKEN, f"the process that judged ended with {code}")


if __name__ == "__main__":
    raise SystemExit(main())
