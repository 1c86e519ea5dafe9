"""What can be found wrong with a course without grading anything: its files, texts, links and commands."""

from course.validate.texts.collect import findings
from course.validate.texts.own_commands import Complaint

__all__ = ["Complaint", "findings"]
