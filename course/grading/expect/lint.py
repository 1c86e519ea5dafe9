"""What is expected of the style of Python files, by the rules of a linter."""

from __future__ import annotations

from collections.abc import Sequence

from course.evidence.recording import Recording
from course.feedback import Failure, Feedback
from course.grading.explain.lint import UNREADABLE, Finding, findings

_SHOWN = 8


def expect_readable(recording: Recording, name: str = "lint") -> None:
    """Python can read every file that the linter looked at."""
    broken = findings(recording, UNREADABLE, name=name)
    if broken:
        raise Failure(
            Feedback(
                summary=f"Python cannot read `{_file(broken[0])}`: {broken[0].text}.",
                where=(broken[0].where,),
                advice="Look at this line, and at the end of the one before.",
            )
        )


def expect_no_findings(
    recording: Recording, rules: Sequence[str], what: str, *, advice: str, name: str = "lint"
) -> None:
    """The linter found nothing by these rules; else every finding is told with its file and line.

    what: what a finding means, to begin the sentence with.
    """
    found = findings(recording, *rules, name=name)
    if not found:
        return
    more = f", and {len(found) - 1} more" if len(found) > 1 else ""
    raise Failure(
        Feedback(
            summary=f"{what}: {found[0].text}{more}.",
            where=tuple(one.where for one in found),
            advice=advice,
            details=tuple(f"{_file(one)}:{one.where.line}  {one.text}" for one in found[:_SHOWN]),
        )
    )


def _file(finding: Finding) -> str:
    return finding.where.file.rpartition("/")[2]
