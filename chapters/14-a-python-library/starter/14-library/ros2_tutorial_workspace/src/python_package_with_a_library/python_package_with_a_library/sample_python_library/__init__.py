"""What this library offers: whoever uses it imports from here."""

# TODO 3: import SampleClass and sample_function_for_square_of_sum, each from its file.
