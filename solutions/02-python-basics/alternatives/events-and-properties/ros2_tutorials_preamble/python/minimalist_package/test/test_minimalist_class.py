import unittest

import minimalist_package


class Everything(unittest.TestCase):
    def test(self):
        thing = minimalist_package.MinimalistClass()
        assert (thing.attribute, thing.get_private_attribute(), thing.method()) == (10.0, 20.0, 30.0)
        other = minimalist_package.MinimalistClass(attribute_arg=1.0, private_attribute_arg=5.0)
        assert (other.attribute, other.get_private_attribute(), other.method()) == (1.0, 5.0, 6.0)
        other.set_private_attribute(7.0)
        assert other.get_private_attribute() == 7.0
        assert other.static_method() == "Hello World!"
        assert other.attribute_reference == "Hello "
