"""Functions that wait without standing in each other's way."""
# TODO 2: export unlikely_to_return, as the package exports its class.
