"""Functions that wait without blocking each other."""
# TODO 2: export unlikely_to_return, as the package exports its class.
