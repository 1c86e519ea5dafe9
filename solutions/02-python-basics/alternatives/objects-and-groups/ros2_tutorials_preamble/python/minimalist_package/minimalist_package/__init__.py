"""All in one file."""


class MinimalistClass:
    """Two numbers."""

    attribute_reference = "Hello "

    def __init__(self, attribute_arg: float = 10.0, private_attribute_arg: float = 20.0) -> None:
        self.attribute, self._private_attribute = attribute_arg, private_attribute_arg

    def method(self) -> float:
        """Return the sum."""
        return self.attribute + self.get_private_attribute()

    def get_private_attribute(self) -> float:
        """Return the second number."""
        return self._private_attribute

    def set_private_attribute(self, new: float) -> None:
        """Replace the second number."""
        vars(self)["_private_attribute"] = new

    @staticmethod
    def static_method() -> str:
        """Return a greeting."""
        return "Hello World!"
