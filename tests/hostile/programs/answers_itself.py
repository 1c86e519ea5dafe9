"""A second server of the service that the grader offers, in a node with the grader's own name."""


def answer(node):
    import random

    import rclpy
    from package_with_interfaces.srv import WhatIsThePoint

    hidden = [name for name, _ in node.get_node_names_and_namespaces() if name.startswith("_")]
    double = rclpy.create_node(hidden[0] if hidden else "_ros2course")

    def reply(request, response):
        response.point.x = response.point.y = float(random.randrange(1000, 9999))
        return response

    double.create_service(WhatIsThePoint, "/what_is_the_point", reply)
    executor = rclpy.executors.SingleThreadedExecutor()
    executor.add_node(double)
    executor.spin()


beside(answer)
