"""Tests for MinimalistClass."""
import unittest

from minimalist_package import MinimalistClass


class TestMinimalistClass(unittest.TestCase):
    """One test for each thing that the class promises."""

    def test_defaults(self) -> None:
        """Both arguments may be left out."""
        MinimalistClass()
        # TODO 1: this test compares nothing yet. Check both numbers, with
        #   self.assertEqual(result, expected)

    # TODO 2: a test for each row of the table in 02-class.


if __name__ == "__main__":
    unittest.main()
