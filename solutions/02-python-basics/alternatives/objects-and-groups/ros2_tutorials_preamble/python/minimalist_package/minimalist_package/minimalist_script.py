#!/usr/bin/env python3
from itertools import repeat
from time import sleep


class Greeter:
    """Says a word again and again."""

    period: float = 0.5

    def __init__(self, word: str) -> None:
        self.word = word

    def run(self) -> None:
        """Never ends by itself."""
        for word in repeat(self.word):
            print(word)
            sleep(self.period)


def main() -> int:
    """Ends with 130 on Ctrl+C, as bash does."""
    try:
        Greeter("Howdy!").run()
    except KeyboardInterrupt:
        return 130
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
