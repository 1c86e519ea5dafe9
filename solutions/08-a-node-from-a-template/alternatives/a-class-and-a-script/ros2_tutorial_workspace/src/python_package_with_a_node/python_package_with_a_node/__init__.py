import sys


class Greeter:
    def __init__(self, name: str) -> None:
        self.name = name

    def greet(self) -> None:
        sys.stdout.write('About to greet.\n')
        sys.stdout.write(f'Hi from {self.name}.\n')


def main() -> int:
    Greeter(__name__).greet()
    return 0
