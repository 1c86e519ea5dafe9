"""How fast the rover may drive."""


def safe_speed(distance: float, stop_at: float = 0.5, full_speed: float = 0.5) -> float:
    """
    Return the speed in m/s for a distance in meters to what is ahead.

    At `stop_at` meters or less, the rover stops. Each further meter adds 1 m/s,
    up to `full_speed`.
    """
    return min(full_speed, max(0.0, distance - stop_at))
