"""A function for others to use."""


def sample_function_for_square_of_sum(a: float, b: float) -> float:
    """Return the square of a + b, as the sum of its three parts."""
    return a**2 + 2 * a * b + b**2
