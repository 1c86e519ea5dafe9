"""A condition that is neither true nor false."""


class InvalidConditionExpressionError(Exception):
    """The text that was given is neither."""
