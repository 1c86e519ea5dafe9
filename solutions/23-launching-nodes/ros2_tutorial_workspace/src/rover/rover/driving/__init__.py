from rover.driving._speed import safe_speed

__all__ = ['safe_speed']
