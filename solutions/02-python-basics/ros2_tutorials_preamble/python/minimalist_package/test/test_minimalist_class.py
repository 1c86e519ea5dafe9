"""Tests of MinimalistClass."""
import unittest

from minimalist_package import MinimalistClass


class TestMinimalistClass(unittest.TestCase):
    """One test for each thing that the class promises."""

    def setUp(self) -> None:
        """Make a fresh object for each test."""
        self.thing = MinimalistClass(attribute_arg=15.0, private_attribute_arg=35.0)

    def test_reference(self) -> None:
        """You can read the text without an object."""
        self.assertEqual(MinimalistClass.attribute_reference, "Hello ")

    def test_defaults(self) -> None:
        """Both numbers may be left out."""
        self.assertEqual(MinimalistClass().attribute, 10.0)
        self.assertEqual(MinimalistClass().get_private_attribute(), 20.0)

    def test_attribute(self) -> None:
        """The object stores the first number."""
        self.assertEqual(self.thing.attribute, 15.0)

    def test_method(self) -> None:
        """The result is the sum of both numbers."""
        self.assertEqual(self.thing.method(), 50.0)

    def test_private_attribute(self) -> None:
        """The second number can be read and replaced."""
        self.assertEqual(self.thing.get_private_attribute(), 35.0)
        self.thing.set_private_attribute(1.0)
        self.assertEqual(self.thing.get_private_attribute(), 1.0)

    def test_static_method(self) -> None:
        """The greeting needs no object."""
        self.assertEqual(MinimalistClass.static_method(), "Hello World!")


if __name__ == "__main__":
    unittest.main()
