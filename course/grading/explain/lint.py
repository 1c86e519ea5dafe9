"""What a linter found in the learner's Python files."""

from __future__ import annotations

import re
from dataclasses import dataclass

from course.errors import OurFault
from course.evidence.recording import Recording
from course.feedback import Location

# `pkg/a.py:3:5: N802 Function name ...`, as ruff writes it in its concise form.
UNREADABLE = "invalid-syntax"
_FINDING = re.compile(rf"(?P<file>.+?):(?P<line>\d+):\d+: (?P<rule>[A-Z]+\d+|{UNREADABLE}):? (?P<text>.*)")
_DONE = (0, 1)


@dataclass(frozen=True)
class Finding:
    """One finding. rule: as the linter calls it (`N802`), or `invalid-syntax`."""

    rule: str
    where: Location
    text: str


def findings(recording: Recording, *prefixes: str, name: str = "lint") -> tuple[Finding, ...]:
    """Findings of rules that begin so (`N`, `D1`), in the order of files and lines; all without prefixes.

    Raises OurFault when the linter did not come to its end.
    """
    view = recording.process(name)
    if view.exited is None or view.exited.code not in _DONE:
        raise OurFault(f"the linter failed: {' '.join(view.text[-3:]) or 'it said nothing'}")
    matches = (_FINDING.fullmatch(line) for line in view.text)
    every = (
        Finding(m["rule"], Location(m["file"], int(m["line"])), m["text"].removeprefix("[*] "))
        for m in matches
        if m
    )
    return tuple(one for one in every if not prefixes or one.rule.startswith(prefixes))
