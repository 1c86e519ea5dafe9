"""The verbs of `ros2 doctor`."""
