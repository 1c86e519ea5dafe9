"""Finds pairs of submissions with similar code, without running or importing any of it.

Programs are compared as sequences of words of their language, so comments, spaces, and names do not count.
Winnowing (Schleimer, Wilkerson, Aiken 2003), by the library `scanoss-winnowing`, selects the pairs to look
at. Then the words that they share are counted. Code from the course's starters and lessons does not count.
"""

from course_similar.find import Solutions, Wanted, find_similar

__all__ = ["Solutions", "Wanted", "find_similar"]
