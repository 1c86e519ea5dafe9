"""A coroutine that tries its luck until it has some."""
import asyncio
import random


async def unlikely_to_return(tag: str, likelihood: float = 0.1) -> float:
    """Draw a number every 0.1 s, and return the first one below the likelihood."""
    while True:
        number = random.random()
        if number < likelihood:
            print(f"{tag}: {number:.4f} is below {likelihood}, done.")
            return number
        print(f"{tag}: {number:.4f} is not below {likelihood}, once more.")
        await asyncio.sleep(0.1)
