"""Mysteries: exercises whose right answers are drawn from a seed, for each learner others."""

from course.grading.mystery.answers import AllOf, Answer, Number, OneOf, Text
from course.grading.mystery.author import Mystery

__all__ = ["AllOf", "Answer", "Mystery", "Number", "OneOf", "Text"]
