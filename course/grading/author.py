"""What a grader module consists of: one `Grader` per exercise, with its scenario and its checks.

    publisher = Grader("18-publisher")

    @publisher.scenario
    def five_quotes(arena): ...

    @publisher.check("rate", "publishes twice per second", points=2, needs="publishes")
    def twice_per_second(recording): ...

The scenario acts and runs once; checks are pure functions of the recording. All of them
remain plain functions: pytest collects them, including fixtures, through `judge.plugin`.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from math import inf
from typing import TYPE_CHECKING, Any, TypeVar

from course.errors import OurFault
from course.evidence.recording import Recording
from course.model.feedback import Failure

if TYPE_CHECKING:
    from course.arena.arena import Arena

Scenario = Callable[["Arena"], None]
_Function = TypeVar("_Function", bound=Callable[..., Any])

BUILDS = "builds"


@dataclass(frozen=True)
class CheckSpec:
    """One check as its author declared it.

    id: unique in the exercise and stable. needs: ids of checks that must pass; otherwise this one is
    skipped.
    """

    id: str
    title: str
    points: float
    bonus: bool
    needs: tuple[str, ...]
    exercise: str


class Grader:
    """The grader of one exercise: at most one scenario, and the checks in order.

    builds: points for the check that the packages build. It comes first, and every other check needs it
    unless declared otherwise. None for an exercise without packages. ros: False if the scenario does not
    use ROS, which is then not started. sanitizers: True if the scenario compiles programs with the address
    sanitizer (`arena.cpp.compile`), which needs more address space than a submission's programs usually
    get.
    """

    def __init__(
        self, exercise: str, *, builds: float | None = 1, ros: bool = True, sanitizers: bool = False
    ) -> None:
        self.exercise = exercise
        self.ros = ros
        self.sanitizers = sanitizers
        self.scenario_function: Scenario | None = None
        self.checks: dict[str, CheckSpec] = {}
        self.functions: dict[str, Callable[..., Any]] = {}
        if builds is not None:
            self._add(CheckSpec(BUILDS, "the packages build", builds, False, (), exercise), _packages_build)

    def scenario(self, function: Scenario) -> Scenario:
        """Decorator: this function acts in the arena, and returns when the evidence is complete."""
        if self.scenario_function is not None:
            raise OurFault(f"{self.exercise} has two scenarios")
        self.scenario_function = function
        return function

    def check(
        self,
        id: str,
        title: str,
        *,
        points: float = 1,
        bonus: bool = False,
        needs: str | Sequence[str] | None = None,
    ) -> Callable[[_Function], _Function]:
        """Decorator: this function judges the recording.

        It returns if all is well, and raises `course.model.feedback.Failure`, as each `expect_*` does, if
        the learner's work is wrong. Any other exception is our error, except
        `course.model.feedback.NotApplicable`: the work cannot be judged here, which is nobody's fault and
        costs no points. needs: ids of checks; by default, that the packages build; () for none.
        """
        wanted = (
            self._default_needs() if needs is None else ((needs,) if isinstance(needs, str) else tuple(needs))
        )

        def register(function: _Function) -> _Function:
            self._add(CheckSpec(id, title, points, bonus, wanted, self.exercise), function)
            return function

        return register

    def _default_needs(self) -> tuple[str, ...]:
        return (BUILDS,) if BUILDS in self.checks else ()

    def _add(self, spec: CheckSpec, function: Callable[..., Any]) -> None:
        if spec.id in self.checks:
            raise OurFault(f"{self.exercise} has two checks named {spec.id}")
        unknown = [need for need in spec.needs if need not in self.checks]
        if unknown:
            raise OurFault(
                f"check {spec.id} of {self.exercise} needs {unknown[0]}, which is not defined before it"
            )
        if not 0 < spec.points < inf:
            raise OurFault(
                f"check {spec.id} of {spec.exercise} is worth {spec.points:g} points",
                "give it more than 0 points; `bonus=True` is for a check that costs nothing when it fails",
            )
        self.checks[spec.id] = spec
        self.functions[spec.id] = function


def _packages_build(recording: Recording) -> None:
    if recording.packages.failure is not None:
        raise Failure(recording.packages.failure)
