"""Expectations of the style of Python files, by the rules of a linter."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass

from course.api import Failure, Feedback, Location, OurFault, Recording

_SHOWN = 8
# `pkg/a.py:3:5: N802 Function name ...`, as ruff writes it in its concise form.
UNREADABLE = "invalid-syntax"
_LINE = re.compile(rf"(?P<file>.+?):(?P<line>\d+):\d+: (?P<rule>[A-Z]+\d+|{UNREADABLE}):? (?P<text>.*)")
_DONE = (0, 1)


@dataclass(frozen=True)
class LintFinding:
    """One finding. rule: as the linter calls it (`N802`), or `invalid-syntax`."""

    rule: str
    where: Location
    text: str


def findings(recording: Recording, *prefixes: str, name: str = "lint") -> tuple[LintFinding, ...]:
    """Findings of rules with these prefixes (`N`, `D1`), by file and line; all findings if there are none.

    Raises OurFault if the linter did not finish.
    """
    view = recording.process(name)
    if view.exited is None or view.exited.code not in _DONE:
        raise OurFault(f"the linter failed: {' '.join(view.text[-3:]) or 'it said nothing'}")
    matches = (_LINE.fullmatch(line) for line in view.text)
    every = (
        LintFinding(m["rule"], Location(m["file"], int(m["line"])), m["text"].removeprefix("[*] "))
        for m in matches
        if m
    )
    return tuple(one for one in every if not prefixes or one.rule.startswith(prefixes))


def expect_readable(recording: Recording, name: str = "lint") -> None:
    """Expect that Python can parse every file that the linter read."""
    broken = findings(recording, UNREADABLE, name=name)
    if broken:
        raise Failure(
            Feedback(
                summary=f"Python cannot read `{_file(broken[0])}`: {broken[0].text}.",
                where=(broken[0].where,),
                advice="Check this line and the end of the line before it.",
            )
        )


def expect_no_findings(
    recording: Recording, rules: Sequence[str], what: str, *, advice: str, name: str = "lint"
) -> None:
    """Expect no findings of these rules; the feedback lists each finding with its file and line.

    what: the beginning of the feedback's summary; it says what a finding means.
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


def _file(finding: LintFinding) -> str:
    return finding.where.file.rpartition("/")[2]
