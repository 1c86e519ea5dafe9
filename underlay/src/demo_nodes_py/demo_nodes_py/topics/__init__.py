"""A publisher and a subscriber."""
