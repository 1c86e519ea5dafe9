"""Two tasks at once; their results are awaited in order."""
import asyncio

from minimalist_package.minimalist_async import unlikely_to_return


async def async_main() -> None:
    """Start both tasks, then await one after the other."""
    tasks = {tag: asyncio.create_task(unlikely_to_return(tag)) for tag in ("task1", "task2")}
    for tag, task in tasks.items():
        result = await task
        print(f"The result of {tag} is {result:.4f}.")


def main() -> None:
    """Run it all; end quietly when interrupted."""
    try:
        asyncio.run(async_main())
    except KeyboardInterrupt:
        pass


if __name__ == "__main__":
    main()
