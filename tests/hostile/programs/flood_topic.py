"""Publishes on its topic as fast as it can. SIZE: letters of each message."""


def flood(node):
    from package_with_interfaces.msg import AmazingQuote

    message = AmazingQuote(id=7, quote="x" * SIZE, philosopher_name="x")
    while True:
        node.publisher.publish(message)


beside(flood)
