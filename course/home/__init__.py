"""The course home: making and finding it, starter files, backups, and comparing files with the solution."""

from course.home.compare import FileDiff, solution_diff
from course.home.course_home import (
    CourseHome,
    create_home,
    default_home,
    find_home,
    is_home,
    remember_course,
    remembered_course,
)
from course.home.reset import ResetReport, reset
from course.home.starter import begin, keep_answers, starter_files

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
