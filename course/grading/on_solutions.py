"""`pytest graders/`: every grader judges the course's own reference solutions.

A pytest plugin, loaded by graders/conftest.py. Each exercise is graded once, in the same way as by
`ros2course check`; each of its checks is one test.
"""

from __future__ import annotations

import tempfile
from collections.abc import Iterator
from pathlib import Path

import pytest

from course.content import Exercise, open_course
from course.grading import trial, trial_answers
from course.grading.author import CheckSpec, Grader
from course.grading.check import Request, check_exercise
from course.model.result import Outcome, Result
from course.rosenv import find_ros

_RESULTS = pytest.StashKey[dict[str, Result]]()


class SolutionNode(pytest.Collector):
    """One exercise: its checks, judged on the reference solution."""

    grader: Grader

    def collect(self) -> Iterator[pytest.Item]:
        for spec in self.grader.checks.values():
            item = SolutionItem.from_parent(self, name=spec.id)
            item.spec = spec
            yield item


class SolutionItem(pytest.Item):
    """One check, which the reference solution must pass."""

    spec: CheckSpec

    def runtest(self) -> None:
        if _exercise(self).local_only:
            pytest.skip("no files can solve an exercise about the learner's own machine")
        result = _result(self)
        check = next((done for done in result.checks if done.id == self.spec.id), None)
        if check is None or check.outcome is not Outcome.PASSED:
            said = check.feedback if check else result.fault
            pytest.fail(f"{self.spec.exercise}: {self.spec.title}\n{said}", pytrace=False)

    def reportinfo(self) -> tuple[Path, int | None, str]:
        return self.path, None, f"{self.spec.exercise}: {self.spec.title}"


def pytest_collect_file(file_path: Path, parent: pytest.Collector) -> pytest.Module | None:
    """Collect the grader modules in a folder; pytest itself collects a file named on the command line."""
    if parent.session.isinitpath(file_path) or not file_path.match("graders/ch[0-9][0-9]_*.py"):
        return None
    return pytest.Module.from_parent(parent, path=file_path)


@pytest.hookimpl(tryfirst=True)
def pytest_pycollect_makeitem(collector: pytest.Collector, obj: object) -> list[pytest.Collector] | None:
    if not isinstance(obj, Grader):
        return None
    node = SolutionNode.from_parent(collector, name=obj.exercise)
    node.grader = obj
    return [node]


def _exercise(item: SolutionItem) -> Exercise:
    return open_course(item.path.parents[1]).exercise(item.spec.exercise)


def _result(item: SolutionItem) -> Result:
    """The exercise's result; it is graded once for all of its checks."""
    results = item.config.stash.setdefault(_RESULTS, {})
    exercise_id = item.spec.exercise
    if exercise_id not in results:
        course = open_course(item.path.parents[1])
        exercise = _exercise(item)
        with tempfile.TemporaryDirectory(prefix="ros2course-") as home:
            trial.lay_solution(course, exercise, Path(home))
            request = Request(exercise, Path(home), ros=find_ros(), seed=trial_answers.SEED)
            results[exercise_id] = check_exercise(request)
    return results[exercise_id]
