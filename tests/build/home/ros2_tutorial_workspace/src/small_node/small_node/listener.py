"""A program that only says its name."""


def main():
    print("listener here")
