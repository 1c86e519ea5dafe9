"""Whether the machine was too busy to measure what a submission's programs do."""

from __future__ import annotations

from course.grading.result import Result, Timing, Verdict

# A recorder that had to wait longer than this cannot tell how regularly messages come.
MOST_LAG = 0.1
# Of one core: a submission that keeps more of them busy has itself to blame for what it misses.
_BUSY = 0.5


def is_doubtful(result: Result) -> bool:
    """Whether something was marked as wrong while the machine was too busy to know."""
    return result.verdict is Verdict.NOT_PASSED and was_disturbed(result.timing)


def was_disturbed(timing: Timing) -> bool:
    """Whether the machine was too busy to measure, and not with the submission's own programs."""
    return timing.lag > MOST_LAG and timing.cpu < _BUSY * max(timing.evidence, 1.0)
