"""What a court is told, and what it answers: plain data, a line of JSON each."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from typing import Any

from course.validate.mutation.model import Fate
from course.validate.plan import Kind, Proof


@dataclass(frozen=True)
class Witness:
    """A proof with its recording, and the result that it led to: paths of the two files."""

    proof: Proof
    recording: str
    result: str


@dataclass(frozen=True)
class Mutated:
    """A change of the grader's text, as in `Change`; and the checks that use what it changes."""

    start: int
    end: int
    new: str
    checks: tuple[str, ...]


@dataclass(frozen=True)
class Case:
    """All mutants of one exercise. course: its root. folder: an empty one, for the mutants' files.

    text: of the grader, which the mutants' changes are of. jobs: mutants at once. seconds: of a CPU, for one.
    """

    course: str
    exercise: str
    folder: str
    text: str
    witnesses: tuple[Witness, ...]
    mutants: tuple[Mutated, ...]
    jobs: int
    seconds: float


@dataclass(frozen=True)
class Heard:
    """What became of a mutant. index: among those of the case."""

    index: int
    fate: Fate
    by: str


def case_to_line(case: Case) -> str:
    return json.dumps(asdict(case))


def case_from_line(line: str) -> Case:
    data: dict[str, Any] = json.loads(line)
    witnesses = tuple(Witness(**{**one, "proof": _proof(one["proof"])}) for one in data["witnesses"])
    mutants = tuple(Mutated(**{**one, "checks": tuple(one["checks"])}) for one in data["mutants"])
    return Case(**{**data, "witnesses": witnesses, "mutants": mutants})


def _proof(data: dict[str, Any]) -> Proof:
    return Proof(data["exercise"], Kind(data["kind"]), data["name"])


def problems_to_line(problems: Sequence[str]) -> str:
    return json.dumps({"problems": problems})


def heard_to_line(heard: Heard) -> str:
    return json.dumps({"index": heard.index, "fate": heard.fate.value, "by": heard.by})


def answer_from_line(line: str) -> Heard | tuple[str, ...]:
    """What became of a mutant; or, before all others, which proofs do not hold.

    Raises ValueError or KeyError when a court did not write it.
    """
    data: dict[str, Any] = json.loads(line)
    if "problems" in data:
        return tuple(data["problems"])
    return Heard(data["index"], Fate(data["fate"]), data["by"])
