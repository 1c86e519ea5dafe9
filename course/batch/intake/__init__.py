"""Finds the submissions of a class, and what each of them holds; nothing of them is run or imported.

`find_sources` tells who handed in what, `look` what one submission holds, and `lay_out` makes a fresh
course home of it. Each step can be done again, and for each submission by itself, in any order and
in any process.
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
