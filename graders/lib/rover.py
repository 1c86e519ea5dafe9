"""What the rover's chapters share: its names, and how fast it may drive."""

from __future__ import annotations

PACKAGE = "rover"
LIBRARY = f"{PACKAGE}.driving"
RANGE, RANGE_TYPE = "/rover/range", "sensor_msgs/msg/Range"
COMMAND, COMMAND_TYPE = "/rover/cmd_vel", "geometry_msgs/msg/Twist"
STOP, STOP_TYPE = "/rover/stop", "std_srvs/srv/SetBool"
SENSOR, CONTROLLER = "range_sensor", "controller"
STOP_AT = FULL_SPEED = 0.5
CLOSE = 1e-3  # m or m/s; a distance travels as a float32


def safe_speed(distance: float, stop_at: float = STOP_AT, full_speed: float = FULL_SPEED) -> float:
    """The speed that the task of chapter 14 asks for (m/s), for distances in m."""
    return min(full_speed, max(0.0, distance - stop_at))
