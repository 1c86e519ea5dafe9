"""A graded class as one page of HTML."""
