"""A function for others to use."""

# TODO 2: write sample_function_for_square_of_sum(a, b). It returns the square of
#   a, twice a times b, and the square of b, all added up.
