"""A fake course.validate.prover: WAYS lists the results of the attempts."""

from __future__ import annotations

import os

from course.child import answer_tasks
from course.model.feedback import Feedback, Location
from course.model.result import CheckResult, Outcome, Result, Timing, Verdict, verdict_of
from course.validate.proofs import ProofResult, ProofTask

PASSED = CheckResult("why", "why", 1, Outcome.PASSED)
FAILED = CheckResult("why", "why", 1, Outcome.FAILED, feedback=Feedback("burns all the time, 05-quiz.yaml"))
BUSY = Timing(evidence=1.0, lag=0.5)


def answer(task: ProofTask, _: object) -> ProofResult:
    way = os.environ["WAYS"].split()[min(task.attempt, len(os.environ["WAYS"].split())) - 1]
    if way == "dies":
        raise SystemExit(3)
    checks = (FAILED,) if way.startswith("caught") else (PASSED,)
    timing = BUSY if way.endswith("-busy") else Timing()
    result = Result(task.proof.exercise, verdict_of(checks), checks, timing)
    if way == "ours" or way.startswith("grader"):
        where = (Location("/c/graders/ch05.py", 7),) if way.startswith("grader") else ()
        fault = Feedback("It fell over.", where=where)
        result = Result(task.proof.exercise, Verdict.OUR_ERROR, timing=timing, fault=fault)
    if way == "missing":
        result = Result(task.proof.exercise, Verdict.NOT_AVAILABLE, fault=Feedback("There is no ROS."))
    return ProofResult(task.proof, task.turn, task.attempt, result, 0.1, laid=way != "unlaid")


if __name__ == "__main__":
    answer_tasks(ProofTask, answer)
