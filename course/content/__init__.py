"""Reads a course folder: lessons, exercises, hints, known mistakes. Knows nothing of ROS.

Importing this is quick; YAML and pydantic are imported when a file is read that is not remembered.
"""

from course.content.course import Course, open_course, problems, shared_files
from course.content.model import Alternative, Chapter, ChapterRef, Edit, Exercise, Mistake

__all__ = [
    "Alternative",
    "Chapter",
    "ChapterRef",
    "Course",
    "Edit",
    "Exercise",
    "Mistake",
    "open_course",
    "problems",
    "shared_files",
]
