"""A list of tasks, and zip."""
import asyncio

from minimalist_package.minimalist_async import unlikely_to_return


async def async_main() -> None:
    """Start all, then await all."""
    tags = ["task1", "task2"]
    tasks = []
    for tag in tags:
        tasks.append(asyncio.ensure_future(unlikely_to_return(tag=tag)))
    for tag, task in zip(tags, tasks, strict=True):
        print(f"{tag} gave {round(await task, 2)}")


def main() -> None:
    """Run it on a loop of its own."""
    loop = asyncio.new_event_loop()
    try:
        loop.run_until_complete(async_main())
    finally:
        loop.close()


if __name__ == "__main__":
    main()
