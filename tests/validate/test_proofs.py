"""What has to be proven, in an order that keeps the machine busy."""

from __future__ import annotations

from pathlib import Path

import pytest

from course.content import open_course
from course.errors import ContentError
from course.validate.proof_results import SourcePlaces
from course.validate.proofs import Proof, ProofKind, gradable, proofs, starter_builds
from tests.conftest import FIXTURES
from tests.validate.conftest import QUIZ, edit


def test_everything_that_a_course_claims_is_proven_once() -> None:
    planned = proofs(open_course(FIXTURES / "quiz_course").exercises())
    assert len(set(planned)) == len(planned)
    assert {proof for proof in planned if proof.exercise == QUIZ} == {
        Proof(QUIZ, ProofKind.SOLUTION),
        Proof(QUIZ, ProofKind.ALTERNATIVE, "other-words"),
        Proof(QUIZ, ProofKind.STARTER),
        Proof(QUIZ, ProofKind.MISTAKE, "saves-oil"),
        Proof(QUIZ, ProofKind.MISTAKE, "nothing-answered"),
        Proof(QUIZ, ProofKind.MISTAKE, "whole-file-wrong"),
    }


@pytest.mark.slow
def test_the_course_s_own_proofs() -> None:
    course = open_course()
    planned = proofs(course.exercises())
    counts = [sum(proof.kind is kind for proof in planned) for kind in ProofKind]
    exercises = course.exercises()
    assert counts == [
        sum(not one.local_only for one in exercises),
        sum(len(one.alternatives()) for one in exercises),
        len(exercises),
        sum(len(one.mistakes()) for one in exercises),
    ]
    assert Proof("02-venv", ProofKind.SOLUTION) not in planned


@pytest.mark.slow
def test_what_takes_long_comes_first() -> None:
    planned = proofs(open_course().exercises())
    kinds = [proof.kind for proof in planned]
    assert kinds.index(ProofKind.ALTERNATIVE) == kinds.count(ProofKind.SOLUTION)
    solutions = [proof.exercise for proof in planned if proof.kind is ProofKind.SOLUTION]
    assert solutions.index("18-publisher") < solutions.index("01-alias") < solutions.index("10-run-quiz")


def test_a_grader_that_cannot_be_loaded_is_left_to_the_texts(quiz_course: Path) -> None:
    course = open_course(quiz_course)
    assert len(gradable(course.exercises())) == 2
    (quiz_course / "graders/ch05_lighthouses.py").write_text("def broken(:\n")
    assert gradable(course.exercises()) == ()


def test_mistakes_that_cannot_be_read_are_an_error(quiz_course: Path) -> None:
    (quiz_course / "chapters/05-lighthouses/mistakes.yaml").write_text("mistakes: 5\n")
    with pytest.raises(ContentError):
        proofs(open_course(quiz_course).exercises())


def test_only_a_starter_with_packages_must_build(small_course: Path) -> None:
    light, dim = open_course(small_course).exercises()
    assert starter_builds(light) and starter_builds(dim)
    quiz, keepers = open_course(FIXTURES / "quiz_course").exercises()
    assert not starter_builds(quiz) and not starter_builds(keepers)


def test_each_claim_has_its_place(quiz_course: Path) -> None:
    chapter = quiz_course / "chapters/05-lighthouses"
    keepers = open_course(quiz_course).exercise("05-keepers")
    alternative = quiz_course / "solutions/05-lighthouses/alternatives/other-words/alternative.yaml"
    lesson = edit(chapter / "lesson.yaml", "id: 05-keepers", "id: 05-keepers")
    mistake = edit(chapter / "mistakes.yaml", "id: not-greeted", "id: not-greeted")
    places = SourcePlaces()
    assert places.of(keepers, Proof(keepers.id, ProofKind.SOLUTION)) == (chapter / "lesson.yaml", lesson)
    assert places.of(keepers, Proof(keepers.id, ProofKind.STARTER)) == (chapter / "lesson.yaml", lesson)
    assert places.of(keepers, Proof(keepers.id, ProofKind.MISTAKE, "not-greeted")) == (
        chapter / "mistakes.yaml",
        mistake,
    )
    assert places.of(keepers, Proof(keepers.id, ProofKind.ALTERNATIVE, "other-words")) == (alternative, 1)
