"""Judges the recordings of one exercise by mutants of its grader: is all still as the course claims?"""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from course.content import Mistake, open_course
from course.evidence.mcap_file import load
from course.evidence.recording import Recording
from course.grading.channel import Judgement
from course.grading.judging import judge
from course.grading.result import Result, Verdict, from_json, verdict_of
from course.rosenv import cache_dir
from course.validate.judge import earns_all, is_caught
from course.validate.mutation.cases import Case, Mutated, Witness
from course.validate.mutation.model import Fate
from course.validate.plan import Kind, Proof

_LONGEST = 300


@dataclass(frozen=True)
class _Seat:
    """A witness that has been heard once. mistake: None for a right way."""

    proof: Proof
    recording: Recording
    before: Result
    mistake: Mistake | None

    def complaints(self, judgement: Judgement, questions: set[str]) -> tuple[Result, list[str]]:
        """What would have come of this judgement, and how that is not what the course claims."""
        asked = tuple(check for check in self.before.checks if check.id in questions)
        checks = (*judgement.checks, *asked)
        verdict = Verdict.OUR_ERROR if judgement.fault else verdict_of(checks)
        result = replace(self.before, checks=checks, verdict=verdict, fault=judgement.fault)
        return result, is_caught(result, self.mistake) if self.mistake else earns_all(result)


class Bench:
    """problems: the proofs that do not hold even with the grader as it is; these are not asked."""

    def __init__(self, case: Case) -> None:
        course = open_course(Path(case.course), cache=cache_dir(os.environ) / "lessons")
        self._exercise = course.exercise(case.exercise)
        self._questions = {question.id for question in self._exercise.questions}
        self._text = case.text.encode()
        self._folder = _stage(course.root, Path(case.folder))
        mistakes = {mistake.id: mistake for mistake in self._exercise.mistakes()}
        self._seats = [_seat(witness, mistakes) for witness in case.witnesses]
        self.problems = self._as_it_is()

    def judge(self, mutated: Mutated, index: int) -> tuple[Fate, str]:
        """What becomes of it, and by which proof; the first that notices ends it."""
        text = self._text[: mutated.start] + mutated.new.encode() + self._text[mutated.end :]
        seats = sorted(self._seats, key=lambda seat: _order(seat, mutated.checks))
        for seat, result, said in self._heard(text, str(index), seats):
            if said:
                fate = Fate.BROKEN if result.verdict is Verdict.OUR_ERROR else Fate.KILLED
                return fate, f"{seat.proof.kind.value} {seat.proof.name}".strip() + f": {said[0]}"[:_LONGEST]
        return Fate.SURVIVED, ""

    def _as_it_is(self) -> list[str]:
        heard = self._heard(self._text, "", self._seats, to_the_end=True)
        bad = {seat.proof: said[0] for seat, _, said in heard if said}
        self._seats = [seat for seat in self._seats if seat.proof not in bad]
        return [f"{proof}: {said}" for proof, said in bad.items()]

    def _heard(
        self, text: bytes, suffix: str, seats: Sequence[_Seat], *, to_the_end: bool = False
    ) -> list[tuple[_Seat, Result, list[str]]]:
        """Each with what it says; the last one is the first that complains."""
        heard: list[tuple[_Seat, Result, list[str]]] = []

        def recordings() -> Iterator[Recording]:
            for seat in seats:
                if to_the_end or not heard or not heard[-1][2]:
                    yield seat.recording

        def tell(judgement: Judgement) -> None:
            seat = seats[len(heard)]
            heard.append((seat, *seat.complaints(judgement, self._questions)))

        # A name of its own: Python knows the module by it.
        file = self._folder / f"{self._exercise.grader.stem}_mutant{suffix}.py"
        file.write_bytes(text)
        judge(file, {self._exercise.id}, recordings(), tell)
        return heard


def _seat(witness: Witness, mistakes: dict[str, Mistake]) -> _Seat:
    proof = witness.proof
    before = from_json(Path(witness.result).read_text(encoding="utf-8"))
    mistake = mistakes[proof.name] if proof.kind is Kind.MISTAKE else None
    return _Seat(proof, load(Path(witness.recording)), before, mistake)


def _order(seat: _Seat, checks: Sequence[str]) -> int:
    """First who is most likely to notice: the mistakes that these checks are to catch."""
    if seat.mistake is None:
        return 2 if seat.proof.kind is Kind.SOLUTION else 3
    if seat.mistake.caught_by in checks:
        return 0
    return 1 if set(seat.mistake.also_fails) & set(checks) else 4


def _stage(root: Path, folder: Path) -> Path:
    """A folder for graders which to them is that of the course."""
    for part in root.iterdir():
        if part.name != "graders":
            (folder / part.name).symlink_to(part)
    graders = folder / "graders"
    graders.mkdir()
    for beside in (root / "graders").iterdir():
        if beside.name != "__pycache__":
            (graders / beside.name).symlink_to(beside)
    return graders
