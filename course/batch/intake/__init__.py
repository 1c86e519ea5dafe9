"""Finds the submissions of a class, and what each of them holds; nothing of them is run or imported.

`find_sources` tells who handed in what, `look` what one submission holds, and `lay_out` makes a fresh
course home of it. Each step can be done again, and for each submission by itself, in any order and
in any process.
"""

from course.batch.intake.laying import lay_out
from course.batch.intake.look import look
from course.batch.intake.model import Found, Kind, Part, Person, Place, Source, Sources
from course.batch.intake.sources import find_sources, one_source
from course.home.opening import Finding, Limits

__all__ = [
    "Finding",
    "Found",
    "Kind",
    "Limits",
    "Part",
    "Person",
    "Place",
    "Source",
    "Sources",
    "find_sources",
    "lay_out",
    "look",
    "one_source",
]
