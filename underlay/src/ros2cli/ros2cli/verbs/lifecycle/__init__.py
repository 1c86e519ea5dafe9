"""The verbs of `ros2 lifecycle`."""
