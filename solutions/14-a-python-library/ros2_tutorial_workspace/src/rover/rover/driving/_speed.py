"""How fast the rover may drive."""


def safe_speed(distance: float, stop_at: float = 0.5, full_speed: float = 0.5) -> float:
    """
    Return the speed in m/s for a distance in meters to what is ahead.

    The rover stands at `stop_at` meters or less. Above that, each meter gives 1 m/s,
    up to `full_speed`.
    """
    return min(full_speed, max(0.0, distance - stop_at))
