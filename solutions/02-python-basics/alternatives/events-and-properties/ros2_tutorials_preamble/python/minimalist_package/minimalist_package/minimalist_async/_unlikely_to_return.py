"""The same coroutine, with another source of random numbers."""
import asyncio
from random import Random


async def unlikely_to_return(tag: str, likelihood: float = 0.1) -> float:
    """Try every 0.1 s."""
    source = Random()
    while (number := source.uniform(0.0, 1.0)) >= likelihood:
        print(tag, "drew", number)
        await asyncio.sleep(0.1)
    print(tag, "drew", number, "at last")
    return number
