"""What a course claims about each proof, and whether the proof's result agrees."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Iterator

from course.content import Exercise, Mistake
from course.grading.attempts import ATTEMPTS, MOST_LAG, deserves_another
from course.grading.author import BUILDS
from course.model.feedback import Feedback, Location
from course.model.result import CheckResult, Outcome, Result, Verdict
from course.spelling import in_one_line
from course.validate.proofs import Proof, ProofKind, ProofResult, starter_builds


class Claims:
    """The claims about these exercises. Raises ContentError if their mistakes cannot be read."""

    def __init__(self, exercises: Iterable[Exercise]) -> None:
        self._exercises = {exercise.id: exercise for exercise in exercises}
        every = (mistake for exercise in self._exercises.values() for mistake in exercise.mistakes())
        self._mistakes = {(mistake.exercise, mistake.id): mistake for mistake in every}
        # The proofs that failed, by the exercise and the place in its grader.
        self._faulty: defaultdict[tuple[str, Location], set[tuple[Proof, int, int]]] = defaultdict(set)

    def faults(self, proven: ProofResult) -> list[str]:
        """What differs from the claims, in words. Nothing if this machine lacks what the proof needs."""
        proof, result = proven.proof, proven.result
        if is_missing(proven):
            return []
        if proof.kind is ProofKind.STARTER:
            return does_not_pass(result, builds=starter_builds(self._exercises[proof.exercise]))
        if proof.kind is ProofKind.MISTAKE:
            faults = is_caught(result, self._mistakes[proof.exercise, proof.name])
            return [*faults, proven.misled] if proven.misled else faults
        return earns_all(result)

    def only_follows(self, proven: ProofResult, solution: Result) -> bool:
        """Whether a mistake's faults are only in checks that the solution itself does not pass either."""
        mistake = self._mistakes[proven.proof.exercise, proven.proof.name]
        differs = failed_by(proven.result) ^ {mistake.caught_by, *mistake.also_fails}
        check = next((one for one in proven.result.checks if one.id == mistake.caught_by), None)
        if check and not all(word in words_of(check.feedback) for word in mistake.says):
            differs |= {check.id}
        wrong = {one.id for one in solution.checks if one.outcome is not Outcome.PASSED}
        return not any(_errors(proven.result)) and differs <= wrong

    def deserves_another(self, proven: ProofResult) -> bool:
        """Whether something is wrong that may be due to the machine or to a fault of the engine.

        Call it again before you repeat the proof: others may have failed at the same line of the grader.
        """
        # On a busy machine, a check may also miss a mistake.
        busy = proven.result.timing.lag > MOST_LAG and proven.attempt < ATTEMPTS
        if fault := fault_of_grader(proven.result):
            failed_here = self._faulty[proven.proof.exercise, fault.where[0]]
            failed_here.add((proven.proof, proven.turn, proven.attempt))
            if not busy or len(failed_here) > 1:
                return False  # it would fail at the same line again
        doubtful = proven.laid and (busy or deserves_another(proven.result, proven.attempt))
        return doubtful and bool(self.faults(proven))


def fault_of_grader(result: Result) -> Feedback | None:
    """An error in the grader's own code, with its line in `where`."""
    told = (result.fault, *(check.feedback for check in result.checks if check.outcome is Outcome.ERROR))
    return next((feedback for feedback in told if feedback and feedback.where), None)


def is_missing(proven: ProofResult) -> bool:
    """Whether this machine lacks what the proof needs."""
    return proven.result.verdict is Verdict.NOT_AVAILABLE


def earns_all(result: Result) -> list[str]:
    """A right solution: every check passed, bonus included."""
    return [*_not_earned(result)]


def does_not_pass(result: Result, *, builds: bool = False) -> list[str]:
    """A starter: it runs, but there is something left to do. builds: its packages build already."""
    return [*_let_through(result, builds)]


def is_caught(result: Result, mistake: Mistake) -> list[str]:
    """A known mistake: only the claimed checks fail, and the one that catches it says the claimed words."""
    return [*_slips(result, mistake)]


def failed_by(result: Result) -> frozenset[str]:
    return frozenset(check.id for check in result.checks if check.outcome is Outcome.FAILED)


def words_of(feedback: Feedback | None) -> str:
    """All of it that a learner reads."""
    if feedback is None:
        return ""
    parts = (feedback.summary, feedback.expected, feedback.seen, feedback.advice)
    return "\n".join([part for part in parts if part] + [*map(str, feedback.where), *feedback.details])


def _not_earned(result: Result) -> Iterator[str]:
    yield from _errors(result)
    for check in result.checks:
        if check.outcome not in (Outcome.PASSED, Outcome.ERROR):
            yield f"`{check.id}` {_ended(check)}"
    if not result.fault and result.verdict is not Verdict.PASSED:
        yield f'its verdict is "{result.verdict.value}"'
    if result.verdict is Verdict.PASSED and not result.points >= result.max_points > 0:
        yield f"it earns {result.points:g} of {result.max_points:g} points"


def _let_through(result: Result, builds: bool) -> Iterator[str]:
    yield from _errors(result)
    if not result.fault and result.verdict is Verdict.PASSED:
        yield "it passes: there is nothing left to do for a learner"
    elif not result.fault and result.verdict not in (Verdict.NOT_PASSED, Verdict.OUR_ERROR):
        yield f'its verdict is "{result.verdict.value}"'
    for check in result.checks:
        if builds and check.id == BUILDS and check.outcome is not Outcome.PASSED:
            yield f"`{check.id}` {_ended(check)}"


def _slips(result: Result, mistake: Mistake) -> Iterator[str]:
    yield from _errors(result)
    if result.fault:
        return
    by_id, failed = {check.id: check for check in result.checks}, failed_by(result)
    if mistake.caught_by not in failed:
        yield f"`{mistake.caught_by}` does not catch it: {_instead(mistake.caught_by, by_id)}"
    else:
        said = words_of(by_id[mistake.caught_by].feedback)
        for word in mistake.says:
            if word not in said:
                yield f'`{mistake.caught_by}` does not say "{word}", but: {in_one_line(said)}'
    yield from _others(mistake, by_id, failed)
    # If only bonus checks fail, the exercise passes. Our own errors are reported above.
    wanted = Verdict.PASSED if all(by_id[name].bonus for name in failed) else Verdict.NOT_PASSED
    if mistake.caught_by in failed and result.verdict not in (wanted, Verdict.OUR_ERROR):
        yield f'its verdict is "{result.verdict.value}"'


def _others(mistake: Mistake, by_id: dict[str, CheckResult], failed: frozenset[str]) -> Iterator[str]:
    for name in sorted(failed - {mistake.caught_by, *mistake.also_fails}):
        yield f"it fails `{name}`, too: {in_one_line(words_of(by_id[name].feedback))}"
    for name in sorted({*mistake.also_fails} - failed - {mistake.caught_by}):
        yield f"it does not fail `{name}`, which `also_fails` names"


def _instead(name: str, by_id: dict[str, CheckResult]) -> str:
    check = by_id.get(name)
    if check is None:
        return f"there is no such check; there are {', '.join(by_id) or 'none'}"
    return f"the check {_ended(check)}"


def _errors(result: Result) -> Iterator[str]:
    if result.fault:
        yield f"it could not be judged: {in_one_line(words_of(result.fault))}"
    for check in result.checks:
        if check.outcome is Outcome.ERROR:
            yield f"`{check.id}` could not be judged: {in_one_line(words_of(check.feedback))}"


def _ended(check: CheckResult) -> str:
    because = check.skipped_because or (check.feedback.summary if check.feedback else "")
    how = {Outcome.SKIPPED: "was skipped", Outcome.NOT_APPLICABLE: "was not applicable"}.get(
        check.outcome, check.outcome.value
    )
    return f"{how}: {in_one_line(because)}" if because and check.outcome is not Outcome.PASSED else how
