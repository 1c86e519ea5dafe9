"""Makes nodes without end."""


def flood(node):
    import rclpy

    kept = [rclpy.create_node(f"flood_{number}") for number in range(100_000)]
    del kept


beside(flood)
