"""A second node with the grader's own hidden name, which says what only others may. SPEAKS: quotes, too."""


def pretend(node):
    import rclpy
    from package_with_interfaces.msg import AmazingQuote
    from rcl_interfaces.msg import Log

    hidden = [name for name, _ in node.get_node_names_and_namespaces() if name.startswith("_")]
    print("found", hidden, flush=True)
    double = rclpy.create_node(hidden[0] if hidden else "_ros2course")
    logs = double.create_publisher(Log, "/rosout", 10)
    quotes = double.create_publisher(AmazingQuote, "/amazing_quote", 10)
    while True:
        logs.publish(Log(name="amazing_quote_subscriber_node", msg="a quote that nobody sent", level=20))
        if SPEAKS:
            quotes.publish(AmazingQuote(id=1, quote="a quote that nobody sent", philosopher_name="x"))
        time.sleep(0.01)


beside(pretend)
