"""How `ros2 run` starts an executable and looks after it."""
