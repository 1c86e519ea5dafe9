"""Two tasks, whose callbacks are made in a loop."""
import asyncio
import time

from minimalist_package.minimalist_async import unlikely_to_return


async def async_main() -> None:
    """Keep a count of what still runs."""
    done = asyncio.Event()
    running = {"task1", "task2"}

    def report(task: asyncio.Task) -> None:
        print(f"{task.get_name()} -> {task.result():.3f}")
        running.discard(task.get_name())
        if not running:
            done.set()

    tasks = [asyncio.create_task(unlikely_to_return(tag), name=tag) for tag in sorted(running)]
    for task in tasks:
        task.add_done_callback(report)
    await done.wait()


def main() -> None:
    """Run it, but not at once."""
    print("Good morning.", flush=True)
    time.sleep(0.5)
    asyncio.run(async_main())


if __name__ == "__main__":
    main()
