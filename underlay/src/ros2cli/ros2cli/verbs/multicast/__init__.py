"""The verbs of `ros2 multicast`."""
