"""Decides which parts of a verdict may be handed out, and in which form. No other module decides this.

A report goes to learners, into CI logs and onto other people's servers. So escape sequences and controls are
removed (see `course.report.sanitize`), texts are cut, and paths of the grading machine and secrets are
replaced. Three things are never handed out: details of a fault of ours (its traceback, its message), how
the submission was contained, and the explanation of a right answer, which would give the answer away.
"""

from __future__ import annotations

import re
import sys
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path

import course
from course.model import replace
from course.model.feedback import Feedback, Location
from course.model.result import CheckResult, Outcome, Result, Verdict
from course.report import sanitize
from course.report.verdict import PLACES

NAME_LIMIT = 200
# Less than the limit of `sanitize.paragraph`, which some texts go through later: they must not be cut twice.
PROSE_LIMIT = 900
PLACE_LIMIT = 500
REMARKS = 20
# Lines of one file of code.
CODE_LINES = 400
# Characters that are read of one text; far fewer are shown.
_LOOKED_AT = 8 * 1024
# Room for the count at the end of a line that was cut.
_COUNT_ROOM = 40
_HIDDEN = "[hidden]"

# Code points that are not characters (XML forbids them), and invisible characters, which can hide text.
# The joiners U+200C and U+200D stay: emoji and several scripts need them.
_NO_TEXT = re.compile("[\u200b\u2060-\u2064\ufeff\ufdd0-\ufdef\ufff9-\uffff\U000e0000-\U000e007f]")

_OURS = Feedback(
    summary="The course itself has an error here.",
    advice="This is not the learner's failure, and it does not count. The instructor can run it again.",
)
_LACKING = Feedback(
    summary="The machine that graded lacks something that this exercise needs.",
    advice="This is not the learner's failure, and it does not count. The instructor can run it elsewhere.",
)
_FAULTS = {Verdict.OUR_ERROR: _OURS, Verdict.NOT_AVAILABLE: _LACKING}


@dataclass(frozen=True)
class Cleaner:
    """Makes texts safe to hand out.

    places: absolute paths of the grading machine, without a slash at the end, and what is shown instead of
    each ("~").
    secrets: texts that must not appear anywhere, not even inside a word: seeds, tokens.
    """

    places: Mapping[str, str] = field(default_factory=dict)
    secrets: tuple[str, ...] = ()

    def line(self, text: str, limit: int = sanitize.LINE_LIMIT) -> str:
        r"""`text` on one line (a newline shows as \n), at most `limit` characters and a count."""
        return sanitize.cut(self._plain(text).replace("\n", "\\n").strip(), limit, len(text))

    def prose(self, text: str, limit: int = PROSE_LIMIT) -> str:
        """`text` as one paragraph, at most `limit` characters and a count."""
        return sanitize.cut(" ".join(self._plain(text).split()), limit, len(text))

    def evidence(self, lines: Iterable[str]) -> tuple[str, ...]:
        """Lines of a log, each cut to a limit, without the middle of a long list."""
        every = (piece for line in lines for piece in line.replace("\r\n", "\n").rstrip("\n").split("\n"))
        return tuple(sanitize.details(self._lines(every), limit=sanitize.LINE_LIMIT + _COUNT_ROOM))

    def code(self, text: str) -> tuple[str, ...]:
        """The first CODE_LINES lines of a file, with their indentation, each cut to a limit."""
        every = text.split("\n")
        shown = self._lines(every[:CODE_LINES])
        more = len(every) - len(shown)
        return (*shown, f"... {more} more lines ...") if more else tuple(shown)

    def feedback(self, feedback: Feedback) -> Feedback:
        return Feedback(
            summary=self.prose(feedback.summary),
            expected=self._maybe(feedback.expected),
            seen=self._maybe(feedback.seen),
            where=tuple(self._place(place) for place in feedback.where[:PLACES]),
            advice=self._maybe(feedback.advice),
            details=self.evidence(feedback.details),
        )

    def result(self, result: Result) -> Result:
        """The result without what must not be handed out; points and outcomes are unchanged."""
        return replace(
            result,
            exercise=self.line(result.exercise, NAME_LIMIT),
            checks=tuple(self._check(check) for check in result.checks),
            fault=_FAULTS.get(result.verdict) if _is_whole(result) else None,
            containment="",
            notes=self.remarks(result.notes),
        )

    def remarks(self, remarks: Iterable[str]) -> tuple[str, ...]:
        return tuple(self.prose(remark) for remark in tuple(remarks)[:REMARKS])

    def _check(self, check: CheckResult) -> CheckResult:
        return replace(
            check,
            id=self.line(check.id, NAME_LIMIT),
            title=self.prose(check.title),
            feedback=self._told(check),
            skipped_because=self._maybe(check.skipped_because),
        )

    def _told(self, check: CheckResult) -> Feedback | None:
        if check.outcome is Outcome.ERROR:
            return _OURS
        return self.feedback(check.feedback) if check.feedback and check.outcome is Outcome.FAILED else None

    def _lines(self, lines: Iterable[str]) -> list[str]:
        return [sanitize.cut(self._plain(line), sanitize.LINE_LIMIT, len(line)) for line in lines]

    def _place(self, place: Location) -> Location:
        return Location(self.line(place.file, PLACE_LIMIT), place.line)

    def _maybe(self, text: str | None) -> str | None:
        return None if text is None else self.prose(text)

    def _plain(self, text: str) -> str:
        """`text` without escapes, secrets and paths, in this order, so that no escape can hide a path."""
        shown = _NO_TEXT.sub(_visible, sanitize.clean(text[:_LOOKED_AT]))
        for secret in filter(None, self.secrets):
            shown = shown.replace(secret, _HIDDEN)
        return self._paths.sub(lambda found: self.places[found[0]], shown) if self.places else shown

    @cached_property
    def _paths(self) -> re.Pattern[str]:
        """Matches whole paths only: `/tmp/home` is not found in `/tmp/homes` or in `~/tmp/home`."""
        longest_first = sorted(self.places, key=len, reverse=True)
        paths = "|".join(re.escape(path) for path in longest_first)
        return re.compile(rf"(?:(?<![\w.~-])|(?<=-[IL]))(?:{paths})(?![\w-]|\.\w)")


def places_here() -> dict[str, str]:
    """Paths of this machine that any text may contain: the course's own, its Python's, and the home."""
    found = {
        str(Path.home()): "~",
        sys.prefix: "[python]",
        str(Path(course.__file__).parents[1]): "[course]",
    }
    return {path: shown for path, shown in found.items() if path not in ("/", "/usr")}


def _is_whole(result: Result) -> bool:
    """Whether the fault is about the whole exercise, and no check has reported it."""
    return all(check.outcome is not Outcome.ERROR for check in result.checks)


def _visible(match: re.Match[str]) -> str:
    return match[0].encode("unicode_escape").decode("ascii")
