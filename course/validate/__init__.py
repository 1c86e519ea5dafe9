"""Proves a course: what is written about it, and what grading it really does."""
