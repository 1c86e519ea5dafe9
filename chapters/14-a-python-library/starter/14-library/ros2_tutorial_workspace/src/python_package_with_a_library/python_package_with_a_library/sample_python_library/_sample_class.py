"""A class for others to use."""

# TODO 1: write the class SampleClass. It is made with a name, and its method
#   get_name() returns that name.
