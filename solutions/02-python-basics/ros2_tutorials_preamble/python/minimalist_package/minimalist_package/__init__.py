"""A small package to learn with."""
from minimalist_package._minimalist_class import MinimalistClass

__all__ = ["MinimalistClass"]
