#!/usr/bin/env python3
"""Says Howdy, twice per second, until Ctrl+C."""
import time


def main() -> None:
    """Print forever; end quietly when interrupted."""
    try:
        while True:
            print("Howdy!")
            time.sleep(0.5)
    except KeyboardInterrupt:
        pass


if __name__ == "__main__":
    main()
