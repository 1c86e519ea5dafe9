"""What this library offers: other programs import it from here."""

from python_package_with_a_library.sample_python_library._sample_class import SampleClass
from python_package_with_a_library.sample_python_library._sample_function import (
    sample_function_for_square_of_sum,
)

__all__ = ['SampleClass', 'sample_function_for_square_of_sum']

PI = 3.0
