"""The verbs of `ros2 node`."""
