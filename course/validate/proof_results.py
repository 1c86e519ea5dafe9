"""The results of the proofs: how many held, and what was found."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cache
from pathlib import Path

from course.content import Exercise
from course.content.layout import ALTERNATIVE, LESSON, MISTAKES
from course.content.lesson import read_lesson
from course.content.mistakes import read_alternatives, read_mistakes
from course.model.result import Outcome, Result
from course.report.validation import Count, ProofRow
from course.validate import Finding
from course.validate.claims import Claims, failed_by, fault_of_grader, is_missing
from course.validate.proofs import Proof, ProofKind, ProofResult

_STEPS = {
    ProofKind.SOLUTION: "correct the solution or the grader: the reference solution must earn all points",
    ProofKind.ALTERNATIVE: "correct the grader, or the alternative: a right way must earn all points",
    ProofKind.STARTER: "leave something to do in the starter, or let a check look at it",
    ProofKind.MISTAKE: "correct the grader, or what the mistake claims: `caught_by`, `says`, `also_fails`, "
    "`leads_to`",
}
_GRADER = "correct this line of the grader, then validate again"
_STEADY = "let the check depend on nothing that changes by itself: timing, order, chance"


class ProofResults:
    """Everything that was proven up to now. proofs: all of them; each may be proven in several turns."""

    def __init__(self, exercises: Sequence[Exercise], proofs: Sequence[Proof], turns: int = 1) -> None:
        self._exercises = {exercise.id: exercise for exercise in exercises}
        self._proofs = proofs
        self._turns = turns
        self._proven: dict[Proof, list[ProofResult]] = {proof: [] for proof in proofs}
        self._claims = Claims(exercises)
        self._places = SourcePlaces()

    def add(self, proven: ProofResult) -> bool | None:
        """Store it. Return whether it held; None if this machine lacks what it needs."""
        self._proven[proven.proof].append(proven)
        return None if is_missing(proven) else not self._claims.faults(proven)

    @property
    def again(self) -> int:
        """How many gradings were repeated because of a busy machine or an error of ours."""
        return sum(one.attempt - 1 for each in self._proven.values() for one in each)

    @property
    def lacking(self) -> bool:
        """Whether anything could not be graded on this machine."""
        return any(is_missing(one) for each in self._proven.values() for one in each)

    def findings(self) -> list[Finding]:
        """At most one for each proof and one for each grader, in the order of the course's files."""
        judged = (
            proof
            for proof in self._proofs
            if not any(fault_of_grader(one.result) for one in self._proven[proof])
        )
        followers = {proof for each in map(self._followers, self._exercises) for proof in each}
        found = [finding for proof in judged if proof not in followers for finding in self._findings(proof)]
        found = [*self._faults_of_graders(), *found]
        return sorted(found, key=lambda one: (str(one.file), one.line or 0))

    def findings_of(self, proof: Proof) -> list[Finding]:
        return list(self._findings(proof))

    def proven(self, proof: Proof) -> Sequence[ProofResult]:
        return self._proven[proof]

    def why_not(self, proof: Proof) -> str | None:
        """Why it was not judged; None if it was."""
        each = self._proven[proof]
        lack = next((_lack(one.result) for one in each if is_missing(one)), None)
        return lack if each else "It was stopped before."

    def rows(self) -> list[ProofRow]:
        """One for each exercise. points: None until they are known. seconds: of all its gradings."""
        return [self._row(exercise) for exercise in self._exercises]

    def _findings(self, proof: Proof) -> Iterator[Finding]:
        each = [one for one in self._proven[proof] if not is_missing(one)]
        judged = sorted(each, key=lambda one: one.turn)
        first: dict[object, ProofResult] = {}
        for one in judged:
            first.setdefault(_verdict(one.result), one)
        if len(first) > 1:
            rounds = "; ".join(f"round {one.turn}: {_said(one.result)}" for one in first.values())
            yield self._finding(proof, f"{_called(proof)} was judged differently: {rounds}", _STEADY)
            return
        wrong = next((one for one in judged if self._claims.faults(one)), None)
        if wrong is not None:
            step, said = _STEPS[proof.kind], self._claims.faults(wrong)
            if not wrong.laid and wrong.result.fault:
                step, said = wrong.result.fault.advice or step, [wrong.result.fault.summary]
            if proof.kind is ProofKind.SOLUTION and (count := len(self._followers(proof.exercise))):
                some = "1 mistake fails" if count == 1 else f"{count} mistakes fail"
                said = [*said, f"{some} the same checks, and {'is' if count == 1 else 'are'} not listed"]
            yield self._finding(proof, f"{_called(proof)}: {'; '.join(said)}", step)

    def _followers(self, exercise: str) -> list[Proof]:
        """Mistakes whose results differ from the claims only because the solution does not pass either."""
        own = [proof for proof in self._proofs if proof.exercise == exercise]
        solved = (self._proven[proof] for proof in own if proof.kind is ProofKind.SOLUTION)
        solution = next((one.result for each in solved for one in each if self._claims.faults(one)), None)
        wrong = {
            proof: [one for one in self._proven[proof] if self._claims.faults(one)]
            for proof in own
            if proof.kind is ProofKind.MISTAKE
        }
        return [
            proof
            for proof, each in wrong.items()
            if solution and each and all(self._claims.only_follows(one, solution) for one in each)
        ]

    def _faults_of_graders(self) -> Iterator[Finding]:
        """One per exercise, even if several of its proofs ended with our error."""
        for exercise in self._exercises:
            own = (one for proof, each in self._proven.items() if proof.exercise == exercise for one in each)
            faults = [fault for one in own if (fault := fault_of_grader(one.result))]
            if faults:
                first = min(faults, key=lambda fault: (fault.where[0].file, fault.where[0].line or 0))
                what = f"{first.summary} {len(faults)} of {exercise}'s proofs could not be judged."
                yield Finding(Path(first.where[0].file), first.where[0].line, what, _GRADER, exercise)

    def _finding(self, proof: Proof, what: str, step: str) -> Finding:
        file, line = self._places.of(self._exercises[proof.exercise], proof)
        return Finding(file, line, what, step, proof.exercise)

    def _row(self, exercise: str) -> ProofRow:
        own = [proof for proof in self._proofs if proof.exercise == exercise]
        every = [one for proof in own for one in self._proven[proof]]
        checks = {check.id for one in every for check in one.result.checks}
        mistakes = [one for one in every if one.proof.kind is ProofKind.MISTAKE]
        covered = {name for one in mistakes for name in failed_by(one.result)}
        solved = next((one.result for one in every if one.proof.kind is ProofKind.SOLUTION), None)
        solution, others, starter, known = (
            self._count([proof for proof in own if proof.kind is kind]) for kind in ProofKind
        )
        return ProofRow(
            exercise,
            solution,
            others,
            starter,
            known,
            len(covered & checks),
            len(checks),
            solved.max_points if solved and solved.checks else None,
            sum(one.seconds for one in every),
            next((_lack(one.result) for one in every if is_missing(one)), None),
        )

    def _count(self, proofs: Sequence[Proof]) -> Count:
        done = [proof for proof in proofs if self._is_done(proof)]
        return Count(sum(not self.findings_of(proof) for proof in done), len(done), len(proofs))

    def _is_done(self, proof: Proof) -> bool:
        """A proof that failed once is not repeated."""
        each = [one for one in self._proven[proof] if not is_missing(one)]
        return len(each) == self._turns or any(self._claims.faults(one) for one in each)


def _lack(result: Result) -> str:
    return result.fault.summary if result.fault else "something is missing"


def _called(proof: Proof) -> str:
    if proof.kind is ProofKind.MISTAKE:
        return f"mistake `{proof.name}`"
    name = f" `{proof.name}`" if proof.name else ""
    return f"the {proof.kind.value}{name} of {proof.exercise}"


def _verdict(result: Result) -> tuple[object, ...]:
    """The part of a result that must be the same in each grading."""
    return (result.verdict, *((check.id, check.outcome) for check in result.checks))


def _said(result: Result) -> str:
    by_outcome: dict[str, list[str]] = {}
    for check in result.checks:
        if check.outcome is not Outcome.PASSED:
            by_outcome.setdefault(check.outcome.value, []).append(f"`{check.id}`")
    parts = [f"{outcome}: {', '.join(names)}" for outcome, names in by_outcome.items()]
    return ", ".join((result.verdict.value, *parts))


Place = tuple[Path, int | None]


class SourcePlaces:
    """Where proofs come from in the course's files. Reads each file once."""

    def __init__(self) -> None:
        self._lessons = cache(read_lesson)
        self._mistakes = cache(read_mistakes)
        self._alternatives = cache(lambda solution: tuple(read_alternatives(solution)))

    def of(self, exercise: Exercise, proof: Proof) -> Place:
        """The place of the mistake or alternative; for the solution and the starter, that of the exercise."""
        if proof.kind is ProofKind.MISTAKE:
            return self._of_mistake(exercise, proof.name)
        if proof.kind is ProofKind.ALTERNATIVE:
            return self._of_alternative(exercise, proof.name)
        return self._of_exercise(exercise)

    def _of_exercise(self, exercise: Exercise) -> Place:
        reading = self._lessons(exercise.folder)
        ids = [one["id"] for one in reading.value["exercises"]] if reading.value else []
        place = ("exercises", ids.index(exercise.id), "id") if exercise.id in ids else ()
        return exercise.folder / LESSON, reading.line(place)

    def _of_mistake(self, exercise: Exercise, name: str) -> Place:
        reading = self._mistakes(exercise.folder)
        ids = [mistake.id for mistake in reading.value or ()]
        return exercise.folder / MISTAKES, reading.line(("mistakes", ids.index(name), "id"))

    def _of_alternative(self, exercise: Exercise, name: str) -> Place:
        for reading in self._alternatives(exercise.solution):
            if reading.value and reading.value.name == name:
                place = ("exercises", reading.value.exercises.index(exercise.id))
                return reading.value.tree / ALTERNATIVE, reading.line(place)
        return exercise.solution / "alternatives" / name / ALTERNATIVE, None
