"""A coroutine that draws numbers until one is small enough."""


# TODO 1: make it a coroutine that draws a random number every 0.1 s, prints each
#   try with its tag, and returns the first number below the likelihood.
def unlikely_to_return(tag: str, likelihood: float = 0.1) -> float:
    """Draw a number every 0.1 s, and return the first one below the likelihood."""
    return 1.0
