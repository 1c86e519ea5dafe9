"""The course home: making and finding it, starter files, backups, and the look at the solution."""

from course.home.answers import keep_answers
from course.home.belongs import remember_course, remembered_course
from course.home.compare import FileDiff, solution_diff
from course.home.create import create_home
from course.home.find import default_home, find_home
from course.home.model import CourseHome, is_home
from course.home.reset import ResetReport, reset
from course.home.starter import begin, starter_files

__all__ = [
    "CourseHome",
    "FileDiff",
    "ResetReport",
    "begin",
    "create_home",
    "default_home",
    "find_home",
    "is_home",
    "keep_answers",
    "remember_course",
    "remembered_course",
    "reset",
    "solution_diff",
    "starter_files",
]
