"""Reads a course folder: lessons, exercises, hints, and known mistakes. Knows nothing about ROS.

Importing this is quick: YAML and pydantic are imported only to read a file that is not in the cache.
"""

from course.content.chapter import Chapter, ChapterRef, Exercise, Lesson
from course.content.course import Course, open_course, problems, shared_files
from course.content.entries import Alternative, Choice, Edit, KnownAnswer, Mistake, Question
from course.content.layout import answers_file

__all__ = [
    "Alternative",
    "Chapter",
    "ChapterRef",
    "Choice",
    "Course",
    "Edit",
    "Exercise",
    "KnownAnswer",
    "Lesson",
    "Mistake",
    "Question",
    "answers_file",
    "open_course",
    "problems",
    "shared_files",
]
