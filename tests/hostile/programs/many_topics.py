"""Makes topics without end."""


def flood(node):
    from package_with_interfaces.msg import AmazingQuote

    for number in range(100_000):
        node.create_publisher(AmazingQuote, f"/flood_{number}", 1)


beside(flood)
