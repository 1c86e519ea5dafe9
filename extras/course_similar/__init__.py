"""Finds pairs of submissions whose code is alike; nothing of them is run or imported.

Programs are compared as sequences of words of their language, so that comments, spaces and names do not
count. Which pairs to look at is told by winnowing (Schleimer, Wilkerson, Aiken 2003), as the library
`scanoss-winnowing` does it; what those pairs share is then counted word by word. What the course itself
gives, in starters and lessons, counts for nobody.
"""

from course_similar.find import Solutions, Wanted, find_similar

__all__ = ["Solutions", "Wanted", "find_similar"]
