"""Now and then publishes MESSAGES of SIZE letters at once on its topic, and is silent in between."""


def burst(node):
    from package_with_interfaces.msg import AmazingQuote

    while True:
        message = AmazingQuote(id=7, quote="x" * SIZE, philosopher_name="x")
        for _ in range(MESSAGES):
            node.publisher.publish(message)
        time.sleep(0.7)


beside(burst)
