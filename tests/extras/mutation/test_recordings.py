"""Recordings are made once, and kept until something changes that they depend on."""

from __future__ import annotations

from collections.abc import Generator, Mapping, Sequence
from pathlib import Path
from types import SimpleNamespace

import pytest

from course.content import Course, Exercise, open_course
from course.evidence.mcap_file import save
from course.evidence.recording import Recording
from course.model.feedback import Feedback
from course.model.result import CheckResult, Outcome, Result, Verdict
from course.validate.proofs import Proof, ProofKind, ProofResult
from course_mutation import recordings as module
from course_mutation.recordings import Found, Keys, recordings

LIGHT = "ros2_tutorial_workspace/src/lanterns/lanterns/light.py"
SOLUTION = Proof("04-light", ProofKind.SOLUTION)
MISTAKE = Proof("04-light", ProofKind.MISTAKE, "too-dark")


class Runs:
    """Replaces running proofs: remembers which, and records nothing in particular."""

    def __init__(self) -> None:
        self.asked: list[Proof] = []
        self.verdicts: dict[Proof, Verdict] = {}

    def run(
        self,
        root: Path,
        exercises: Sequence[Exercise],
        proofs: Sequence[Proof],
        jobs: int,
        evidence: Mapping[Proof, Path],
    ) -> Generator[ProofResult, None, None]:
        for proof in proofs:
            self.asked.append(proof)
            evidence[proof].parent.mkdir(parents=True, exist_ok=True)
            save(Recording(proof.exercise, duration=1), evidence[proof], began_ns=0)
            yield ProofResult(proof, 1, 1, self._result(proof), 1.0)

    def _result(self, proof: Proof) -> Result:
        wrong = proof.kind is ProofKind.MISTAKE
        outcome = Outcome.FAILED if wrong else Outcome.PASSED
        told = Feedback("It shines with 10, not 100.") if wrong else None
        verdict = self.verdicts.get(proof, Verdict.NOT_PASSED if wrong else Verdict.PASSED)
        checks = (CheckResult("is_bright", "it is bright", 1, outcome, feedback=told),)
        fault = Feedback("busy") if proof in self.verdicts else None
        return Result(proof.exercise, verdict, checks, fault=fault)


@pytest.fixture
def runs(monkeypatch: pytest.MonkeyPatch) -> Runs:
    runs = Runs()
    monkeypatch.setattr(module, "run", runs.run)
    monkeypatch.setattr(module, "find_ros", lambda: SimpleNamespace(identity="jazzy"))
    return runs


def found(root: Path) -> Found:
    course = open_course(root)
    return recordings(course, course.exercise("04-light"), 1, lambda done, total: None)


def test_the_second_time_nothing_is_run(runs: Runs, small_course: Path) -> None:
    first = found(small_course)
    assert (first.made, runs.asked) == (2, [SOLUTION, MISTAKE])
    second = found(small_course)
    assert (second.made, second.recorded) == (0, first.recorded)
    assert len(runs.asked) == 2


def test_another_mistake_is_run_alone(runs: Runs, small_course: Path) -> None:
    found(small_course)
    file = small_course / "chapters/04-lanterns/mistakes.yaml"
    file.write_text(file.read_text().replace("return 10\n", "return 11\n"))
    changed = found(small_course)
    assert runs.asked[2:] == [MISTAKE]
    kept = {one.file for one in changed.recorded} | {one.result for one in changed.recorded}
    assert set(changed.recorded[0].file.parent.iterdir()) == kept  # the old one is forgotten


def test_what_cannot_be_read_is_made_again(runs: Runs, small_course: Path) -> None:
    first = found(small_course)
    first.recorded[0].file.write_bytes(b"rubbish")
    first.recorded[1].result.unlink()
    found(small_course)
    assert runs.asked[2:] == [SOLUTION, MISTAKE]


def test_what_does_not_hold_is_not_kept(runs: Runs, small_course: Path) -> None:
    runs.verdicts[MISTAKE] = Verdict.OUR_ERROR
    first = found(small_course)
    assert [one.proof for one in first.recorded] == [SOLUTION]
    assert first.problems == ("04-light mistake too-dark: it could not be judged: busy",)
    runs.verdicts = {MISTAKE: Verdict.NOT_AVAILABLE}
    assert found(small_course).problems == ("04-light mistake too-dark: busy",)
    runs.verdicts = {}
    assert found(small_course).made == 1


def keys(root: Path, ros: str = "jazzy") -> list[str]:
    course: Course = open_course(root)
    of = Keys(course, course.exercise("04-light"), ros)
    return [of.key(SOLUTION), of.key(MISTAKE)]


@pytest.mark.parametrize(
    ("file", "before", "after", "moves"),
    [
        ("solutions/04-lanterns/" + LIGHT, "100", "101", [True, True]),
        ("graders/ch04_lanterns.py", "wait(1)", "wait(2)", [True, True]),
        ("graders/ch04_lanterns.py", "mild = 1", "mild = 2", [False, False]),
        ("chapters/04-lanterns/mistakes.yaml", "return 10\n", "return 11\n", [False, True]),
        ("chapters/04-lanterns/mistakes.yaml", "hardly lit", "dark", [False, False]),
        ("chapters/04-lanterns/lesson.yaml", "id: 04-light", "id: 04-light\n    time_limit: 7", [True, True]),
        ("chapters/04-lanterns/lesson.yaml", "It shines.", "Well done.", [False, False]),
    ],
)
def test_keys(small_course: Path, file: str, before: str, after: str, moves: list[bool]) -> None:
    (small_course / "graders/ch04_lanterns.py").write_text(
        """\
from course.api import Grader
light = Grader("04-light")

@light.scenario
def shine(arena):
    arena.wait(1)

@light.check("is_bright", "it is bright")
def is_bright(recording):
    mild = 1
"""
    )
    old, path = keys(small_course), small_course / file
    assert before in path.read_text()
    path.write_text(path.read_text().replace(before, after, 1))
    assert [one != other for one, other in zip(old, keys(small_course), strict=True)] == moves


def test_keys_of_another_ros(small_course: Path) -> None:
    assert not set(keys(small_course)) & set(keys(small_course, "rolling"))
