"""Finds the submissions of a class and what each of them contains, without running or importing any of it.

`find_sources` finds who handed in what, `look` finds what one submission contains, and `lay_out` makes a
new course home from it. Each step can be repeated, and done for each submission separately, in any order
and in any process.
"""

from course.batch.intake.contents import lay_out, look
from course.batch.intake.submission import Found, Part, Placement, SubmissionKind, Upload, Uploads
from course.batch.intake.uploads import find_sources, one_source
from course.home.opening import Limits, Remark

__all__ = [
    "Found",
    "Limits",
    "Part",
    "Placement",
    "Remark",
    "SubmissionKind",
    "Upload",
    "Uploads",
    "find_sources",
    "lay_out",
    "look",
    "one_source",
]
