"""A substitution has no text."""


class SubstitutionFailure(RuntimeError):
    """Says which, and why."""
