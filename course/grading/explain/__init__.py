"""Words for what went wrong: looks into the learner's files for the likely cause.

Nothing here decides whether a check passes. Verdicts come from what programs did; these
functions only find the file, the line and the next step to name.
"""
