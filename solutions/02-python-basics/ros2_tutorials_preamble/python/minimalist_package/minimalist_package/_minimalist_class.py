"""A small class with an example of each kind of member."""


class MinimalistClass:
    """Stores two numbers. The second one is private."""

    attribute_reference: str = "Hello "

    def __init__(self, attribute_arg: float = 10.0, private_attribute_arg: float = 20.0) -> None:
        """Store both numbers."""
        self.attribute: float = attribute_arg
        self._private_attribute: float = private_attribute_arg

    def method(self) -> float:
        """Return the sum of both numbers."""
        return self.attribute + self._private_attribute

    def get_private_attribute(self) -> float:
        """Return the private number."""
        return self._private_attribute

    def set_private_attribute(self, private_attribute_arg: float) -> None:
        """Replace the private number."""
        self._private_attribute = private_attribute_arg

    @staticmethod
    def static_method() -> str:
        """Return a greeting. This needs no object."""
        return "Hello World!"
