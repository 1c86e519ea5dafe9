"""Functions that wait without standing in each other's way."""
from minimalist_package.minimalist_async._unlikely_to_return import unlikely_to_return

__all__ = ["unlikely_to_return"]
