"""Proofs run until there is a verdict that the machine has not spoiled, at most three times."""

from __future__ import annotations

from pathlib import Path

import pytest

from course.content import open_course
from course.model import replace
from course.validate import schedule
from course.validate.proof_results import ProofResults
from course.validate.proofs import PROOFS, Proof, ProofKind, proofs
from course.validate.schedule import run
from tests.conftest import FIXTURES
from tests.processes import none_stays
from tests.validate.conftest import QUIZ

COURSE = open_course(FIXTURES / "quiz_course")
EXERCISE = COURSE.exercise(QUIZ)
MISTAKE = Proof(QUIZ, ProofKind.MISTAKE, "saves-oil")


@pytest.fixture
def ways(monkeypatch: pytest.MonkeyPatch) -> pytest.MonkeyPatch:
    monkeypatch.setattr(schedule, "PROOFS", replace(PROOFS, worker="tests.validate.odd_worker"))
    return monkeypatch


@pytest.mark.slow
@pytest.mark.parametrize(
    ("way", "attempts", "held"),
    [
        ("caught", 1, True),
        ("slips", 1, False),
        ("caught-busy", 1, True),  # what holds is not looked at again
        ("slips-busy caught", 2, True),
        ("slips-busy slips", 2, False),
        ("slips-busy slips-busy slips-busy caught", 3, False),
        ("ours caught", 2, True),
        ("ours", 3, False),
        ("grader", 1, False),
        ("grader-busy", 2, False),  # it is the only one that fails at this line
        ("dies caught", 2, True),
        ("unlaid", 1, False),
        ("missing", 1, None),
    ],
)
def test_what_is_doubtful_is_done_again(
    ways: pytest.MonkeyPatch, way: str, attempts: int, held: bool | None
) -> None:
    ways.setenv("WAYS", way)
    (proven,) = run(COURSE.root, [EXERCISE], [MISTAKE], jobs=2)
    account = ProofResults([EXERCISE], [MISTAKE])
    assert (proven.attempt, account.add(proven)) == (attempts, held)
    assert account.again == attempts - 1
    assert len(account.findings()) == (held is False)
    assert (account.why_not(MISTAKE) == "There is no ROS.") is (held is None)


@pytest.mark.slow
def test_what_several_proofs_say_of_the_grader_is_not_done_again(ways: pytest.MonkeyPatch) -> None:
    ways.setenv("WAYS", "grader-busy")
    planned = proofs([EXERCISE])
    ran = list(run(COURSE.root, [EXERCISE], planned, jobs=2))
    assert sorted((one.proof for one in ran), key=str) == sorted(planned, key=str)
    assert {one.attempt for one in ran} == {1}


@pytest.mark.slow
def test_each_turn_runs_everything(ways: pytest.MonkeyPatch) -> None:
    ways.setenv("WAYS", "caught")
    planned = proofs([EXERCISE])
    ran = [(one.turn, one.proof) for one in run(COURSE.root, [EXERCISE], planned, jobs=2, turns=3)]
    assert sorted(ran, key=str) == sorted([(turn, proof) for turn in (1, 2, 3) for proof in planned], key=str)


@pytest.mark.slow
def test_whoever_stops_listening_ends_the_workers_and_nothing_is_left(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path))
    with none_stays():
        results = run(COURSE.root, [EXERCISE], proofs([EXERCISE]), jobs=1)
        next(results)
        assert list(tmp_path.iterdir())
        results.close()
        assert list(tmp_path.iterdir()) == []
