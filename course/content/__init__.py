"""Reads a course folder: lessons, exercises, hints, known mistakes. Knows nothing of ROS.

Importing this is quick; YAML and pydantic are imported when a file is read that is not remembered.
"""

from course.content.course import Course, open_course, problems, shared_files
from course.content.layout import answers_file
from course.content.model import Alternative, Chapter, ChapterRef, Edit, Exercise, Lesson, Mistake
from course.content.question import Choice, Known, Question

__all__ = [
    "Alternative",
    "Chapter",
    "ChapterRef",
    "Choice",
    "Course",
    "Edit",
    "Exercise",
    "Known",
    "Lesson",
    "Mistake",
    "Question",
    "answers_file",
    "open_course",
    "problems",
    "shared_files",
]
