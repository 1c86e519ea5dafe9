"""Tests of MinimalistClass."""
import unittest

from minimalist_package import MinimalistClass


class TestMinimalistClass(unittest.TestCase):
    """One test for each thing that the class promises."""

    def test_defaults(self) -> None:
        """Both numbers may be left out."""
        MinimalistClass()
        # TODO 1: this test compares nothing yet. Look at both numbers, with
        #   self.assertEqual(what came, what should have come)

    # TODO 2: a test for each row of the table of 02-class.


if __name__ == "__main__":
    unittest.main()
