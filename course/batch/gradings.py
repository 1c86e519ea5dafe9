"""Gradings of a class, as the work of a pool of processes."""

from __future__ import annotations

from collections.abc import Callable

from course.batch.model import Graded, Task, graded_from_line, task_to_line
from course.batch.pool import Pool, Work, Worker
from course.feedback import Feedback
from course.grading.result import Result, Verdict

NextTask = Callable[[], Task | None]


def _answers(task: Task, graded: Graded) -> bool:
    return graded.unit == task.unit


def _failed(task: Task, how: str) -> Graded:
    """Ours, whatever the submission did."""
    fault = Feedback(summary=f"The worker that graded it {how}.")
    return Graded(task.unit, Result(task.unit.exercise, Verdict.OUR_ERROR, fault=fault), 0.0)


GRADINGS = Work("course.batch.worker", task_to_line, graded_from_line, _answers, _failed)


class GradingPool(Pool[Task, Graded]):
    """`jobs` workers that grade; see `Pool`."""

    def __init__(self, jobs: int, next_task: NextTask) -> None:
        super().__init__(GRADINGS, jobs, next_task)


class GradingProcess(Worker[Task, Graded]):
    """One worker, for who hands out gradings by themselves."""

    def __init__(self) -> None:
        super().__init__(GRADINGS)

    def grade(self, task: Task) -> Graded:
        return self.do(task)
