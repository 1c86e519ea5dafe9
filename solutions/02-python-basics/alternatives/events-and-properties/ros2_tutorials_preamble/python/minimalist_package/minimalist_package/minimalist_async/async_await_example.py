"""Two tasks, and gather."""
import asyncio
import time

from . import unlikely_to_return


async def async_main() -> None:
    """Gather both results, in order."""
    first, second = await asyncio.gather(unlikely_to_return("task1"), unlikely_to_return("task2"))
    print("task1 returned", first)
    print("task2 returned", second)


def main() -> None:
    """Run it, but not at once."""
    print("Good morning.", flush=True)
    time.sleep(0.5)
    asyncio.run(async_main())


if __name__ == "__main__":
    main()
