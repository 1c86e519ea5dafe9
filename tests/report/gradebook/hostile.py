"""Submissions that try to break out of their place in a report."""

from __future__ import annotations

from course.model.feedback import Feedback, Location
from course.model.gradebook import GradedSubmission, Person
from course.model.result import CheckResult, Outcome, Result, Timing, Verdict
from course.report.gradebook.cleaning import Cleaner
from course.report.gradebook.sheets import Sheet
from tests.report.gradebook.samples import sheet_of

MACHINE = "/srv/grading/machine-7/home"
SECRET = "8675309-seed"
CLEANER = Cleaner({MACHINE: "~", "/srv/grading": "[grading]"}, (SECRET,))

TEXTS = (
    "new\nline\r\nand\rreturn",
    "]]></failure><script>alert(1)</script><!--",
    "</script><img src=x onerror=alert(1)>",
    "=cmd|' /C calc'!A0",
    "+1+1",
    "-2+3",
    "@SUM(1)",
    "\t=1+1",
    "x;=1+1",
    "\ufeff=1+1",
    "\u202egnp.exe\u202c \u2066abc\u2069 \u200fd",
    "nul\x00bell\x07esc\x1b[31mred\x1b[0m\x9b1mc1\x85",
    "\x1b]8;;http://evil.example\x1b\\link\x1b]8;;\x1b\\",
    "half \ud800 and \udfff",
    "\ufffe\uffff\ufdd0",
    "👩🏽‍💻 emoji, Ἕν οἶδα, 你好, العربية",
    "[link](http://evil.example) ![image](http://evil.example/x.png)",
    "http://evil.example www.evil.example mail@evil.example ftp://evil.example",
    "<http://evil.example> <b>bold</b> &copy; &#64;user",
    "@user @org/team #123 GH-7",
    "[a]: http://evil.example",
    "```\n# heading\n~~~",
    "`` ` ``` code `",
    "`a``b` `<b>`<i>`",
    "| a | b |\n|---|---|",
    "# heading",
    "1. list",
    "> quote",
    "$x^2$ *star* **strong** ~~gone~~ _under_ __both__",
    "::error file=a::b%0A::stop-commands::token",
    "ends with a backslash \\",
    "\\",
    f"{MACHINE}/src/a.py {MACHINE}s /srv/gra\x1b[0mding/machine-7/home -I/srv/grading/include",
    f"seed {SECRET}x",
    "y" * 1_000_000,
    "",
    " ",
)


def graded(text: str) -> GradedSubmission:
    """Everything that may come from a submission is `text`."""
    feedback = Feedback(
        text, expected=text, seen=text, where=(Location(text, 3),) * 9, advice=text, details=(text,) * 60
    )
    fault = Feedback(text, details=("Traceback", text), advice=text)
    checks = (
        CheckResult("passes", "It passes", 1, Outcome.PASSED, feedback=Feedback(f"explained {text}")),
        CheckResult("fails", text, 2, Outcome.FAILED, feedback=feedback),
        CheckResult("waits", "It waits", 1, Outcome.SKIPPED, skipped_because=text),
        CheckResult("out", "Elsewhere", 1, Outcome.NOT_APPLICABLE, skipped_because=text),
        CheckResult("extra", "More", 0.1, Outcome.PASSED, bonus=True),
        CheckResult("waits", "It waits", 0.2, Outcome.ERROR, bonus=True, feedback=fault),
    )
    verdict = Verdict.NOT_PASSED
    result = Result("18-publisher", verdict, checks, Timing(1, 2, 3.5), None, text, (text,) * 30)
    return GradedSubmission(Person(text, text), text, (result,), (text,) * 30)


def sheet(text: str) -> Sheet:
    return sheet_of(graded(text), CLEANER)
