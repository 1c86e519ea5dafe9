"""A class of submissions, graded in one go."""
