"""Judges the recordings of one exercise by mutants of its grader: do the course's claims still hold?"""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from course.content import Mistake, open_course
from course.evidence.mcap_file import load
from course.evidence.recording import Recording
from course.grading.judge.plugin import judge
from course.grading.protocol import Judgment
from course.model import replace
from course.model.result import Result, Verdict, from_json, verdict_of
from course.rosenv import cache_dir
from course.validate.claims import earns_all, is_caught
from course.validate.proofs import Proof, ProofKind
from course_mutation.model import Case, Evidence, Fate, Mutated

_LONGEST = 300


@dataclass(frozen=True)
class _Proven:
    """A proof with its recording. before: its result. mistake: None for a right way."""

    proof: Proof
    recording: Recording
    before: Result
    mistake: Mistake | None

    def complaints(self, judgment: Judgment, questions: set[str]) -> tuple[Result, list[str]]:
        """How the result of this judgment differs from what the course claims."""
        asked = tuple(check for check in self.before.checks if check.id in questions)
        checks = (*judgment.checks, *asked)
        verdict = Verdict.OUR_ERROR if judgment.fault else verdict_of(checks)
        result = replace(self.before, checks=checks, verdict=verdict, fault=judgment.fault)
        return result, is_caught(result, self.mistake) if self.mistake else earns_all(result)


class Judge:
    """problems: the proofs that fail even with the unchanged grader; they are not used."""

    def __init__(self, case: Case) -> None:
        course = open_course(Path(case.course), cache=cache_dir(os.environ) / "lessons")
        self._exercise = course.exercise(case.exercise)
        self._questions = {question.id for question in self._exercise.questions}
        self._text = case.text.encode()
        self._folder = _stage(course.root, Path(case.folder))
        mistakes = {mistake.id: mistake for mistake in self._exercise.mistakes()}
        self._proven = [_loaded(proven, mistakes) for proven in case.evidence]
        self.problems = self._as_it_is()

    def judge(self, mutated: Mutated, index: int) -> tuple[Fate, str]:
        """The mutant's fate, and the proof that decided it; the first that notices ends the search."""
        text = self._text[: mutated.start] + mutated.new.encode() + self._text[mutated.end :]
        proofs = sorted(self._proven, key=lambda proven: _order(proven, mutated.checks))
        for proven, result, said in self._judged(text, str(index), proofs):
            if said:
                fate = Fate.BROKEN if result.verdict is Verdict.OUR_ERROR else Fate.KILLED
                return fate, f"{proven.proof.kind.value} {proven.proof.name}".strip() + f": {said[0]}"[
                    :_LONGEST
                ]
        return Fate.SURVIVED, ""

    def _as_it_is(self) -> list[str]:
        judged = self._judged(self._text, "", self._proven, to_the_end=True)
        bad = {proven.proof: said[0] for proven, _, said in judged if said}
        self._proven = [proven for proven in self._proven if proven.proof not in bad]
        return [f"{proof}: {said}" for proof, said in bad.items()]

    def _judged(
        self, text: bytes, suffix: str, proofs: Sequence[_Proven], *, to_the_end: bool = False
    ) -> list[tuple[_Proven, Result, list[str]]]:
        """Each proof with its complaints, up to the first proof that has any."""
        judged: list[tuple[_Proven, Result, list[str]]] = []

        def recordings() -> Iterator[Recording]:
            for proven in proofs:
                if to_the_end or not judged or not judged[-1][2]:
                    yield proven.recording

        def tell(judgment: Judgment) -> None:
            proven = proofs[len(judged)]
            judged.append((proven, *proven.complaints(judgment, self._questions)))

        # A unique name, because Python caches modules by name.
        file = self._folder / f"{self._exercise.grader.stem}_mutant{suffix}.py"
        file.write_bytes(text)
        judge(file, {self._exercise.id}, recordings(), tell)
        return judged


def _loaded(proven: Evidence, mistakes: dict[str, Mistake]) -> _Proven:
    proof = proven.proof
    before = from_json(Path(proven.result).read_text(encoding="utf-8"))
    mistake = mistakes[proof.name] if proof.kind is ProofKind.MISTAKE else None
    return _Proven(proof, load(Path(proven.recording)), before, mistake)


def _order(proven: _Proven, checks: Sequence[str]) -> int:
    """A sort key: first those most likely to notice, which are mistakes that these checks should catch."""
    if proven.mistake is None:
        return 2 if proven.proof.kind is ProofKind.SOLUTION else 3
    if proven.mistake.caught_by in checks:
        return 0
    return 1 if set(proven.mistake.also_fails) & set(checks) else 4


def _stage(root: Path, folder: Path) -> Path:
    """A folder that looks to graders like that of the course."""
    for part in root.iterdir():
        if part.name != "graders":
            (folder / part.name).symlink_to(part)
    graders = folder / "graders"
    graders.mkdir()
    for beside in (root / "graders").iterdir():
        if beside.name != "__pycache__":
            (graders / beside.name).symlink_to(beside)
    return graders
