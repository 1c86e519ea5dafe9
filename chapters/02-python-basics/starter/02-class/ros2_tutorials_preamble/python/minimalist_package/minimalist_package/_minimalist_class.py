"""A small class that has one of everything."""


class MinimalistClass:
    """Stores two numbers, one of them for its own use."""

    # TODO 1: the class attribute attribute_reference, "Hello ".

    def __init__(self, attribute_arg=10.0, private_attribute_arg=20.0):
        """Store both numbers."""
        # TODO 2: store the first in `attribute`, the second in `_private_attribute`.

    def method(self):
        """Return the sum of both numbers."""
        # TODO 3

    # TODO 4: get_private_attribute and set_private_attribute.

    # TODO 5: static_method, which returns "Hello World!" and needs no object.
