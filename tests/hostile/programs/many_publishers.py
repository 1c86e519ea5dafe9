"""PUBLISHERS on the node's own topic."""


def multiply(node):
    from package_with_interfaces.msg import AmazingQuote

    node.others = [node.create_publisher(AmazingQuote, "/amazing_quote", 10) for _ in range(PUBLISHERS)]


beside(multiply)
