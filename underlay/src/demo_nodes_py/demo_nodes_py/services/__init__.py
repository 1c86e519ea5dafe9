"""A service: its server and two clients."""
