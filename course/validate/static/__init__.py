"""Finds errors in a course without grading anything: in its files, texts, links and commands."""
