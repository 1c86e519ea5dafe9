"""Explains what went wrong: looks in the learner's files for the likely cause.

Nothing here decides whether a check passes. Verdicts depend on what programs did; these functions only find
the file, the line and the next step to name.
"""
