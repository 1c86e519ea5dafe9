"""Lambdas as callbacks, and a loop that looks whether all is done."""
import asyncio

from minimalist_package.minimalist_async import unlikely_to_return


async def async_main() -> None:
    """Look again every twentieth of a second."""
    tasks = {tag: asyncio.create_task(unlikely_to_return(tag)) for tag in ("task1", "task2")}
    for tag, task in tasks.items():
        task.add_done_callback(lambda future, tag=tag: print(f"{tag} gave {future.result()}"))
    while not all(task.done() for task in tasks.values()):
        await asyncio.sleep(0.05)


def main() -> None:
    """Run it."""
    asyncio.run(async_main())


if __name__ == "__main__":
    main()
