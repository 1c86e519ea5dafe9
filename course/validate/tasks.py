"""A proof on its way to a worker and back: plain data, a line of JSON each."""

from __future__ import annotations

import json
from dataclasses import asdict, dataclass
from typing import Any

from course.batch.pool import Work
from course.feedback import Feedback
from course.grading.result import Result, Verdict, from_json, to_json
from course.validate.plan import Kind, Proof


@dataclass(frozen=True)
class Task:
    """turn: which time it is run, from 1. attempt: of this turn, from 1. course: its root.

    folder: for what is laid out and recorded meanwhile. evidence: keep the recording in this file.
    """

    proof: Proof
    turn: int
    course: str
    folder: str
    attempt: int = 1
    evidence: str | None = None


@dataclass(frozen=True)
class Proven:
    """What came of a task. laid: False when what should be graded could not be put together.

    seconds: from taking it up to its end.
    """

    proof: Proof
    turn: int
    attempt: int
    result: Result
    seconds: float
    laid: bool = True


def task_to_line(task: Task) -> str:
    return json.dumps(asdict(task))


def task_from_line(line: str) -> Task:
    data: dict[str, Any] = json.loads(line)
    return Task(**{**data, "proof": _proof(data["proof"])})


def proven_to_line(proven: Proven) -> str:
    return json.dumps({**vars(proven), "proof": asdict(proven.proof), "result": to_json(proven.result)})


def proven_from_line(line: str) -> Proven:
    """Raises ValueError, KeyError or TypeError when a worker did not write it."""
    data = json.loads(line)
    return Proven(**{**data, "proof": _proof(data["proof"]), "result": from_json(data["result"])})


def _proof(data: dict[str, Any]) -> Proof:
    return Proof(data["exercise"], Kind(data["kind"]), data["name"])


def _fits(task: Task, proven: Proven) -> bool:
    return (proven.proof, proven.turn, proven.attempt) == (task.proof, task.turn, task.attempt)


def _failed(task: Task, how: str) -> Proven:
    fault = Feedback(summary=f"The worker that graded it {how}.")
    result = Result(task.proof.exercise, Verdict.OUR_ERROR, fault=fault)
    return Proven(task.proof, task.turn, task.attempt, result, 0.0)


PROOFS = Work("course.validate.worker", task_to_line, proven_from_line, _fits, _failed)
