"""The verbs of `ros2 pkg`."""
