"""Run two tasks at once, and await their results in order."""
import asyncio


async def async_main() -> None:
    """Start both tasks, then await one after the other."""
    # TODO 3: start unlikely_to_return twice, as task1 and as task2; only then await
    #   the first and report its result, then the second.
    print("async_await_example.py does nothing yet.")


def main() -> None:
    """Run the example, and end cleanly on Ctrl+C."""
    try:
        asyncio.run(async_main())
    except KeyboardInterrupt:
        pass


if __name__ == "__main__":
    main()
