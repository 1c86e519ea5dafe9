"""How fast the rover may drive."""

WIDTH = 0.4  # meters


def safe_speed(distance, stop_at=0.5, full_speed=0.5):
    """Return the speed in m/s."""
    if distance <= stop_at:
        return 0
    if distance - stop_at > full_speed:
        return full_speed
    return distance - stop_at
