"""The results of proofs: counts for the table, and findings at the lines with the claims."""

from __future__ import annotations

from course.content import open_course
from course.model import replace
from course.model.feedback import Feedback, Location
from course.model.result import CheckResult, Outcome, Result, Timing, Verdict, verdict_of
from course.report.validation import Count
from course.validate.claims import Claims
from course.validate.proof_results import ProofResults
from course.validate.proofs import Proof, ProofKind, ProofResult
from tests.conftest import FIXTURES
from tests.validate.conftest import QUIZ

EXERCISE = open_course(FIXTURES / "quiz_course").exercise(QUIZ)
SOLUTION = Proof(QUIZ, ProofKind.SOLUTION)
MISTAKE = Proof(QUIZ, ProofKind.MISTAKE, "saves-oil")
OTHER = Proof(QUIZ, ProofKind.MISTAKE, "nothing-answered")
RIGHT = tuple(CheckResult(name, name, 2, Outcome.PASSED) for name in ("why", "seen"))
WRONG = (
    replace(RIGHT[0], outcome=Outcome.FAILED, feedback=Feedback("burns all the time, 05-quiz.yaml")),
    RIGHT[1],
)


def proven(proof: Proof, checks: tuple[CheckResult, ...], turn: int = 1) -> ProofResult:
    return ProofResult(proof, turn, 1, Result(QUIZ, verdict_of(checks), checks), 1.5)


def account(*each: ProofResult, turns: int = 1) -> ProofResults:
    made = ProofResults([EXERCISE], [SOLUTION, MISTAKE, OTHER], turns)
    for one in each:
        made.add(one)
    return made


def test_what_is_not_done_yet_is_neither_held_nor_broken() -> None:
    (row,) = account(proven(SOLUTION, RIGHT), proven(MISTAKE, WRONG)).rows()
    assert row.solution == Count(1, 1, 1)
    assert row.mistakes == Count(1, 1, 2)
    assert row.starter == Count(0, 0, 0)
    assert (row.covered, row.checks, row.points, row.seconds, row.missing) == (1, 2, 4, 3.0, None)


def test_a_finding_stands_where_it_is_claimed() -> None:
    (found,) = account(proven(MISTAKE, RIGHT)).findings()
    assert (found.file.name, found.exercise) == ("mistakes.yaml", QUIZ)
    assert found.line and "saves-oil" in found.file.read_text().splitlines()[found.line - 1]
    assert found.what == "mistake `saves-oil`: `why` does not catch it: the check passed"
    assert found.next_step and "`caught_by`" in found.next_step


def test_with_several_turns_a_proof_holds_when_it_held_in_all() -> None:
    once = account(proven(MISTAKE, WRONG), turns=2)
    assert once.rows()[0].mistakes == Count(0, 0, 2)
    twice = account(proven(MISTAKE, WRONG), proven(MISTAKE, WRONG, 2), turns=2)
    assert twice.rows()[0].mistakes == Count(1, 1, 2)
    assert twice.findings() == []


def test_a_verdict_that_changes_is_told_with_both() -> None:
    (found,) = account(
        *(proven(MISTAKE, WRONG, n) for n in (1, 2)), proven(MISTAKE, RIGHT, 3), turns=3
    ).findings()
    assert found.what == (
        "mistake `saves-oil` was judged differently: round 1: not passed, failed: `why`; round 3: passed"
    )


def test_what_changes_beside_the_verdict_is_told_too() -> None:
    other = (WRONG[0], replace(RIGHT[1], outcome=Outcome.SKIPPED, skipped_because='needs "x"'))
    (found,) = account(proven(MISTAKE, WRONG), proven(MISTAKE, other, 2), turns=2).findings()
    assert "was judged differently" in found.what and "skipped: `seen`" in found.what


def test_what_is_missing_here_is_no_finding() -> None:
    lacking = Result(QUIZ, Verdict.NOT_AVAILABLE, fault=Feedback("There is no ROS."))
    made = account(ProofResult(SOLUTION, 1, 1, lacking, 0.1))
    assert made.findings() == [] and made.lacking
    assert made.rows()[0].missing == "There is no ROS."
    assert made.why_not(MISTAKE) == "It was stopped before."


def test_a_fault_of_the_grader_is_one_finding_at_its_own_line() -> None:
    fault = Feedback("The grader itself failed here.", where=(Location("/c/graders/ch05.py", 7),))
    broken = Result(QUIZ, Verdict.OUR_ERROR, fault=fault)
    every = [ProofResult(proof, 1, 1, broken, 1.0) for proof in (SOLUTION, MISTAKE, OTHER)]
    (found,) = account(*every).findings()
    assert (str(found.file), found.line) == ("/c/graders/ch05.py", 7)
    assert found.what == f"The grader itself failed here. 3 of {QUIZ}'s proofs could not be judged."
    claims = Claims([EXERCISE])
    assert not any(claims.deserves_another(one) for one in every)
    assert claims.deserves_another(replace(every[0], result=replace(broken, fault=Feedback("It broke."))))
    busy = [replace(one, result=replace(broken, timing=Timing(lag=9.0))) for one in every]
    alone = Claims([EXERCISE])
    assert [alone.deserves_another(one) for one in (busy[0], busy[0], *busy[1:], busy[0])] == [
        *(True, True),
        *(False, False, False),
    ]


def test_a_mistake_that_only_fails_as_the_solution_does_is_counted_there() -> None:
    seen = replace(RIGHT[1], outcome=Outcome.FAILED, feedback=Feedback("Nothing was seen."))
    both = (WRONG[0], seen)
    (found,) = account(proven(SOLUTION, (RIGHT[0], seen)), proven(MISTAKE, both)).findings()
    assert found.what.startswith(f"the solution of {QUIZ}: `seen` failed: Nothing was seen.")
    assert found.what.endswith("; 1 mistake fails the same checks, and is not listed")
    caught_by_nothing = proven(MISTAKE, (RIGHT[0], seen))
    solution, mistake = account(proven(SOLUTION, (RIGHT[0], seen)), caught_by_nothing).findings()
    assert "and is not listed" not in solution.what
    assert mistake.what.startswith("mistake `saves-oil`: `why` does not catch it: the check passed")
