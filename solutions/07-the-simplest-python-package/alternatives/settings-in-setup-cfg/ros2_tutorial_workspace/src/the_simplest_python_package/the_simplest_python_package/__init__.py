"""Nothing, and that is the point."""
