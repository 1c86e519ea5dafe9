"""Declares parameters without end."""


def flood(node):
    for number in range(100_000):
        node.declare_parameter(f"flood_{number}", "x" * 1000)


beside(flood)
