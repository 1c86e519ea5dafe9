import math


def sample_function_for_square_of_sum(a, b):
    return sum((math.pow(a, 2), math.prod((2.0, a, b)), math.pow(b, 2)))
