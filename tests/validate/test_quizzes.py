"""Each known wrong answer of a quiz is answered in the words that its entry claims."""

from __future__ import annotations

import contextlib
from pathlib import Path

import pytest

from course.content import Exercise, open_course
from course.grading.load import runs_programs
from course.validate.claims import Claims
from course.validate.proofs import ProofKind, ProofTask, proofs
from course.validate.prover import Prover

COURSE = open_course()
QUIZZES = [one for one in COURSE.exercises() if one.questions and not runs_programs(one) and not one.packages]


@pytest.mark.parametrize("quiz", QUIZZES, ids=[quiz.id for quiz in QUIZZES])
def test_wrong_answers_are_told_as_claimed(quiz: Exercise, tmp_path: Path) -> None:
    claims = Claims([quiz])
    with contextlib.closing(Prover()) as prover:
        for proof in proofs([quiz]):
            if proof.kind is ProofKind.MISTAKE:
                proven = prover.run(ProofTask(proof, 1, str(COURSE.root), str(tmp_path)))
                assert not claims.faults(proven), proof
