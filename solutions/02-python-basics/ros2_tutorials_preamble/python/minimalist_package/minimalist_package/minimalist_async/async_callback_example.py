"""Two tasks at once; each result is reported when it comes."""
import asyncio
from functools import partial

from minimalist_package.minimalist_async import unlikely_to_return


def handle_return_callback(tag: str, future: asyncio.Future) -> None:
    """Report what a task has returned."""
    print(f"The result of {tag} is {future.result():.4f}.")


async def async_main() -> None:
    """Start both tasks, each with a callback, and wait until both have ended."""
    tasks = []
    for tag in ("task1", "task2"):
        task = asyncio.create_task(unlikely_to_return(tag))
        task.add_done_callback(partial(handle_return_callback, tag))
        tasks.append(task)
    await asyncio.wait(tasks)


def main() -> None:
    """Run it all; end quietly when interrupted."""
    try:
        asyncio.run(async_main())
    except KeyboardInterrupt:
        pass


if __name__ == "__main__":
    main()
