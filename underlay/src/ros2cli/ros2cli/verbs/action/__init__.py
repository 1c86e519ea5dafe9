"""The verbs of `ros2 action`."""
