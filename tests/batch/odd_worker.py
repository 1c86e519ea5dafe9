"""A fake course.batch.worker: the exercise's name says how it behaves."""

from __future__ import annotations

import os
import signal
import sys
import time
from pathlib import Path

from course.batch.gradings import Graded, GradingTask
from course.model import codec
from course.model.result import Result, Verdict


def answer(task: GradingTask) -> str:
    result = Result(task.unit.exercise, Verdict.PASSED, containment=str(os.getpid()))
    return codec.to_json(Graded(task.unit, result, 0.1)).decode() + "\n"


def behave(task: GradingTask) -> str:
    match task.unit.exercise:
        case "killed":
            os.kill(os.getpid(), signal.SIGKILL)
        case "talks":
            return f'"Building a"\n"Building b"\n{answer(task)}'
        case "leaves":
            raise SystemExit(7)
        case "rubbish":
            return "rubbish\n"
        case "bytes":
            os.write(int(sys.argv[1]), b"\xff\xfe\n")
            return ""
        case "half":
            os.write(int(sys.argv[1]), answer(task)[:20].encode())
            os.kill(os.getpid(), signal.SIGKILL)
        case "other":
            return answer(GradingTask(task.unit.again(), "", ""))
        case "stops":
            os.write(int(sys.argv[1]), answer(task)[:20].encode())
            time.sleep(600)
        case "hangs":
            Path(task.evidence).touch()
            time.sleep(600)
        case "deaf":
            for number in (signal.SIGTERM, signal.SIGINT):
                signal.signal(number, signal.SIG_IGN)
            Path(task.evidence).touch()
            time.sleep(600)
    return answer(task)


if __name__ == "__main__":
    with os.fdopen(int(sys.argv[1]), "w") as answers:
        for line in sys.stdin:
            answers.write(behave(codec.from_json(line, GradingTask, "the task")))
            answers.flush()
