import unittest

from minimalist_package import MinimalistClass


class TestNumbers(unittest.TestCase):
    def test_sums(self):
        for first, second in ((1.0, 2.0), (-4.0, 0.5)):
            with self.subTest(first=first, second=second):
                thing = MinimalistClass(first, second)
                self.assertAlmostEqual(thing.method(), first + second)
                self.assertIs(thing.attribute, first)

    def test_defaults(self):
        self.assertTrue(MinimalistClass().method() == 30.0)

    def test_private(self):
        thing = MinimalistClass()
        thing.set_private_attribute("anything")
        self.assertEqual(thing.get_private_attribute(), "anything")


class TestTexts(unittest.TestCase):
    def test_texts(self):
        self.assertEqual(MinimalistClass.static_method(), f"{MinimalistClass.attribute_reference}World!")
        self.assertTrue(MinimalistClass.attribute_reference.startswith("Hello"))
