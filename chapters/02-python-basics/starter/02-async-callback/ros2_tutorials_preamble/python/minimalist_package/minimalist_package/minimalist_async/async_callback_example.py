"""Run two tasks at once, and report each result as soon as it is ready."""
import asyncio


# TODO 1: handle_return_callback(tag, task) reports task.result().


async def async_main() -> None:
    """Start both tasks, each with a callback, and wait until both have ended."""
    # TODO 2: start task1 and task2, and add the callback to each.
    # TODO 3: wait here until both have ended.
    print("async_callback_example.py does nothing yet.")


def main() -> None:
    """Run the example, and end cleanly on Ctrl+C."""
    try:
        asyncio.run(async_main())
    except KeyboardInterrupt:
        pass


if __name__ == "__main__":
    main()
